//! Features of the edges of a panel: length, bend, turn from one to the next.

use crate::pattern::point::{cross, dot, sub, turn};
use crate::pattern::{Edge, Point2};

/// Distance from a corner over which its direction is measured \[m\]: above the noise of digitized
/// outlines, below their curvature.
const DIRECTION_LENGTH_M: f64 = 0.008;

/// Features of one edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeFeatures {
    /// Arc length \[m\].
    pub(super) length: f64,
    /// Turn between its ends, positive where the outline is convex \[rad\].
    pub(super) bend: f64,
    /// Turns to either side, each counted \[rad\].
    pub(super) curl: f64,
    /// Its mean height in the drawing \[m\].
    pub(super) height: f64,
    /// Start and end, in the order of numbers \[m\].
    pub(super) ends: [Point2; 2],
}

impl EdgeFeatures {
    /// Measures an edge; `sense` is 1 where the order of numbers runs counter-clockwise, else -1.
    pub(super) fn of(edge: &Edge, sense: f64) -> Self {
        let bend: f64 = edge
            .points
            .windows(3)
            .map(|p| sense * turn(p[0], p[1], p[2]))
            .sum();
        let curl: f64 = edge
            .points
            .windows(3)
            .map(|p| turn(p[0], p[1], p[2]).abs())
            .sum();
        let lifted: f64 = edge
            .points
            .windows(2)
            .map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]))
            .sum();
        let first = edge.points.first().copied().unwrap_or_default();
        let last = edge.points.last().copied().unwrap_or_default();
        Self {
            length: edge.length_m,
            bend,
            curl,
            height: lifted / edge.length_m.max(1e-9),
            ends: [first, last],
        }
    }
}

/// The turn where one edge ends and the next begins, counter-clockwise positive \[rad\].
pub(super) fn turn_between(before: &Edge, after: &Edge) -> f64 {
    let reversed: Vec<Point2> = before.points.iter().rev().copied().collect();
    let arriving = leaving(&reversed).map(|c| -c);
    turn_of(arriving, leaving(&after.points))
}

/// Direction in which a polyline leaves its first point, not of unit length.
fn leaving(points: &[Point2]) -> Point2 {
    let Some(&first) = points.first() else {
        return [1.0, 0.0];
    };
    let mut way = 0.0;
    let mut last = first;
    for &point in &points[1..] {
        let [x, y] = sub(point, last);
        way += x.hypot(y);
        last = point;
        if way >= DIRECTION_LENGTH_M {
            break;
        }
    }
    sub(last, first)
}

/// Returns the turn from one direction to another, counter-clockwise positive \[rad\].
fn turn_of(u: Point2, v: Point2) -> f64 {
    cross(u, v).atan2(dot(u, v))
}
