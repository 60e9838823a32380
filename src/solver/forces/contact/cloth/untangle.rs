//! Untangling of cloth that passes through itself, by making the lines in which it does shorter
//! (P. Volino, N. Magnenat-Thalmann, "Resolving Surface Collisions through Intersection Contour
//! Minimization", ACM TOG 25(3), 2006).
//!
//! No history is needed and no side: where an edge pierces a triangle, the line in which the edge's
//! triangles meet that one begins, and the edge is moved against the triangle in the direction that
//! shortens this line the most. Cloth that is through by less than a fold is pulled back out.
//! Layers that have an order are moved along the body's normal instead, the higher one outwards.
//!
//! # Limitations
//! Nothing keeps the shape of the cloth meanwhile; its particles move by a few edges at most.

use super::boxes::{Bounds, BoxTree};
use super::surface::ContactSurface;
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Rounds with the shortest moves, and as many again with each longer one.
const ROUNDS: usize = 100;
/// Moves of one round, over the mean edge.
const MOVES: [f64; 3] = [0.02, 0.04, 0.08];
/// Least sine of the angle between an edge and a triangle that it pierces: below it, shortening
/// would send them far along each other.
const LEAST_SINE: f64 = 1e-3;
/// Gradient of a line's length below which moves get shorter (dimensionless).
const SMALL_GRADIENT: f64 = 0.1;

/// Piercings for each particle from which on nothing is tried: cloth is crumpled to a point.
const MOST_PIERCINGS: usize = 20;

/// An edge that pierces a triangle.
struct Piercing {
    edge: [usize; 2],
    /// The triangle that the edge is of.
    owner: usize,
    triangle: usize,
    /// Place on the edge, 0 to 1.
    along: f64,
    /// Barycentric coordinates in the triangle.
    weights: [f64; 3],
}

/// Moves the particles of `x` that are not fixed until no edge pierces a triangle; if that cannot
/// be, as far as it got best. Returns true if one did.
pub(super) fn untangle(
    surface: &ContactSurface,
    x: &mut [Vector3<f64>],
    is_fixed: &[bool],
) -> bool {
    let mut tree = BoxTree::new(&bounds(surface, x), surface.moving_triangles);
    let mut found = find(&mut tree, surface, x);
    if found.is_empty() || found.len() >= MOST_PIERCINGS * x.len() {
        return !found.is_empty();
    }
    let beside = surface.triangles_of_edges();
    let mut least = (found.len(), x.to_vec());
    for length in MOVES
        .iter()
        .flat_map(|by| [by * surface.edge_length; ROUNDS])
    {
        for (i, by) in moves((surface, &beside), &found, (x, is_fixed), length) {
            x[i] += by;
        }
        found = find(&mut tree, surface, x);
        if found.len() < least.0 {
            least = (found.len(), x.to_vec());
        }
        if found.is_empty() {
            break;
        }
    }
    x.copy_from_slice(&least.1);
    true
}

