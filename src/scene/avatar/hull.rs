//! The outside of a surface that crosses itself.
//!
//! Its inside is where the winding number is 1 or more. Triangles that no other one crosses are
//! wholly on its border or wholly not; those that are crossed are cut along the planes of the
//! others, and each part is told by the winding numbers before and behind it. Walls inside do not
//! count.

use super::TriangleMesh;
use super::winding::Winding;
use crate::fault::{AvatarCode, Fault};
use nalgebra::Vector3;
use seamster_crossings::{SearchLimits, Surface, find_crossings};
use std::collections::BTreeMap;

/// Most pairs of triangles that cross, and pairs that are looked at.
const CROSSINGS: usize = 200_000;
const PAIRS: usize = 20_000_000;
/// Planes that a triangle is cut along, at most: the parts grow with their square.
const CUTS: usize = 24;
/// Distance before and behind a part at which winding numbers are taken \[m\].
const STEP: f64 = 1e-6;
/// Distance from a plane within which a corner is on it \[m\].
const ON_PLANE: f64 = 1e-9;
/// Area, doubled, of a part that is left out \[m²\].
const EMPTY: f64 = 1e-13;

/// The outer triangles of a surface, and its winding numbers.
pub(super) struct Hull {
    pub(super) surface: TriangleMesh,
    pub(super) winding: Winding,
}

/// Returns the hull of a closed surface; none if it is one piece that does not cross itself, and so
/// its own hull.
///
/// # Errors
/// `avatar/crossing` if it crosses itself in too many places.
pub(super) fn hull(surface: &TriangleMesh) -> Result<Option<Hull>, Fault> {
    let crossings = crossings(surface)?;
    let patches = patches(surface, &crossings);
    if crossings.is_empty() && patches.iter().all(|patch| *patch == 0) {
        return Ok(None);
    }
    let winding = Winding::new(surface);
    let mut is_outer = BTreeMap::new();
    let mut hull = TriangleMesh {
        vertices: surface.vertices.clone(),
        triangles: Vec::new(),
    };
    for (t, triangle) in surface.triangles.iter().enumerate() {
        let corners = surface.corners(t);
        if let Some(others) = crossings.get(&t) {
            for part in cut(surface, &corners, others) {
                if is_on_border(&winding, &part) {
                    add_fan(&mut hull, &part);
                }
            }
            continue;
        }
        let outer = is_outer
            .entry(patches[t])
            .or_insert_with(|| is_on_border(&winding, &corners));
        if *outer {
            hull.triangles.push(*triangle);
        }
    }
    Ok(Some(Hull {
        surface: hull,
        winding,
    }))
}

/// The triangles that cross each one.
fn crossings(surface: &TriangleMesh) -> Result<BTreeMap<usize, Vec<usize>>, Fault> {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "single precision holds a body to a tenth of a micrometer"
    )]
    let points: Vec<[f32; 3]> = surface
        .vertices
        .iter()
        .map(|p| [p.x as f32, p.y as f32, p.z as f32])
        .collect();
    let index = |v: usize| u32::try_from(v).unwrap_or(u32::MAX);
    let triangles: Vec<_> = surface.triangles.iter().map(|t| t.map(index)).collect();
    let limits = SearchLimits {
        kept: CROSSINGS,
        pairs: PAIRS,
    };
    let checked = Surface::new(&points, &triangles, &[]).ok();
    let report = checked.and_then(|checked| find_crossings(&checked, None, limits).ok());
    let too_many = || {
        let detail = format!("the body crosses itself in more than {CROSSINGS} places");
        Fault::new(AvatarCode::Crossing, "/surface", detail)
            .fix("make it one skin, or leave out clothes that lie on it")
    };
    let found = report.ok_or_else(too_many)?.cloth;
    if found.count > found.kept.len() {
        return Err(too_many());
    }
    let mut crossings: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for crossing in found.kept {
        let [a, b] = crossing.triangles.map(|t| t as usize);
        crossings.entry(a).or_default().push(b);
        crossings.entry(b).or_default().push(a);
    }
    Ok(crossings)
}

