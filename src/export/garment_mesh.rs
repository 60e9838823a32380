//! The shape of a garment: the JSON format, and what the other formats are written from.

use crate::pattern::Point2;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A garment's shape, panel by panel: `mesh.json`, and what the other formats are written from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct GarmentMesh {
    /// One part for each panel, in the pattern's order.
    pub panels: Vec<DrapedPanel>,
}

/// The shape of one panel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[schema(as = PanelMesh)]
pub struct DrapedPanel {
    /// Id of the panel.
    pub panel: String,
    /// Id of its fabric: the name of the material.
    pub fabric: String,
    /// Positions \[m\], y up; `#V`.
    pub positions: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\]; `#V`.
    #[schema(value_type = Vec<[f64; 2]>)]
    pub uv: Vec<Point2>,
    /// Triangles, counter-clockwise seen from outside; `#T`.
    pub triangles: Vec<[u32; 3]>,
    /// Maps that were asked for.
    #[serde(default, skip_serializing_if = "VertexMaps::is_empty")]
    pub maps: VertexMaps,
}

/// Maps on the vertices of a panel: each `#V`, or empty where it was not asked for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(default)]
pub struct VertexMaps {
    /// Length along the warp over that on the pattern, less 1.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub strain_warp: Vec<f64>,
    /// The same along the weft.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub strain_weft: Vec<f64>,
    /// Largest share of the extension that the fabric gives in wear, over all directions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub strain_share: Vec<f64>,
    /// Pressure of the body on the cloth \[kPa\].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pressure_kpa: Vec<f64>,
    /// Gap to the body, 0 in contact; within the body the depth, negative \[mm\].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gap_mm: Vec<f64>,
}

impl VertexMaps {
    /// Returns the maps that are there, by name.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, &[f64])> {
        let all = [
            ("strain_warp", &*self.strain_warp),
            ("strain_weft", &*self.strain_weft),
            ("strain_share", &*self.strain_share),
            ("pressure_kpa", &*self.pressure_kpa),
            ("gap_mm", &*self.gap_mm),
        ];
        all.into_iter().filter(|(_, values)| !values.is_empty())
    }

    /// Returns true if there are none.
    pub fn is_empty(&self) -> bool {
        self.named().next().is_none()
    }
}
