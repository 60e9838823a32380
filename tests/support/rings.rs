//! Plane geometry for comparisons, apart from the library's own.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

use super::raw::P;

/// Distance of two points.
pub(crate) fn distance(a: P, b: P) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Length of a polyline, closed where `closed`.
pub(crate) fn length(points: &[P], closed: bool) -> f64 {
    let open: f64 = points.windows(2).map(|w| distance(w[0], w[1])).sum();
    match (points.first(), points.last()) {
        (Some(a), Some(b)) if closed => open + distance(*a, *b),
        _ => open,
    }
}

/// Distance of a point from a polyline, closed where `closed`.
pub(crate) fn apart(p: P, points: &[P], closed: bool) -> f64 {
    let back = points.last().zip(points.first()).filter(|_| closed);
    let segments = points.windows(2).map(|w| (w[0], w[1]));
    let all = segments.chain(back.map(|(a, b)| (*a, *b)));
    all.map(|(a, b)| {
        let d = [b[0] - a[0], b[1] - a[1]];
        let long = (d[0] * d[0] + d[1] * d[1]).max(f64::MIN_POSITIVE);
        let t = (((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / long).clamp(0.0, 1.0);
        distance(p, [a[0] + t * d[0], a[1] + t * d[1]])
    })
    .fold(f64::INFINITY, f64::min)
}

/// The points where a closed polyline turns by 20 degrees or more, duplicate points apart.
pub(crate) fn sharp(points: &[P], same: f64) -> Vec<P> {
    let mut ring: Vec<P> = Vec::new();
    for p in points {
        if ring.last().is_none_or(|last| distance(*last, *p) > same) {
            ring.push(*p);
        }
    }
    while ring.len() > 1 && distance(ring[0], ring[ring.len() - 1]) <= same {
        ring.pop();
    }
    let n = ring.len();
    let turn = |i: usize| {
        let (a, b, c) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
    };
    (0..n)
        .filter(|i| turn(*i).abs().to_degrees() >= 20.0)
        .map(|i| ring[i])
        .collect()
}
