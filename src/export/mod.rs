//! From a drape to bytes: GLB, OBJ, PLY, JSON, a picture; from a pattern to a drawing and to the
//! files of other programs; from measurements to a plot.
//!
//! In all of them the first texture coordinates are the pattern coordinates in meters, v up, so
//! that a fabric of known repeat can be laid on to scale.

mod aama;
mod counted;
mod garment_mesh;
mod garmentcode;
mod glb;
mod normals;
mod obj;
mod pattern_file;
mod picture;
mod plot;
mod ply;
mod summary;
mod svg;
mod xml;

pub use aama::pattern_dxf;
pub use garment_mesh::{DrapedPanel, GarmentMesh, VertexMaps};
pub use garmentcode::pattern_specification;
pub use glb::{avatar_glb, garment_with_avatar_glb, glb};
pub use obj::obj;
pub use pattern_file::PatternFile;
pub use picture::{Picture, PictureSubject, View, picture, picture_sheet};
pub use plot::{Plot, PlotPoint, PlotSeries};
pub use ply::ply;
pub use summary::{pattern_summary, with_option_names};
pub use svg::drawing_svg;
