//! From the bytes of a pattern file to a [`Pattern`]: panels with outlines, corners, edges, notches and grain, in metres.

mod allowance;
mod assemble;
mod check;
mod copies;
mod curve;
mod dxf;
mod garmentcode;
mod ids;
mod panel;
mod placement;
pub(crate) mod point;
pub(crate) mod polyline;
mod seam_pair;
mod spline;

pub use copies::MIRROR;
pub use panel::{Corner, Edge, Face, Grain, Hole, Notch, NotchKind, Panel, Quantity};
pub use placement::{Placement, PlacementAnchor, Wrap};
pub use point::Point2;
pub use seam_pair::{Direction, Match, OutlineRun, Place, SeamPair, Side};

use crate::config::Limits;
use crate::fault::{Faults, Warning};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;
use uuid::Uuid;

/// All flat parts of a garment, as one file holds them. Lengths in metres, y up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Pattern {
    /// Given by the service when the pattern is stored.
    #[serde(default)]
    pub id: Option<Uuid>,
    /// Name of the style, from the file or its name.
    pub name: String,
    /// What kind of file it came from and how that was read.
    pub source: Source,
    /// The panels, in the file's order.
    pub panels: Vec<Panel>,
    /// Seams that the file itself states (GarmentCode), else empty.
    #[serde(default)]
    pub seams: Vec<SeamPair>,
    /// Placements that the file itself states (GarmentCode), by panel id, else empty.
    #[serde(default)]
    pub placements: BTreeMap<String, Placement>,
    /// What a user should know about the import.
    #[serde(default)]
    pub warnings: Vec<Warning>,
}

impl Pattern {
    /// Position of the panel named `id` in `panels`.
    pub fn panel_index(&self, id: &str) -> Option<usize> {
        self.panels.iter().position(|panel| panel.id == id)
    }
}

/// What kind of file a pattern came from and how it was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// The dialect.
    pub format: PatternFormat,
    /// Name of the unit that coordinates were read in: `mm`, `cm`, `m` or `inch`.
    pub units: String,
    /// Metres per drawing unit.
    pub scale_to_m: f64,
    /// The size that was imported, where the file is graded.
    #[serde(default)]
    pub sample_size: Option<String>,
    /// All sizes in the file.
    #[serde(default)]
    pub sizes: Vec<String>,
    /// Whether outlines include seam allowance.
    pub allowance: Allowance,
}

/// The dialect of a pattern file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "kebab-case")]
#[schema(as = Format)]
pub enum PatternFormat {
    /// ANSI/AAMA-292 blocks.
    DxfAama,
    /// ASTM D6673 blocks.
    DxfAstm,
    /// A drawing of a general CAD.
    Dxf,
    /// GarmentCode specification JSON.
    #[serde(rename = "garmentcode")]
    GarmentCode,
}

/// Whether outlines include seam allowance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Allowance {
    /// Outlines are sew lines.
    None,
    /// The file does not say.
    Unknown,
    /// The file has sew lines, and they became the outlines.
    SewLine,
}

/// What a caller may say about a file that the file does not.
#[derive(Clone, Debug, Default)]
pub struct ImportOptions {
    /// Name of the file, for a pattern that carries none.
    pub name: Option<String>,
    /// Unit of the coordinates, overriding what the file says.
    pub units: Option<Units>,
    /// Size to import from a graded file; the sample size if absent.
    pub size: Option<String>,
    /// How the three angles of a `GarmentCode` panel make up its rotation.
    pub rotation_order: RotationOrder,
}

/// How three angles about x, y and z make up a rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum RotationOrder {
    /// R = Rx Ry Rz, as `GarmentCode` writes.
    #[default]
    Xyz,
    /// R = Rz Ry Rx, as the simulator of `GarmentCode` reads.
    Zyx,
}

/// A unit of length in drawings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// Millimetres.
    Mm,
    /// Centimetres.
    Cm,
    /// Metres.
    M,
    /// Inches of 25.4 mm.
    Inch,
}

/// Reads a pattern from the bytes of a DXF file or of a `GarmentCode` specification (JSON).
///
/// # Errors
/// Every fault that keeps the file from being read, each with the line or JSON Pointer it is about.
pub fn import(bytes: &[u8], options: &ImportOptions, limits: &Limits) -> Result<Pattern, Faults> {
    if garmentcode::is_json(bytes) {
        garmentcode::import(bytes, options, limits)
    } else {
        dxf::import(bytes, options, limits)
    }
}

/// Checks a pattern that came as JSON and recomputes what is derived in it (lengths, areas).
///
/// # Errors
/// Every place where it is not a pattern: open, crossing or anticlockwise outlines, numbers that are not finite, double ids.
pub fn checked(pattern: Pattern, limits: &Limits) -> Result<Pattern, Faults> {
    check::checked(pattern, limits)
}
