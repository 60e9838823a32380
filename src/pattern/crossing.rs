//! Crossings of a closed polyline with itself.

use super::point::{Point2, cross, dot, lerp, sub};
use super::polyline::{bounds, segments};

/// A place where a closed polyline crosses or touches itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RingCrossing {
    /// The point.
    pub(crate) point: Point2,
    /// The two segments that share it, the first by its number first.
    pub(crate) segments: [usize; 2],
}

/// Returns a point where a closed polyline crosses or touches itself; `None` for a simple one.
pub(crate) fn crossing(ring: &[Point2]) -> Option<Point2> {
    first_crossing(ring).map(|crossing| crossing.point)
}

/// Returns a place where a closed polyline crosses or touches itself; `None` for a simple one.
///
/// Segments are sorted along the axis on which they are shorter, and only those whose boxes overlap
/// are compared.
pub(crate) fn first_crossing(ring: &[Point2]) -> Option<RingCrossing> {
    let n = ring.len();
    let segment = |i: usize| (ring[i], ring[(i + 1) % n]);
    let [along, across] = sweep_axes(ring);
    let low = |i: usize| segment(i).0[along].min(segment(i).1[along]);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|i, j| low(*i).total_cmp(&low(*j)));
    for (k, &i) in order.iter().enumerate() {
        let (a, b) = segment(i);
        let right = a[along].max(b[along]);
        for &j in order[k + 1..].iter().take_while(|j| low(**j) <= right) {
            let (c, d) = segment(j);
            if a[across].max(b[across]) < c[across].min(d[across])
                || c[across].max(d[across]) < a[across].min(b[across])
            {
                continue;
            }
            let place = if (i + 1) % n == j {
                folded_back(a, b, d)
            } else if (j + 1) % n == i {
                folded_back(c, d, b)
            } else {
                meeting(a, b, c, d)
            };
            if let Some(point) = place {
                let segments = [i.min(j), i.max(j)];
                return Some(RingCrossing { point, segments });
            }
        }
    }
    None
}

/// Returns the axis on which segments are shorter, as a share of the whole, and the other one.
fn sweep_axes(ring: &[Point2]) -> [usize; 2] {
    let [low, high] = bounds(ring);
    let crowding = |k: usize| {
        let extents = segments(ring).map(|(a, b)| (b[k] - a[k]).abs());
        extents.sum::<f64>() / (high[k] - low[k]).max(f64::MIN_POSITIVE)
    };
    if crowding(0) <= crowding(1) {
        [0, 1]
    } else {
        [1, 0]
    }
}

/// Returns `b` where the polyline `a`, `b`, `c` turns back on itself there.
fn folded_back(a: Point2, b: Point2, c: Point2) -> Option<Point2> {
    let (u, v) = (sub(b, a), sub(c, b));
    (cross(u, v) == 0.0 && dot(u, v) < 0.0).then_some(b)
}

/// Returns a point that two closed segments share.
pub(crate) fn meeting(a: Point2, b: Point2, c: Point2, d: Point2) -> Option<Point2> {
    let side = |p: Point2, q: Point2, r: Point2| cross(sub(q, p), sub(r, p));
    let (s1, s2) = (side(a, b, c), side(a, b, d));
    let (s3, s4) = (side(c, d, a), side(c, d, b));
    if s1 * s2 < 0.0 && s3 * s4 < 0.0 {
        let t = s3 / (s3 - s4);
        return Some(lerp(a, b, t));
    }
    let within = |p: Point2, q: Point2, r: Point2| dot(sub(r, p), sub(r, q)) <= 0.0;
    [(s1, a, b, c), (s2, a, b, d), (s3, c, d, a), (s4, c, d, b)]
        .into_iter()
        .find(|(s, p, q, r)| *s == 0.0 && within(*p, *q, *r))
        .map(|(.., r)| r)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_touches_and_spikes_are_found() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(crossing(&square), None);
        let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(crossing(&bow_tie), Some([1.0, 1.0]));
        let touching = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]];
        assert_eq!(crossing(&touching), Some([2.0, 0.0]));
        let spike = [[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [4.0, 2.0], [0.0, 2.0]];
        assert!(crossing(&spike).is_some());
    }
}
