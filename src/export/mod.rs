//! From a drape to bytes: GLB, OBJ, JSON.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A garment's shape, panel by panel: `mesh.json`, and what the other formats are written from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct GarmentMesh {
    /// One part for each panel, in the pattern's order.
    pub panels: Vec<PanelMesh>,
}

/// The shape of one panel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct PanelMesh {
    /// Id of the panel.
    pub panel: String,
    /// Id of its fabric: the name of the material.
    pub fabric: String,
    /// \[m\], y up; `#V`.
    pub positions: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\]; `#V`.
    pub uv: Vec<[f64; 2]>,
    /// Counter-clockwise seen from outside; `#T`.
    pub triangles: Vec<[u32; 3]>,
}

/// Binary glTF 2.0.
pub fn glb(_mesh: &GarmentMesh) -> Vec<u8> {
    Vec::new()
}

/// Wavefront OBJ, one group per panel.
pub fn obj(_mesh: &GarmentMesh) -> String {
    String::new()
}
