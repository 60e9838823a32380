//! Options of an import.

use super::text_encoding::TextEncoding;
use super::units::Units;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Statements of the caller about a file, for what the file does not say.
#[derive(Clone, Debug, Default)]
pub struct ImportOptions {
    /// Name of the file, for a pattern that carries none.
    pub name: Option<String>,
    /// Unit of the coordinates, overriding what the file says.
    pub units: Option<Units>,
    /// Encoding of the texts of a DXF, overriding what the file says.
    pub encoding: Option<TextEncoding>,
    /// Size to import from a graded file; the sample size if absent.
    pub size: Option<String>,
    /// Order in which the three angles of a `GarmentCode` panel make up its rotation.
    pub rotation_order: RotationOrder,
}

/// Order in which three angles about x, y and z make up a rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum RotationOrder {
    /// R = Rx Ry Rz, as `GarmentCode` writes.
    #[default]
    Xyz,
    /// R = Rz Ry Rx, as the simulator of `GarmentCode` reads.
    Zyx,
}
