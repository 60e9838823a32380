//! First positions of the points inside a panel: an equilateral lattice along its longest edge.

use super::boundary::Boundary;
use crate::pattern::point::{Point2, distance, sub};

use super::segment_grid::SegmentGrid;

/// Distance of the rows of an equilateral lattice of side 1.
pub(super) const ROW: f64 = 0.866_025_403_784_438_6;

/// Least lattice side, as a share of the mesh edge length: a longest edge divided more finely
/// (because it is gathered) does not make the inside as fine.
const LEAST_SIDE: f64 = 0.8;

/// Lattice points inside the boundary that keep clear of it.
///
/// The lattice turns and moves with the panel, so that a panel drawn elsewhere gets the same mesh.
pub(super) fn points(
    boundary: &Boundary,
    clearance: &SegmentGrid,
    edge_length: f64,
) -> Vec<Point2> {
    let frame = LatticeFrame::along_longest_edge(boundary);
    let side = frame.spacing.clamp(LEAST_SIDE * edge_length, edge_length);
    let local: Vec<_> = boundary.points.iter().map(|&p| frame.enter(p)).collect();
    let mut points = vec![];
    for (row, crossings) in rows(boundary, &local, side * ROW) {
        let shift = if row.rem_euclid(2) == 1 { 0.5 } else { 0.0 };
        for span in crossings.chunks_exact(2) {
            let mut x = ((span[0] / side - shift).ceil() + shift) * side;
            while x < span[1] {
                let point = frame.leave([x, height(row) * side * ROW]);
                if clearance.is_clear(point, 1.0) {
                    points.push(point);
                }
                x += side;
            }
        }
    }
    points
}

#[expect(
    clippy::cast_precision_loss,
    reason = "row numbers are bounded by Limits"
)]
fn height(row: i64) -> f64 {
    row as f64
}

/// Returns the crossings of each lattice row with the boundary, from left to right.
fn rows(boundary: &Boundary, local: &[Point2], step: f64) -> Vec<(i64, Vec<f64>)> {
    let mut hits = vec![];
    for [a, b] in boundary.ring_segments() {
        let (a, b) = (local[a], local[b]);
        let (low, high) = if a[1] < b[1] { (a, b) } else { (b, a) };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "panels are meters, rows millimeters"
        )]
        let (first, end) = (
            (low[1] / step).ceil() as i64,
            (high[1] / step).ceil() as i64,
        );
        for row in first..end {
            let share = (height(row) * step - low[1]) / (high[1] - low[1]);
            hits.push((row, low[0] + (high[0] - low[0]) * share));
        }
    }
    hits.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let rows = hits.chunk_by(|a, b| a.0 == b.0);
    rows.map(|row| (row[0].0, row.iter().map(|hit| hit.1).collect()))
        .collect()
}

/// Coordinates along and across the longest edge.
struct LatticeFrame {
    origin: Point2,
    along: Point2,
    /// Mean distance of the points on that edge \[m\].
    spacing: f64,
}

impl LatticeFrame {
    fn along_longest_edge(boundary: &Boundary) -> Self {
        let ring = boundary.rings[0].clone();
        let starts = &boundary.edge_starts;
        let ends = starts[1..].iter().copied().chain([ring.end]);
        let mut best = Self {
            origin: boundary.points[0],
            along: [1.0, 0.0],
            spacing: 0.0,
        };
        let mut longest = 0.0;
        for (&start, end) in starts.iter().zip(ends) {
            let from = boundary.points[start];
            let to = boundary.points[if end == ring.end { ring.start } else { end }];
            let chord = distance(from, to);
            // The first of equally long ones, whatever rounding says.
            if chord > longest * (1.0 + 1e-9) {
                longest = chord;
                let [x, y] = sub(to, from);
                #[expect(clippy::cast_precision_loss, reason = "counts are bounded by Limits")]
                let spacing = chord / (end - start) as f64;
                best = Self {
                    origin: from,
                    along: [x / chord, y / chord],
                    spacing,
                };
            }
        }
        best
    }

    fn enter(&self, p: Point2) -> Point2 {
        let [x, y] = sub(p, self.origin);
        let [c, s] = self.along;
        [x * c + y * s, y * c - x * s]
    }

    fn leave(&self, [x, y]: Point2) -> Point2 {
        let [c, s] = self.along;
        [
            self.origin[0] + x * c - y * s,
            self.origin[1] + x * s + y * c,
        ]
    }
}
