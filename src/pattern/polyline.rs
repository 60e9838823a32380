//! Plane geometry of polylines. A closed polyline (a ring) does not repeat its first point.

use super::point::{Point2, cross, distance, dot, lerp, sub};

/// Returns the length of an open polyline.
pub(crate) fn length(points: &[Point2]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// Returns the length of a closed polyline.
pub(crate) fn perimeter(ring: &[Point2]) -> f64 {
    segments(ring).map(|(a, b)| distance(a, b)).sum()
}

/// Returns the area of a closed polyline, positive where it runs counter-clockwise. Taken about its
/// first point, so that an outline far from the origin loses no precision.
pub(crate) fn signed_area(ring: &[Point2]) -> f64 {
    let Some(&o) = ring.first() else { return 0.0 };
    0.5 * segments(ring)
        .map(|(a, b)| cross(sub(a, o), sub(b, o)))
        .sum::<f64>()
}

/// Returns the segments of a closed polyline.
pub(crate) fn segments(ring: &[Point2]) -> impl Iterator<Item = (Point2, Point2)> + '_ {
    ring.iter()
        .enumerate()
        .map(|(i, a)| (*a, ring[(i + 1) % ring.len()]))
}

/// Returns the smallest and the largest coordinates.
pub(crate) fn bounds(points: &[Point2]) -> [Point2; 2] {
    points
        .iter()
        .fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |b, p| {
            [
                [b[0][0].min(p[0]), b[0][1].min(p[1])],
                [b[1][0].max(p[0]), b[1][1].max(p[1])],
            ]
        })
}

/// Returns the longer side of the box of some points.
pub(crate) fn longest_side(points: &[Point2]) -> f64 {
    let [low, high] = bounds(points);
    (high[0] - low[0]).max(high[1] - low[1])
}

/// Returns true if `p` lies inside a closed polyline (even-odd rule; the border itself belongs to
/// either side).
pub(crate) fn contains(ring: &[Point2], p: Point2) -> bool {
    let mut inside = false;
    for (a, b) in segments(ring) {
        if (a[1] > p[1]) != (b[1] > p[1])
            && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        {
            inside = !inside;
        }
    }
    inside
}

/// The foot of a point on a polyline: the nearest point of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PolylineFoot {
    /// Index of the segment.
    pub(crate) segment: usize,
    /// Fraction of that segment.
    pub(crate) at: f64,
    /// Distance of the point from it.
    pub(crate) distance: f64,
}

/// Returns the foot of `p` on the given segments; `None` where there are none.
pub(crate) fn nearest(
    segments: impl Iterator<Item = (Point2, Point2)>,
    p: Point2,
) -> Option<PolylineFoot> {
    segments
        .enumerate()
        .map(|(segment, (a, b))| {
            let d = sub(b, a);
            let at = (dot(sub(p, a), d) / dot(d, d).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            PolylineFoot {
                segment,
                at,
                distance: distance(p, lerp(a, b, at)),
            }
        })
        .min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// Returns a point where a closed polyline crosses or touches itself; `None` for a simple one.
///
/// Segments are sorted along the axis on which they are shorter, and only those whose boxes overlap are compared.
pub(crate) fn crossing(ring: &[Point2]) -> Option<Point2> {
    let n = ring.len();
    let segment = |i: usize| (ring[i], ring[(i + 1) % n]);
    let extent = |k: usize| {
        segments(ring)
            .map(|(a, b)| (b[k] - a[k]).abs())
            .sum::<f64>()
    };
    let [low_bound, high_bound] = bounds(ring);
    let crowded = |k: usize| extent(k) / (high_bound[k] - low_bound[k]).max(f64::MIN_POSITIVE);
    let (along, across) = if crowded(0) <= crowded(1) {
        (0, 1)
    } else {
        (1, 0)
    };
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
            if place.is_some() {
                return place;
            }
        }
    }
    None
}

/// Returns `b` where the polyline `a`, `b`, `c` turns back on itself there.
fn folded_back(a: Point2, b: Point2, c: Point2) -> Option<Point2> {
    let (u, v) = (sub(b, a), sub(c, b));
    (cross(u, v) == 0.0 && dot(u, v) < 0.0).then_some(b)
}

/// Returns a point that two closed segments share.
fn meeting(a: Point2, b: Point2, c: Point2, d: Point2) -> Option<Point2> {
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

    const SQUARE: [Point2; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn measures_of_a_square() {
        assert_eq!(signed_area(&SQUARE), 4.0);
        assert_eq!(perimeter(&SQUARE), 8.0);
        assert!(contains(&SQUARE, [1.0, 1.0]) && !contains(&SQUARE, [3.0, 1.0]));
        assert_eq!(crossing(&SQUARE), None);
    }

    #[test]
    fn area_far_from_the_origin_keeps_its_digits() {
        let far: Vec<Point2> = SQUARE.iter().map(|p| [p[0] + 1e9, p[1] - 1e9]).collect();
        assert_eq!(signed_area(&far), 4.0);
    }

    #[test]
    fn crossings_touches_and_spikes_are_found() {
        let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(crossing(&bow_tie), Some([1.0, 1.0]));
        let touching = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]];
        assert_eq!(crossing(&touching), Some([2.0, 0.0]));
        let spike = [[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [4.0, 2.0], [0.0, 2.0]];
        assert!(crossing(&spike).is_some());
    }
}
