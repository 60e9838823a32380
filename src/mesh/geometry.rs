//! Plane geometry that meshing needs: polylines by arc length, areas, angles, distance to a boundary.

use super::boundary::Boundary;
use std::collections::BTreeMap;

pub(super) type Point = [f64; 2];

pub(super) fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// The point at share `t` of the way from `a` to `b`.
pub(super) fn lerp(a: Point, b: Point, t: f64) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The point on the other side of the y axis.
pub(super) fn reflected([x, y]: Point) -> Point {
    [-x, y]
}

/// Area of a triangle, positive if it is counter-clockwise.
pub(super) fn area(a: Point, b: Point, c: Point) -> f64 {
    let (u, v) = (sub(b, a), sub(c, a));
    0.5 * (u[0] * v[1] - u[1] * v[0])
}

/// Area of a ring of points, positive if it is counter-clockwise. Taken about the first point, so that far-off
/// coordinates cost no digits.
pub(super) fn ring_area(ring: &[Point]) -> f64 {
    ring.windows(2).map(|w| area(ring[0], w[0], w[1])).sum()
}

/// Smallest angle of a triangle \[rad\].
pub(super) fn smallest_angle(corners: [Point; 3]) -> f64 {
    (0..3)
        .map(|i| {
            let (u, v) = (
                sub(corners[(i + 1) % 3], corners[i]),
                sub(corners[(i + 2) % 3], corners[i]),
            );
            (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
        })
        .fold(f64::INFINITY, f64::min)
}

/// Length of a polyline.
pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// Whether this is a polyline that can be divided: at least two points, all finite, with a length.
pub(super) fn is_sound(points: &[Point]) -> bool {
    points.len() >= 2 && {
        let length = length(points);
        length.is_finite() && length > 0.0
    }
}

/// Points of `polyline` at rising arc lengths `at`, each from 0 to its length.
pub(super) fn resample(polyline: &[Point], at: impl Iterator<Item = f64>) -> Vec<Point> {
    let (mut index, mut passed) = (0, 0.0);
    at.map(|s| {
        let mut span = distance(polyline[index], polyline[index + 1]);
        while passed + span < s && index + 2 < polyline.len() {
            passed += span;
            index += 1;
            span = distance(polyline[index], polyline[index + 1]);
        }
        let share = if span > 0.0 { (s - passed) / span } else { 0.0 };
        lerp(polyline[index], polyline[index + 1], share.clamp(0.0, 1.0))
    })
    .collect()
}

/// Answers whether a point keeps its distance from a boundary, by cells of that distance.
pub(super) struct SegmentGrid {
    reach: f64,
    cells: BTreeMap<[i64; 2], Vec<[Point; 2]>>,
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

    /// Whether no part of the boundary is closer to `p` than `share` of the reach (0 to 1).
    pub(super) fn is_clear(&self, p: Point, share: f64) -> bool {
        let segments = self.cells.get(&p.map(|x| self.cell(x)));
        let near = |s: &[Point; 2]| distance_to_segment(p, *s) < share * self.reach;
        !segments.is_some_and(|segments| segments.iter().any(near))
    }

    fn cells_near(&self, [a, b]: [Point; 2]) -> impl Iterator<Item = [i64; 2]> + use<> {
        let low = [0, 1].map(|k| self.cell(a[k].min(b[k]) - self.reach));
        let high = [0, 1].map(|k| self.cell(a[k].max(b[k]) + self.reach));
        (low[0]..=high[0]).flat_map(move |i| (low[1]..=high[1]).map(move |j| [i, j]))
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "panels are metres, cells millimetres"
    )]
    fn cell(&self, x: f64) -> i64 {
        (x / self.reach).floor() as i64
    }
}

fn distance_to_segment(p: Point, [a, b]: [Point; 2]) -> f64 {
    distance(p, lerp(a, b, share_along(p, [a, b])))
}

/// The share of the way from `a` to `b` at which a segment is nearest to `p`.
pub(super) fn share_along(p: Point, [a, b]: [Point; 2]) -> f64 {
    let (u, v) = (sub(b, a), sub(p, a));
    let square = u[0] * u[0] + u[1] * u[1];
    if square > 0.0 {
        ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    }
}
