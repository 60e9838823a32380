//! Panels as a [`ClothMesh`]: boundary points equal on both sides of a seam, constrained Delaunay
//! triangles inside.
//!
//! [`triangulate`] calls, in this order: `divide` (equal parts along matched edges), `boundary`
//! (points of outlines, holes and sewn lines), `lattice` (first points inside), `delaunay` and
//! `improve` (triangles), `morton` (numbering) and `stitch`. [`coarser`] thins a mesh for a
//! hierarchy, [`Locator`] finds the triangle of a point.

mod boundary;
mod check;
mod cloth_mesh;
mod coarser;
mod delaunay;
mod divide;
mod geometry;
mod improve;
mod joint;
mod lattice;
mod locate;
mod morton;
mod panel_division;
mod panel_triangles;
mod segment_grid;
mod slots;
mod stitch;
mod triangulate;

pub use cloth_mesh::{ClothMesh, PanelRange, Stitch};
pub use coarser::{CoarserMesh, coarser};
pub use locate::Locator;
pub use triangulate::triangulate;