/// Numbers of the patches that triangles which are not crossed hang together in, each after its
/// lowest triangle.
fn patches(surface: &TriangleMesh, crossings: &BTreeMap<usize, Vec<usize>>) -> Vec<usize> {
    let mut edges: Vec<(usize, usize, usize)> = surface
        .triangles
        .iter()
        .enumerate()
        .filter(|(t, _)| !crossings.contains_key(t))
        .flat_map(|(t, &[a, b, c])| [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b), t)))
        .collect();
    edges.sort_unstable();
    let mut parent: Vec<usize> = (0..surface.triangles.len()).collect();
    for pair in edges.windows(2) {
        if (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1) {
            let [a, b] = [pair[0].2, pair[1].2].map(|t| root(&mut parent, t));
            parent[a.max(b)] = a.min(b);
        }
    }
    (0..surface.triangles.len())
        .map(|t| root(&mut parent, t))
        .collect()
}

fn root(parent: &mut [usize], mut t: usize) -> usize {
    while parent[t] != t {
        parent[t] = parent[parent[t]];
        t = parent[t];
    }
    t
}

/// Cuts a triangle along the planes of others; returns its parts, convex.
fn cut(
    surface: &TriangleMesh,
    corners: &[Vector3<f64>; 3],
    others: &[usize],
) -> Vec<Vec<Vector3<f64>>> {
    let mut parts = vec![corners.to_vec()];
    for &other in others.iter().take(CUTS) {
        let [a, b, c] = surface.corners(other);
        let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else {
            continue;
        };
        parts = parts
            .into_iter()
            .flat_map(|part| split(part, &a, &normal))
            .collect();
    }
    parts
}

/// Splits a convex polygon along a plane.
fn split(
    part: Vec<Vector3<f64>>,
    point: &Vector3<f64>,
    normal: &Vector3<f64>,
) -> Vec<Vec<Vector3<f64>>> {
    let off = |p: &Vector3<f64>| (p - point).dot(normal);
    let is_cut = part.iter().any(|p| off(p) > ON_PLANE) && part.iter().any(|p| off(p) < -ON_PLANE);
    if !is_cut {
        return vec![part];
    }
    let (mut before, mut behind) = (Vec::new(), Vec::new());
    let next = part.iter().cycle().skip(1);
    for (p, q) in part.iter().zip(next) {
        let (from, to) = (off(p), off(q));
        if from >= -ON_PLANE {
            before.push(*p);
        }
        if from <= ON_PLANE {
            behind.push(*p);
        }
        if (from > ON_PLANE && to < -ON_PLANE) || (from < -ON_PLANE && to > ON_PLANE) {
            let on = p + (q - p) * (from / (from - to));
            before.push(on);
            behind.push(on);
        }
    }
    vec![before, behind]
}

/// Returns true if a flat part has the outside before it and the inside behind it.
fn is_on_border(winding: &Winding, part: &[Vector3<f64>]) -> bool {
    let Some(normal) = area_normal(part).try_normalize(EMPTY) else {
        return false;
    };
    let middle = part.iter().sum::<Vector3<f64>>() / part.len() as f64;
    let [before, behind] = [STEP, -STEP].map(|step| winding.number(&(middle + normal * step)));
    before <= 0 && behind > 0
}

/// The normal of a polygon, as long as twice its area.
fn area_normal(part: &[Vector3<f64>]) -> Vector3<f64> {
    let fan = part.windows(2).skip(1);
    fan.map(|pair| (pair[0] - part[0]).cross(&(pair[1] - part[0])))
        .sum()
}

/// Adds a convex part as triangles.
fn add_fan(hull: &mut TriangleMesh, part: &[Vector3<f64>]) {
    let first = hull.vertices.len();
    hull.vertices.extend_from_slice(part);
    for k in 1..part.len() - 1 {
        let triangle = [first, first + k, first + k + 1];
        let [a, b, c] = triangle.map(|v| hull.vertices[v]);
        if (b - a).cross(&(c - a)).norm() > EMPTY {
            hull.triangles.push(triangle);
        }
    }
}
