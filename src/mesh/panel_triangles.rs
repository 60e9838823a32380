//! The triangles of one panel, before the panels are put together.

use super::geometry;
use crate::pattern::point::Point2;

/// Triangles of one panel in its own numbering: the points of the boundary come first.
#[derive(Clone)]
pub(super) struct PanelTriangles {
    /// \[m\]
    pub(super) points: Vec<Point2>,
    /// Point2 indices, counter-clockwise.
    pub(super) triangles: Vec<[usize; 3]>,
}

impl PanelTriangles {
    /// Returns the smallest angle of a triangle of these points \[rad\].
    pub(super) fn smallest_angle(&self, triangle: [usize; 3]) -> f64 {
        geometry::smallest_angle(triangle.map(|v| self.points[v]))
    }
}
