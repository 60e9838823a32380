//! Options of an import.

use super::grading::GradeTable;
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
    /// Grade rules of the file's points, by which other sizes than its own are made.
    pub grading: Option<GradeTable>,
    /// Reading of outlines that lie in others.
    pub outlines: Outlines,
    /// Reading of notches that are drawn into an outline.
    pub notches: DrawnNotches,
    /// Reading of darts that are drawn as lines.
    pub darts: DrawnDarts,
    /// Folds about which half pieces are unfolded.
    pub unfold: Unfold,
    /// True to refuse a file with a piece that cannot be read or must be mended; else such a piece
    /// is left out or mended.
    pub strict: bool,
    /// Order in which the three angles of a `GarmentCode` panel make up its rotation.
    pub rotation_order: RotationOrder,
}

/// Reading of outlines that lie in others, where the layers of a drawing do not tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Outlines {
    /// By their course: frames, sizes, sew lines, holes and drawn lines.
    #[default]
    Auto,
    /// Those beside the outline are sew lines; no frames and no sizes.
    Allowance,
    /// Those one in the other are the sizes of a piece.
    Sizes,
    /// They are holes.
    Holes,
    /// They are lines drawn on the cloth.
    Lines,
    /// They are pieces, and an outline about others is the frame of the sheet.
    Pieces,
}

/// Reading of notches that are drawn into an outline, up to 12 mm deep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum DrawnNotches {
    /// They are marks, and the outline runs straight on.
    #[default]
    Marks,
    /// They are the course of the cloth.
    Cloth,
}

/// Reading of darts that are drawn as lines inside an outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum DrawnDarts {
    /// They are cut into the panel, to be sewn.
    #[default]
    Cut,
    /// They are lines drawn on the cloth.
    Lines,
}

/// Folds about which half pieces are unfolded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Unfold {
    /// All that the file states.
    #[default]
    All,
    /// None: pieces stay as they are drawn.
    None,
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
