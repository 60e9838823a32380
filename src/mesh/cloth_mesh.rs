//! The mesh of a garment: triangles of all panels, with the stitches between them.

use super::geometry;
use crate::pattern::point::Point2;
use std::ops::Range;

/// All panels of a garment as triangles, with the stitches between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClothMesh {
    /// Rest position of each vertex in its panel's pattern coordinates \[m\]; `#V`.
    pub uv: Vec<Point2>,
    /// Vertex indices, counter-clockwise in pattern coordinates; `#T`.
    pub triangles: Vec<[usize; 3]>,
    /// The part of the mesh that each panel is, in the pattern's order.
    pub panels: Vec<PanelRange>,
    /// Point2 pairs that are sewn together; grouped by seam, in order along it. No vertex pair
    /// occurs twice.
    pub stitches: Vec<Stitch>,
}

/// The part of a mesh that one panel is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PanelRange {
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// The vertex at each corner of the panel.
    pub corners: Vec<usize>,
}

/// One point pair of a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stitch {
    /// Index of the seam.
    pub seam: usize,
    /// Order of sewing, from the seam.
    pub stage: u32,
    /// Vertex on side A.
    pub a: usize,
    /// Vertex on side B.
    pub b: usize,
}

impl ClothMesh {
    /// Area of all triangles at rest \[m²\].
    pub fn area(&self) -> f64 {
        let area = |t: &[usize; 3]| {
            let [p, q, r] = t.map(|v| self.uv[v]);
            geometry::area(p, q, r).abs()
        };
        self.triangles.iter().map(area).sum()
    }

    /// Returns the index of the panel that a vertex belongs to.
    pub fn panel_of_vertex(&self, vertex: usize) -> usize {
        self.panels
            .partition_point(|range| range.vertices.end <= vertex)
    }

    /// Returns the index of the panel that a triangle belongs to.
    pub fn panel_of_triangle(&self, triangle: usize) -> usize {
        self.panels
            .partition_point(|range| range.triangles.end <= triangle)
    }

    /// Edge length of the equilateral triangle that has the mean area of the triangles \[m\].
    pub fn mean_edge(&self) -> f64 {
        let mean = self.area() / self.triangles.len().max(1) as f64;
        (mean * 4.0 / 3.0_f64.sqrt()).sqrt()
    }
}

/// The same triangle, begun at its lowest vertex.
pub(super) fn smallest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
