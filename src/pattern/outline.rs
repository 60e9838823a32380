//! Plane geometry of closed polylines (a closed polyline does not repeat its first point) and open ones. Metres, y up.

/// A point of the pattern plane.
pub(crate) type P = [f64; 2];

/// Distance of two points.
pub(crate) fn distance(a: P, b: P) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Length of an open polyline.
pub(crate) fn length(points: &[P]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// Length of a closed polyline.
pub(crate) fn perimeter(ring: &[P]) -> f64 {
    segments(ring).map(|(a, b)| distance(a, b)).sum()
}

/// Area of a closed polyline, positive where it runs counter-clockwise. Taken about its first point, so that an
/// outline far from the origin loses no precision.
pub(crate) fn signed_area(ring: &[P]) -> f64 {
    let Some(&o) = ring.first() else { return 0.0 };
    0.5 * segments(ring)
        .map(|(a, b)| cross(sub(a, o), sub(b, o)))
        .sum::<f64>()
}

/// The segments of a closed polyline.
pub(crate) fn segments(ring: &[P]) -> impl Iterator<Item = (P, P)> + '_ {
    ring.iter()
        .enumerate()
        .map(|(i, a)| (*a, ring[(i + 1) % ring.len()]))
}

/// Smallest and largest coordinates.
pub(crate) fn bounds(points: &[P]) -> [P; 2] {
    points
        .iter()
        .fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |b, p| {
            [
                [b[0][0].min(p[0]), b[0][1].min(p[1])],
                [b[1][0].max(p[0]), b[1][1].max(p[1])],
            ]
        })
}

/// Whether `p` lies inside a closed polyline (even-odd rule; the border itself belongs to either side).
pub(crate) fn contains(ring: &[P], p: P) -> bool {
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

/// Where a point comes nearest to a polyline.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Index of the segment.
    pub(crate) segment: usize,
    /// Fraction of that segment.
    pub(crate) at: f64,
    /// How far away it is.
    pub(crate) distance: f64,
}

/// Where `p` comes nearest to the given segments; `None` where there are none.
pub(crate) fn nearest(segments: impl Iterator<Item = (P, P)>, p: P) -> Option<Nearest> {
    segments
        .enumerate()
        .map(|(segment, (a, b))| {
            let d = sub(b, a);
            let at = (dot(sub(p, a), d) / dot(d, d).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let foot = [a[0] + at * d[0], a[1] + at * d[1]];
            Nearest {
                segment,
                at,
                distance: distance(p, foot),
            }
        })
        .min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// The turn at `b` on the way `a`, `b`, `c`, counter-clockwise positive \[radians\].
pub(crate) fn turn(a: P, b: P, c: P) -> f64 {
    let (u, v) = (sub(b, a), sub(c, b));
    cross(u, v).atan2(dot(u, v))
}

/// The first place found where a closed polyline crosses or touches itself; `None` for a simple one.
///
/// Segments are sorted along the axis on which they are shorter, and only those whose boxes overlap are compared.
pub(crate) fn crossing(ring: &[P]) -> Option<P> {
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

/// Where a polyline turns back on itself at `b`.
fn folded_back(a: P, b: P, c: P) -> Option<P> {
    let (u, v) = (sub(b, a), sub(c, b));
    (cross(u, v) == 0.0 && dot(u, v) < 0.0).then_some(b)
}

/// A point that two closed segments share.
fn meeting(a: P, b: P, c: P, d: P) -> Option<P> {
    let side = |p: P, q: P, r: P| cross(sub(q, p), sub(r, p));
    let (s1, s2) = (side(a, b, c), side(a, b, d));
    let (s3, s4) = (side(c, d, a), side(c, d, b));
    if s1 * s2 < 0.0 && s3 * s4 < 0.0 {
        let t = s3 / (s3 - s4);
        return Some([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
    }
    let within = |p: P, q: P, r: P| dot(sub(r, p), sub(r, q)) <= 0.0;
    [(s1, a, b, c), (s2, a, b, d), (s3, c, d, a), (s4, c, d, b)]
        .into_iter()
        .find(|(s, p, q, r)| *s == 0.0 && within(*p, *q, *r))
        .map(|(.., r)| r)
}

pub(crate) fn sub(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn dot(a: P, b: P) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn cross(a: P, b: P) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [P; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn measures_of_a_square() {
        assert_eq!(signed_area(&SQUARE), 4.0);
        assert_eq!(perimeter(&SQUARE), 8.0);
        assert!(contains(&SQUARE, [1.0, 1.0]) && !contains(&SQUARE, [3.0, 1.0]));
        assert_eq!(crossing(&SQUARE), None);
    }

    #[test]
    fn area_far_from_the_origin_keeps_its_digits() {
        let far: Vec<P> = SQUARE.iter().map(|p| [p[0] + 1e9, p[1] - 1e9]).collect();
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
