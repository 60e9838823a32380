//! From a drape to bytes: GLB, OBJ, JSON; from a pattern to a drawing; from measurements to a plot.
//!
//! In all of them the first texture coordinates are the pattern coordinates in metres, v up, so that a fabric
//! of known repeat can be laid on to scale.

mod glb;
mod normals;
mod obj;
mod plot;
mod svg;

pub use glb::{avatar_glb, garment_with_avatar_glb, glb};
pub use obj::obj;
pub use plot::{Plot, PlotPoint, PlotSeries};
pub use svg::drawing_svg;

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
    /// \[m\], y up; `#V`.
    pub positions: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\]; `#V`.
    pub uv: Vec<[f64; 2]>,
    /// Counter-clockwise seen from outside; `#T`.
    pub triangles: Vec<[u32; 3]>,
}
