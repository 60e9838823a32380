//! The points of a pattern's plane, and the arithmetic of two and three of them.
//!
//! A point is the array `[x, y]`, as it is written in JSON; y points up. Vectors are of the same
//! type. Lengths go through [`f64::hypot`], so that no coordinate overflows when it is squared.

/// A point or a vector of the plane, `[x, y]` \[m\].
pub type Point2 = [f64; 2];

/// Returns the vector from `b` to `a`.
pub(crate) fn sub(a: Point2, b: Point2) -> Point2 {
    [a[0] - b[0], a[1] - b[1]]
}

/// Returns the scalar product of two vectors.
pub(crate) fn dot(a: Point2, b: Point2) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Returns the cross product of two vectors: positive where `b` lies counter-clockwise of `a`.
pub(crate) fn cross(a: Point2, b: Point2) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Returns the distance of two points.
pub(crate) fn distance(a: Point2, b: Point2) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Returns the point at fraction `t` of the way from `a` to `b`.
pub(crate) fn lerp(a: Point2, b: Point2, t: f64) -> Point2 {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

/// Returns the turn at `b` on the way `a`, `b`, `c`, counter-clockwise positive \[rad\].
pub(crate) fn turn(a: Point2, b: Point2, c: Point2) -> f64 {
    let (u, v) = (sub(b, a), sub(c, b));
    cross(u, v).atan2(dot(u, v))
}

/// Coordinates up to this are read \[m\].
pub(crate) const FARTHEST: f64 = 1e4;

/// Returns true if both coordinates are finite and within [`FARTHEST`].
pub(crate) fn is_readable(p: Point2) -> bool {
    p.iter().all(|c| c.abs() <= FARTHEST)
}
