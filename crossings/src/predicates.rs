//! Common points of segments and triangles, decided exactly, whatever is degenerate.
//!
//! A *triangle* is the closed set of its points, which is a segment or a point where it has no
//! area. All that is decided is decided by signs of orientations (J. R. Shewchuk, Discrete &
//! Computational Geometry 18, 1997), as in P. Guigue, O. Devillers, J. Graphics Tools 8(1), 2003.
//! Those signs are exact here: coordinates are finite single-precision numbers, multiples of 2⁻¹⁴⁹
//! below 2¹²⁸, so that no product of three differences over- or underflows in double precision.
//!
//! What lies in one plane is projected along the axes. Some of the three projections does not
//! flatten the plane further, so points of it that have something in common in all three have it
//! in space.

use robust::{Coord, Coord3D};

pub(crate) type Point = [f64; 3];
pub(crate) type Triangle = [Point; 3];
type PlanePoint = [f64; 2];

/// Bound on the error of a sum of three products of a difference each, over the sum of their sizes:
/// a difference, a product and two sums are rounded, and it is twice what those can add up to.
const HEIGHT_ERROR: f64 = 4.0 * f64::EPSILON;

/// Corners of a triangle's edges.
pub(crate) const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// Returns six times the signed volume of the tetrahedron, rounded; its sign is exact: positive
/// if `p` is on the side from which the triangle's corners appear clockwise.
pub(crate) fn orientation(triangle: &Triangle, p: &Point) -> f64 {
    let [a, b, c, p] =
        [triangle[0], triangle[1], triangle[2], *p].map(|[x, y, z]| Coord3D { x, y, z });
    robust::orient3d(a, b, c, p)
}

/// Returns twice the signed area, rounded; its sign is exact: positive if counterclockwise.
fn plane_orientation(a: PlanePoint, b: PlanePoint, c: PlanePoint) -> f64 {
    let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
    robust::orient2d(a, b, c)
}

/// Returns the points without their coordinate `axis`.
fn project<const N: usize>(points: [Point; N], axis: usize) -> [PlanePoint; N] {
    points.map(|p| [p[(axis + 1) % 3], p[(axis + 2) % 3]])
}

/// Returns true if the corners are on one line, exactly.
pub(crate) fn has_no_area(triangle: &Triangle) -> bool {
    (0..3).all(|axis| {
        let [a, b, c] = project(*triangle, axis);
        plane_orientation(a, b, c) == 0.0
    })
}

/// Returns a point of both triangles, rounded, or none if they have no point in common.
pub(crate) fn common_point(a: &Triangle, b: &Triangle) -> Option<Point> {
    if are_surely_apart(a, b) {
        return None;
    }
    let sides_of_a = a.map(|p| orientation(b, &p));
    if is_one_sided(&sides_of_a) {
        return None;
    }
    let sides_of_b = b.map(|p| orientation(a, &p));
    if is_one_sided(&sides_of_b) {
        return None;
    }
    // If triangles meet, then an edge of one meets the other.
    let of_a = EDGES.map(|edge| Segment::of(a, edge, &sides_of_a));
    let of_b = EDGES.map(|edge| Segment::of(b, edge, &sides_of_b));
    let point_of_a = of_a.iter().find_map(|segment| segment.common_point(b));
    point_of_a.or_else(|| of_b.iter().find_map(|segment| segment.common_point(a)))
}

/// Returns a point, rounded, of a segment, which may be a point, and a triangle, or none if there
/// is none.
pub(crate) fn point_on_segment(ends: [Point; 2], triangle: &Triangle) -> Option<Point> {
    if are_surely_apart(&ends, triangle) {
        return None;
    }
    let sides = ends.map(|p| orientation(triangle, &p));
    Segment { ends, sides }.common_point(triangle)
}

/// Returns true if the triangles `u v a` and `u v b` are in one plane, on the same side of their
/// common edge.
pub(crate) fn is_folded([u, v]: [Point; 2], a: &Point, b: &Point) -> bool {
    orientation(&[u, v, *a], b) == 0.0
        && (0..3).any(|axis| {
            let [u, v, a, b] = project([u, v, *a, *b], axis);
            is_same_side(plane_orientation(u, v, a), plane_orientation(u, v, b))
        })
}

/// A segment and the sides of a triangle's plane on which its ends lie.
struct Segment {
    ends: [Point; 2],
    sides: [f64; 2],
}

impl Segment {
    /// Returns an edge of a triangle whose corners have these sides.
    fn of(triangle: &Triangle, [i, j]: [usize; 2], sides: &[f64; 3]) -> Self {
        Self {
            ends: [triangle[i], triangle[j]],
            sides: [sides[i], sides[j]],
        }
    }

    /// Returns a point, rounded, of the segment and the triangle that its sides are of.
    fn common_point(&self, triangle: &Triangle) -> Option<Point> {
        let [p, q] = &self.ends;
        let [side_p, side_q] = self.sides;
        if is_same_side(side_p, side_q) {
            return None;
        }
        if side_p == 0.0 && side_q == 0.0 {
            let amid = || between(&between(p, q, 0.5), &mean(triangle), 0.5);
            return self.meets_in_plane(triangle).then(amid);
        }
        // The line meets the plane in one point. It is not in the triangle if the line passes some
        // edges on one side and others on the other.
        let [a, b, c] = EDGES.map(|[i, j]| orientation(&[*p, *q, triangle[i]], &triangle[j]));
        let misses = is_opposite(a, b) || is_opposite(b, c) || is_opposite(c, a);
        (!misses).then(|| between(p, q, side_p / (side_p - side_q)))
    }

