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

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point2; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn measures_of_a_square() {
        assert_eq!(signed_area(&SQUARE), 4.0);
        assert_eq!(perimeter(&SQUARE), 8.0);
        assert!(contains(&SQUARE, [1.0, 1.0]) && !contains(&SQUARE, [3.0, 1.0]));
    }

    #[test]
    fn area_far_from_the_origin_keeps_its_digits() {
        let far: Vec<Point2> = SQUARE.iter().map(|p| [p[0] + 1e9, p[1] - 1e9]).collect();
        assert_eq!(signed_area(&far), 4.0);
    }
}
