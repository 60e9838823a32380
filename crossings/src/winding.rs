//! Winding numbers of a surface of triangles about points.

use crate::predicates::{self, EDGES, Point, Triangle};
use crate::surface::Surface;
use std::cmp::Ordering;
use std::f64::consts::TAU;

/// Returns the winding number of a surface about a point: 1 inside of a closed surface whose
/// triangles appear counterclockwise from outside, 0 outside, 2 where two parts of it overlap; on
/// the surface the mean of what is around (A. Jacobson, L. Kavan, O. Sorkine-Hornung, ACM
/// Transactions on Graphics 32(4), 2013).
///
/// A sum of rounded angles, of which none is on the wrong side: their signs are exact. The error is
/// some 10⁻¹⁶ a triangle.
pub(crate) fn winding_number(surface: &Surface<'_>, p: &Point) -> f64 {
    let half_angles = (0..surface.triangle_count()).map(|t| half_angle(&surface.corners(t), p));
    half_angles.sum::<f64>() / TAU
}

/// Returns half the signed solid angle of a triangle seen from `p`, 0 if `p` is in its plane
/// (A. van Oosterom, J. Strackee, IEEE Transactions on Biomedical Engineering 30(2), 1983).
fn half_angle(triangle: &Triangle, p: &Point) -> f64 {
    let volume = predicates::orientation(triangle, p);
    if volume == 0.0 {
        return 0.0;
    }
    let [a, b, c] = triangle.map(|corner| [0, 1, 2].map(|k| corner[k] - p[k]));
    let [length_a, length_b, length_c] = [a, b, c].map(|v| dot(&v, &v).sqrt());
    let denominator = length_a * length_b * length_c
        + dot(&a, &b) * length_c
        + dot(&b, &c) * length_a
        + dot(&c, &a) * length_b;
    volume.atan2(denominator)
}

fn dot(a: &Point, b: &Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns true if every edge is passed as often one way as the other, so that winding numbers are
/// whole and change at the surface only. Corners at one place are one, whatever their indices.
pub(crate) fn is_closed(surface: &Surface<'_>) -> bool {
    let mut edges: Vec<_> = (0..surface.triangle_count())
        .flat_map(|t| directed_edges(&surface.corners(t)))
        .collect();
    edges.sort_unstable();
    let same_edge = |a: &DirectedEdge, b: &DirectedEdge| a.ends == b.ends;
    let mut groups = edges.chunk_by(same_edge);
    groups.all(|group| group.iter().map(|edge| edge.direction).sum::<i64>() == 0)
}

/// An edge by the places of its ends, and the direction in which it is passed: 1 or -1, or 0 if it
/// has no length.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct DirectedEdge {
    ends: [[u64; 3]; 2],
    direction: i64,
}

fn directed_edges(triangle: &Triangle) -> [DirectedEdge; 3] {
    // Adding zero makes the two zeros one.
    let places = triangle.map(|p| p.map(|x| (x + 0.0).to_bits()));
    EDGES.map(|[i, j]| {
        let (p, q) = (places[i], places[j]);
        DirectedEdge {
            ends: [p.min(q), p.max(q)],
            direction: match p.cmp(&q) {
                Ordering::Less => 1,
                Ordering::Equal => 0,
                Ordering::Greater => -1,
            },
        }
    })
}
