//! Distance of points to a boundary, by a grid of its segments.

use super::boundary::Boundary;
use super::geometry::share_along;
use crate::pattern::point::{Point2, distance, lerp};
use std::collections::BTreeMap;

/// Segments of a boundary in cells of the distance that points are to keep from it.
pub(super) struct SegmentGrid {
    reach: f64,
    cells: BTreeMap<[i64; 2], Vec<[Point2; 2]>>,
}

impl SegmentGrid {
    pub(super) fn new(boundary: &Boundary, reach: f64) -> Self {
        let mut grid = Self {
            reach,
            cells: BTreeMap::new(),
        };
        for [a, b] in boundary.segments() {
            let segment = [boundary.points[a], boundary.points[b]];
            for cell in grid.cells_near(segment) {
                grid.cells.entry(cell).or_default().push(segment);
            }
        }
        grid
    }

    /// The distance that it was made for \[m\].
    pub(super) fn reach(&self) -> f64 {
        self.reach
    }

    /// Returns true if no part of the boundary is closer to `p` than `share` of the reach (0 to 1).
    pub(super) fn is_clear(&self, p: Point2, share: f64) -> bool {
        let segments = self.cells.get(&p.map(|x| self.cell(x)));
        let near = |s: &[Point2; 2]| distance_to_segment(p, *s) < share * self.reach;
        !segments.is_some_and(|segments| segments.iter().any(near))
    }

    fn cells_near(&self, [a, b]: [Point2; 2]) -> impl Iterator<Item = [i64; 2]> + use<> {
        let low = [0, 1].map(|k| self.cell(a[k].min(b[k]) - self.reach));
        let high = [0, 1].map(|k| self.cell(a[k].max(b[k]) + self.reach));
        (low[0]..=high[0]).flat_map(move |i| (low[1]..=high[1]).map(move |j| [i, j]))
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "panels are meters, cells millimeters"
    )]
    fn cell(&self, x: f64) -> i64 {
        (x / self.reach).floor() as i64
    }
}

fn distance_to_segment(p: Point2, [a, b]: [Point2; 2]) -> f64 {
    distance(p, lerp(a, b, share_along(p, [a, b])))
}
