//! A pattern: the flat parts of a garment, with the file that they came from.

use super::panel::Panel;
use super::placement::Placement;
use super::seam_pair::SeamPair;
use crate::fault::Warning;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;
use uuid::Uuid;

/// All flat parts of a garment, as one file holds them. Lengths in meters, y up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Pattern {
    /// Given by the service when the pattern is stored.
    #[serde(default)]
    pub id: Option<Uuid>,
    /// Name of the style, from the file or its name.
    pub name: String,
    /// The file it came from, and how that was read.
    pub source: Source,
    /// The panels, in the file's order.
    pub panels: Vec<Panel>,
    /// Seams that the file itself states (GarmentCode), else empty.
    #[serde(default)]
    pub seams: Vec<SeamPair>,
    /// Placements that the file itself states (GarmentCode), by panel id, else empty.
    #[serde(default)]
    pub placements: BTreeMap<String, Placement>,
    /// Warnings of the import.
    #[serde(default)]
    pub warnings: Vec<Warning>,
}

impl Pattern {
    /// Returns the position of the panel named `id` in `panels`.
    pub fn panel_index(&self, id: &str) -> Option<usize> {
        self.panels.iter().position(|panel| panel.id == id)
    }
}

/// The file that a pattern came from, and how it was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// The dialect.
    pub format: PatternFormat,
    /// Name of the unit that coordinates were read in: `mm`, `cm`, `m` or `inch`.
    pub units: String,
    /// Meters per drawing unit.
    pub scale_to_m: f64,
    /// The size that was imported, where the file is graded.
    #[serde(default)]
    pub sample_size: Option<String>,
    /// All sizes in the file.
    #[serde(default)]
    pub sizes: Vec<String>,
    /// Seam allowance in the outlines.
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

/// Seam allowance in the outlines of a file.
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
