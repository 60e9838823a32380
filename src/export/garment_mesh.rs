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
}