/// Returns every edge that pierces a triangle without a common or stitched corner.
fn find(tree: &mut BoxTree, surface: &ContactSurface, x: &[Vector3<f64>]) -> Vec<Piercing> {
    tree.refit(&bounds(surface, x));
    let mut found = vec![];
    let most = MOST_PIERCINGS * x.len();
    let _ = tree.for_each_pair(&mut |s, t| {
        for (s, triangle) in [(s as usize, t as usize), (t as usize, s as usize)] {
            let corners = surface.triangles[triangle];
            for &edge in &surface.own[s].edges {
                if surface.share_corner(&edge, &corners) {
                    continue;
                }
                let pierced = pierce(edge.map(|i| x[i]), corners.map(|i| x[i]));
                found.extend(pierced.map(|(along, weights)| Piercing {
                    edge,
                    owner: s,
                    triangle,
                    along,
                    weights,
                }));
            }
        }
        if found.len() < most {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    });
    found
}

fn bounds(surface: &ContactSurface, x: &[Vector3<f64>]) -> Vec<Bounds> {
    let about = |&[a, b, c]: &[usize; 3]| {
        let edge = Bounds::about(&x[a], &x[b], 0.0);
        edge.with(&Bounds::about(&x[c], &x[c], 0.0))
    };
    surface.triangles.iter().map(about).collect()
}

/// Returns where an edge pierces a triangle: the place on the edge and that in the triangle.
fn pierce([p, q]: [Vector3<f64>; 2], [a, b, c]: [Vector3<f64>; 3]) -> Option<(f64, [f64; 3])> {
    let normal = (b - a).cross(&(c - a));
    let (above, below) = (normal.dot(&(p - a)), normal.dot(&(q - a)));
    if above * below > 0.0 || above == below {
        return None;
    }
    let along = above / (above - below);
    let point = p + (q - p) * along;
    let part = |u: Vector3<f64>, v: Vector3<f64>| {
        (u - point).cross(&(v - point)).dot(&normal) / normal.norm_squared()
    };
    let weights = [part(b, c), part(c, a), part(a, b)];
    let is_inside = weights.iter().all(|w| *w >= 0.0);
    is_inside.then_some((along, weights))
}

/// Returns moves of up to `length` \[m\], of particles that are not fixed, that shorten the lines
/// in which triangles meet, each the mean of those that its piercings ask for.
fn moves(
    (surface, beside): (&ContactSurface, &BTreeMap<[usize; 2], Vec<usize>>),
    found: &[Piercing],
    (x, is_fixed): (&[Vector3<f64>], &[bool]),
    length: f64,
) -> BTreeMap<usize, Vector3<f64>> {
    let mut moves: BTreeMap<usize, (Vector3<f64>, f64)> = BTreeMap::new();
    for piercing in found {
        let beside = &beside[&piercing.edge];
        let gradient = gradient(surface, beside, piercing, x);
        let by = gradient / gradient.norm().hypot(SMALL_GRADIENT);
        let by = in_order(surface, piercing, x, by) * length;
        let [i, j] = piercing.edge;
        let [k, l, m] = surface.triangles[piercing.triangle];
        let [wk, wl, wm] = piercing.weights;
        let shares = [1.0 - piercing.along, piercing.along, -wk, -wl, -wm];
        let shares = [i, j, k, l, m].into_iter().zip(shares);
        // What is fixed takes no part: the others move as far as they would with it.
        let shares = shares.filter(|(particle, _)| !is_fixed[*particle]);
        let square: f64 = shares.clone().map(|(_, share)| share * share).sum();
        for (particle, share) in shares.filter(|_| square > 0.0) {
            let (sum, weight) = moves.entry(particle).or_default();
            *sum += by * (share / square);
            *weight += share.abs();
        }
    }
    let mean = |(i, (sum, weight)): (usize, (Vector3<f64>, f64))| (i, sum / weight.max(1.0));
    moves.into_iter().map(mean).collect()
}

/// Returns the way `by` of an edge with the part along the body's normal put right, where the
/// layers of the edge and of the triangle that it pierces have an order.
fn in_order(
    surface: &ContactSurface,
    piercing: &Piercing,
    x: &[Vector3<f64>],
    by: Vector3<f64>,
) -> Vector3<f64> {
    let way_out = surface.order.as_ref().and_then(|order| {
        let [p, q] = piercing.edge.map(|i| x[i]);
        let point = p + (q - p) * piercing.along;
        order.way_out([piercing.owner, piercing.triangle], &point)
    });
    match way_out {
        Some(way) => by - way * way.dot(&by) + way,
        None => by,
    }
}

/// Returns the direction in which an edge is to be moved against the triangle that it pierces, so
/// that the lines which begin there become shorter; zero where it has none.
fn gradient(
    surface: &ContactSurface,
    beside: &[usize],
    piercing: &Piercing,
    x: &[Vector3<f64>],
) -> Vector3<f64> {
    let [a, b, c] = surface.triangles[piercing.triangle].map(|i| x[i]);
    let [p, q] = piercing.edge.map(|i| x[i]);
    let normal = (b - a).cross(&(c - a)).try_normalize(0.0);
    let edge = (q - p).try_normalize(0.0);
    let (Some(normal), Some(edge)) = (normal, edge) else {
        return Vector3::zeros();
    };
    let sine = edge.dot(&normal);
    let sine = sine.signum() * sine.abs().max(LEAST_SINE);
    let of_triangle = |&t: &usize| {
        let corners = surface.triangles[t].iter();
        let opposite = corners.copied().find(|i| !piercing.edge.contains(i))?;
        let into = x[opposite] - p;
        let across = edge.cross(&into).cross(&normal);
        // The line begins at the edge and leads into its triangle.
        let inward = into - edge * edge.dot(&into);
        let line = (across * across.dot(&inward).signum()).try_normalize(0.0)?;
        Some(line - normal * (2.0 * edge.dot(&line) / sine))
    };
    beside.iter().filter_map(of_triangle).sum()
}
