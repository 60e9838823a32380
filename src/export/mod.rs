//! From a drape to bytes: GLB, OBJ, JSON, a picture; from a pattern to a drawing; from measurements
//! to a plot.
//!
//! In all of them the first texture coordinates are the pattern coordinates in meters, v up, so
//! that a fabric of known repeat can be laid on to scale.

mod garment_mesh;
mod glb;
mod normals;
mod obj;
mod picture;
mod plot;
mod svg;
mod xml;

pub use garment_mesh::{DrapedPanel, GarmentMesh};
pub use glb::{avatar_glb, garment_with_avatar_glb, glb};
pub use obj::obj;
pub use picture::{Picture, PictureSubject, View, picture, picture_sheet};
pub use plot::{Plot, PlotPoint, PlotSeries};
pub use svg::drawing_svg;
