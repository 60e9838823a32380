//! Arcs and ellipses as polylines, cut every degree: the chord error stays below 4e-5 of the
//! (larger) radius, the length error below 1.3e-5 of the length.

use super::point::Point2;
use std::f64::consts::{PI, TAU};

/// Largest turn between two chords \[rad\].
const STEP: f64 = PI / 180.0;

/// Returns the points of an arc from `from` over `sweep` (radians, counter-clockwise positive),
/// both ends included.
pub(super) fn arc(center: Point2, radius: f64, from: f64, sweep: f64) -> Vec<Point2> {
    ellipse(center, [radius, 0.0], [0.0, radius], [from, sweep])
}

/// Returns the points of the ellipse `center + cos(t) major + sin(t) minor`, `t` from `range[0]`
/// over `range[1]`, both ends included.
pub(super) fn ellipse(
    center: Point2,
    major: Point2,
    minor: Point2,
    range: [f64; 2],
) -> Vec<Point2> {
    let count = steps(range[1].abs(), 2, 720);
    (0..=count)
        .map(|i| {
            let (sin, cos) = (range[0] + range[1] * fraction(i, count)).sin_cos();
            [
                center[0] + cos * major[0] + sin * minor[0],
                center[1] + cos * major[1] + sin * minor[1],
            ]
        })
        .collect()
}

/// Returns the points of the arc from `a` to `b` with a bulge (tangent of a quarter of its sweep),
/// `b` left out.
pub(super) fn bulge(a: Point2, b: Point2, bulge: f64) -> Vec<Point2> {
    let chord = [b[0] - a[0], b[1] - a[1]];
    if bulge == 0.0 || chord == [0.0, 0.0] {
        return vec![a];
    }
    let k = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center = [
        f64::midpoint(a[0], b[0]) - k * chord[1],
        f64::midpoint(a[1], b[1]) + k * chord[0],
    ];
    let radius = (a[0] - center[0]).hypot(a[1] - center[1]);
    let from = (a[1] - center[1]).atan2(a[0] - center[0]);
    let mut points = arc(center, radius, from, 4.0 * bulge.atan());
    points.pop();
    points[0] = a;
    points
}

/// Returns the sweep of an arc counter-clockwise from `start` to `end` (radians), in (0, 2 pi].
pub(super) fn sweep(start: f64, end: f64) -> f64 {
    let turn = (end - start).rem_euclid(TAU);
    if turn < 1e-12 { TAU } else { turn }
}

/// Returns the number of steps of at most [`STEP`] that make up `angle`, within bounds.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the value is clamped to a small positive range first"
)]
fn steps(angle: f64, least: usize, most: usize) -> usize {
    (angle / STEP - 1e-9)
        .ceil()
        .clamp(least as f64, most as f64) as usize
}

fn fraction(i: usize, count: usize) -> f64 {
    i as f64 / count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(points: &[Point2]) -> f64 {
        points
            .windows(2)
            .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]))
            .sum()
    }

    #[test]
    fn half_circle_bulge_has_the_length_of_a_half_circle() {
        for (sign, side) in [(1.0, -1.0), (-1.0, 1.0)] {
            let mut points = bulge([-1.0, 0.0], [1.0, 0.0], sign);
            points.push([1.0, 0.0]);
            assert!((length(&points) / PI - 1.0).abs() < 1.3e-5);
            let middle = points[points.len() / 2];
            assert!((middle[1] - side).abs() < 1e-9, "{middle:?}");
        }
    }
}
