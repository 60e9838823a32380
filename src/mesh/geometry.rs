//! Plane geometry of meshing: polylines by arc length, areas, angles.

use crate::pattern::point::{Point2, distance, lerp, sub};
use crate::pattern::polyline::length;

/// The point on the other side of the y axis.
pub(super) fn reflected([x, y]: Point2) -> Point2 {
    [-x, y]
}

/// Area of a triangle, positive if it is counter-clockwise.
pub(super) fn area(a: Point2, b: Point2, c: Point2) -> f64 {
    let (u, v) = (sub(b, a), sub(c, a));
    0.5 * (u[0] * v[1] - u[1] * v[0])
}

/// Area of a ring of points, positive if it is counter-clockwise. Taken about the first point, so
/// that far-off coordinates cost no digits.
pub(super) fn ring_area(ring: &[Point2]) -> f64 {
    ring.windows(2).map(|w| area(ring[0], w[0], w[1])).sum()
}

/// Smallest angle of a triangle \[rad\].
pub(super) fn smallest_angle(corners: [Point2; 3]) -> f64 {
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

/// Returns true if this is a polyline that can be divided: at least two points, all finite, of
/// positive length.
pub(super) fn is_sound(points: &[Point2]) -> bool {
    points.len() >= 2 && {
        let length = length(points);
        length.is_finite() && length > 0.0
    }
}

/// Points of `polyline` at rising arc lengths `at`, each from 0 to its length.
pub(super) fn resample(polyline: &[Point2], at: impl Iterator<Item = f64>) -> Vec<Point2> {
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

/// The share of the way from `a` to `b` at which a segment is nearest to `p`.
pub(super) fn share_along(p: Point2, [a, b]: [Point2; 2]) -> f64 {
    let (u, v) = (sub(b, a), sub(p, a));
    let square = u[0] * u[0] + u[1] * u[1];
    if square > 0.0 {
        ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    }
}