    /// Returns true if the segment meets the triangle, given that the ends are in its plane, or
    /// that it has no area and thus no plane. It is then all edges.
    fn meets_in_plane(&self, triangle: &Triangle) -> bool {
        let [p, q] = self.ends;
        let meets_edge = |[i, j]: [usize; 2]| segments_meet([p, q, triangle[i], triangle[j]]);
        EDGES.into_iter().any(meets_edge) || is_inside_in_plane(triangle, &p)
    }
}

/// Returns true if the segments from the first point to the second and from the third to the
/// fourth have a common point.
fn segments_meet([p, q, r, s]: [Point; 4]) -> bool {
    (0..3).all(|axis| segments_meet_in_plane(project([p, q, r, s], axis)))
        && orientation(&[p, q, r], &s) == 0.0
}

/// Does as `segments_meet` in two dimensions; segments may be points.
fn segments_meet_in_plane([p, q, r, s]: [PlanePoint; 4]) -> bool {
    let overlap = |k: usize| p[k].min(q[k]) <= r[k].max(s[k]) && r[k].min(s[k]) <= p[k].max(q[k]);
    overlap(0)
        && overlap(1)
        && !is_same_side(plane_orientation(p, q, r), plane_orientation(p, q, s))
        && !is_same_side(plane_orientation(r, s, p), plane_orientation(r, s, q))
}

/// Returns true if a point of the triangle's plane is inside the triangle and on none of its
/// edges; false if the triangle has no area.
fn is_inside_in_plane(triangle: &Triangle, p: &Point) -> bool {
    (0..3).any(|axis| {
        let [a, b, c, p] = project([triangle[0], triangle[1], triangle[2], *p], axis);
        let turns = [[a, b], [b, c], [c, a]].map(|[u, v]| plane_orientation(u, v, p));
        is_one_sided(&turns)
    })
}

/// Returns true if a plane across the line between their middles parts two sets of points by more
/// than rounding can matter. Most neighbors are told apart by this, flat ones without the long
/// arithmetic that an orientation of zero takes.
fn are_surely_apart(a: &[Point], b: &[Point]) -> bool {
    let (middle_a, middle_b) = (mean(a), mean(b));
    let direction = [0, 1, 2].map(|k| middle_b[k] - middle_a[k]);
    // From an exact point: the difference to it has one rounding.
    let origin = &b[0];
    let height = |p: &Point| {
        let terms = [0, 1, 2].map(|k| (p[k] - origin[k]) * direction[k]);
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        (terms.iter().sum::<f64>(), HEIGHT_ERROR * size)
    };
    let top_a = a.iter().map(height).map(|(height, error)| height + error);
    let bottom_b = b.iter().map(height).map(|(height, error)| height - error);
    top_a.fold(f64::MIN, f64::max) < bottom_b.fold(f64::MAX, f64::min)
}

fn is_same_side(a: f64, b: f64) -> bool {
    // Not by the product, which can underflow.
    (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0)
}

fn is_opposite(a: f64, b: f64) -> bool {
    (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)
}

fn is_one_sided(sides: &[f64; 3]) -> bool {
    sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0)
}

/// Returns the point at `share` of the way from `p` to `q`, rounded.
pub(crate) fn between(p: &Point, q: &Point, share: f64) -> Point {
    [0, 1, 2].map(|k| p[k] + share * (q[k] - p[k]))
}

/// Returns the mean of the points, rounded.
pub(crate) fn mean(points: &[Point]) -> Point {
    let count = points.len() as f64;
    [0, 1, 2].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::random::Random;

    /// Points at 1, 2²⁰ and 2³³ times about the same vector, where double precision does not hold
    /// the products: most are on one line, the others off it by a unit of the nearest.
    #[test]
    fn orientations_in_a_plane_are_exact_over_many_scales() {
        let mut random = Random::new(23);
        let (mut collinear, mut turned) = (0, 0);
        for _ in 0..5000 {
            let (x, y) = (
                1_048_573 + random.integer(999),
                786_431 + random.integer(999),
            );
            let near = [x + random.integer(1), y + random.integer(1)];
            let [a, b, c] = [near, [x << 20, y << 20], [x << 33, y << 33]];
            let product = |i: usize, j: usize| i128::from(b[i] - a[i]) * i128::from(c[j] - a[j]);
            let expected = (product(0, 1) - product(1, 0)).signum();
            let [a, b, c] = [a, b, c].map(|p| p.map(|x| f64::from(x as f32)));
            let found = plane_orientation(a, b, c);
            let sign = i128::from(found > 0.0) - i128::from(found < 0.0);
            assert_eq!(sign, expected, "{a:?} {b:?} {c:?}");
            collinear += usize::from(expected == 0);
            turned += usize::from(expected != 0);
        }
        assert!(collinear > 300 && turned > 3000);
    }
}
