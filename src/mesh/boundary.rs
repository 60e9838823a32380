//! The boundary points of a panel: its outline and holes, divided.

use super::divide::{Division, least_parts};
use super::geometry::{self, Point};
use crate::pattern::{Edge, Panel};
use crate::seam::division_count;
use std::ops::Range;

/// A panel's boundary as closed rings of points; the outline first, then the holes.
#[derive(Debug)]
pub(super) struct Boundary {
    /// \[m\]
    pub(super) points: Vec<Point>,
    /// The points of each ring.
    pub(super) rings: Vec<Range<usize>>,
    /// The point at which each edge of the outline begins.
    pub(super) edge_starts: Vec<usize>,
}

impl Boundary {
    /// Divides a panel's outline as told and its holes by `edge_length` \[m\].
    pub(super) fn new(panel: &Panel, divisions: &[Division], edge_length: f64) -> Self {
        let mut boundary = Self {
            points: vec![],
            rings: vec![],
            edge_starts: vec![],
        };
        boundary.edge_starts = boundary.add_ring(&panel.edges, divisions);
        for hole in &panel.holes {
            let least = least_parts(hole.edges.len());
            let divide = |edge: &Edge| {
                let length = geometry::length(&edge.points);
                Division::whole(
                    length,
                    division_count(length, length, edge_length).max(least),
                )
            };
            let divisions: Vec<_> = hole.edges.iter().map(divide).collect();
            boundary.add_ring(&hole.edges, &divisions);
        }
        boundary
    }

    /// Mesh edges along the boundary, each as two point indices.
    pub(super) fn segments(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.rings.iter().flat_map(|ring| {
            let (first, last) = (ring.start, ring.end - 1);
            (first..last).map(|i| [i, i + 1]).chain([[last, first]])
        })
    }

    /// The point at the beginning of a part of an edge of the outline; one past the last part is the edge's end.
    pub(super) fn vertex(&self, edge: usize, part: usize) -> usize {
        let point = self.edge_starts[edge] + part;
        if point == self.rings[0].end { 0 } else { point }
    }

    fn add_ring(&mut self, edges: &[Edge], divisions: &[Division]) -> Vec<usize> {
        let first = self.points.len();
        let mut starts = Vec::with_capacity(edges.len());
        for (edge, division) in edges.iter().zip(divisions) {
            starts.push(self.points.len());
            let at = division.starts().map(|fraction| fraction * division.length);
            self.points.extend(geometry::resample(&edge.points, at));
        }
        self.rings.push(first..self.points.len());
        starts
    }
}
