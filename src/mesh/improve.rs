//! Better triangles: points inside are moved, taken out and put in until none is thin that need not
//! be.

use super::delaunay::Domain;
use super::geometry::{area, smallest_angle};
use super::panel_triangles::PanelTriangles;
use super::segment_grid::SegmentGrid;
use crate::pattern::point::{self, Point2, distance, lerp};
use crate::progress::CancelToken;
use std::collections::BTreeSet;

/// Distance that lattice points keep from the boundary, as a share of the mesh edge length.
pub(super) const CLEARANCE: f64 = 0.6;

/// Rounds of smoothing alone, then of taking out and putting in with smoothing after each.
const SMOOTHING_ROUNDS: usize = 3;
const REPAIR_ROUNDS: usize = 8;

/// Sweeps over all points between two triangulations.
const SWEEPS: usize = 3;

/// Move, as a share of the size of the triangles round a point, below which it is not made.
const SETTLED: f64 = 1e-3;

/// Angle below which a triangle is thin \[rad\]: 25 degrees, so that 20 is kept with room.
const THIN: f64 = 25.0 * std::f64::consts::PI / 180.0;

/// Longest mesh edge inside, as a share of the mesh edge length, before a point is put on it.
const LONG: f64 = 1.5;

/// Height over a short boundary part, as a share of its length, at which a point is put: an angle
/// of 37 degrees.
const APEX: f64 = 1.5;

/// Triangulates the boundary with the points `inside` it and improves them; the best of all rounds
/// is kept.
pub(super) fn improve(
    domain: &Domain,
    clearance: &SegmentGrid,
    inside: Vec<Point2>,
    cancel: &CancelToken,
) -> PanelTriangles {
    let fixed = domain.boundary_count();
    let mut mesh = triangulate(domain, &inside);
    let mut best: Option<(MeshFlaws, PanelTriangles)> = None;
    for round in 0..SMOOTHING_ROUNDS + REPAIR_ROUNDS {
        smooth(&mut mesh, fixed);
        mesh = triangulate(domain, &mesh.points[fixed..]);
        let flaws = MeshFlaws::of(&mesh);
        if best.as_ref().is_none_or(|(least, _)| flaws.is_below(least)) {
            best = Some((flaws, mesh.clone()));
        }
        if cancel.is_canceled() {
            break;
        }
        if round + 1 >= SMOOTHING_ROUNDS {
            let inside = repaired(&mesh, domain, clearance);
            if inside == mesh.points[fixed..] {
                break;
            }
            mesh = triangulate(domain, &inside);
        }
    }
    best.map_or(mesh, |(_, mesh)| mesh)
}

/// Flaws of a mesh: its thin triangles, then its smallest angle.
struct MeshFlaws {
    thin: usize,
    smallest: f64,
}

impl MeshFlaws {
    fn of(mesh: &PanelTriangles) -> Self {
        let angles = mesh.triangles.iter().map(|t| mesh.smallest_angle(*t));
        angles.fold(
            Self {
                thin: 0,
                smallest: f64::INFINITY,
            },
            |all, angle| Self {
                thin: all.thin + usize::from(angle < THIN),
                smallest: all.smallest.min(angle),
            },
        )
    }

    fn is_below(&self, other: &Self) -> bool {
        self.thin < other.thin || self.thin == other.thin && self.smallest > other.smallest
    }
}

/// Triangulates, leaving out the points that ended in no triangle.
fn triangulate(domain: &Domain, inside: &[Point2]) -> PanelTriangles {
    let mut triangles = domain.triangles(inside);
    let fixed = domain.boundary_count();
    let mut number = vec![usize::MAX; fixed + inside.len()];
    for &vertex in triangles.iter().flatten() {
        number[vertex] = vertex;
    }
    let mut points = domain.boundary().to_vec();
    for (index, &point) in inside.iter().enumerate() {
        if number[fixed + index] != usize::MAX {
            number[fixed + index] = points.len();
            points.push(point);
        }
    }
    for vertex in triangles.iter_mut().flatten() {
        if *vertex >= fixed {
            *vertex = number[*vertex];
        }
    }
    PanelTriangles { points, triangles }
}

/// Moves each inside point to the centroid of the triangles round it (CPT smoothing, Chen and Holst
/// 2011), as far as that makes none of them worse than it may be.
fn smooth(mesh: &mut PanelTriangles, fixed: usize) {
    let mut stars = vec![vec![]; mesh.points.len()];
    for &triangle in &mesh.triangles {
        for turn in 0..3 {
            let [v, next, last] = [0, 1, 2].map(|k| triangle[(turn + k) % 3]);
            stars[v].push([next, last]);
        }
    }
    for _ in 0..SWEEPS {
        for (v, star) in stars.iter().enumerate().skip(fixed) {
            move_point(&mut mesh.points, v, star);
        }
    }
}

fn move_point(points: &mut [Point2], v: usize, star: &[[usize; 2]]) {
    let here = points[v];
    let (goal, star_area) = centroid(points, here, star);
    // Most points lie in the lattice and are where they should be.
    if distance(here, goal) < SETTLED * star_area.sqrt() {
        return;
    }
    let worst = |p: Point2| {
        let angles = star
            .iter()
            .map(|&[a, b]| smallest_angle([p, points[a], points[b]]));
        angles.fold(f64::INFINITY, f64::min)
    };
    let before = worst(here).min(THIN * 1.2);
    let steps = [1.0, 0.5, 0.25].map(|share| lerp(here, goal, share));
    if let Some(&better) = steps.iter().find(|&&p| worst(p) >= before) {
        points[v] = better;
    }
}

/// Centroid of the triangles round a point, and their area.
fn centroid(points: &[Point2], p: Point2, star: &[[usize; 2]]) -> (Point2, f64) {
    let mut sum = [0.0; 2];
    let mut whole = 0.0;
    for &[a, b] in star {
        let (a, b) = (points[a], points[b]);
        let weight = area(p, a, b);
        whole += weight;
        for k in 0..2 {
            sum[k] += weight * (a[k] + b[k] - 2.0 * p[k]) / 3.0;
        }
    }
    ([0, 1].map(|k| p[k] + sum[k] / whole), whole)
}

/// The inside points after taking out those that make triangles thin and putting in those that are
/// missing.
fn repaired(mesh: &PanelTriangles, domain: &Domain, clearance: &SegmentGrid) -> Vec<Point2> {
    let fixed = domain.boundary_count();
    let edge_length = clearance.reach() / CLEARANCE;
    let mut out = BTreeSet::new();
    let mut put: Vec<Point2> = vec![];
    for &triangle in &mesh.triangles {
        let sides = sorted_sides(mesh, triangle);
        let longest = sides[2];
        let new = if mesh.smallest_angle(triangle) < THIN {
            let [a, b, _] = sides[0];
            let inner = a.max(b);
            if inner >= fixed {
                // One at a time is taken out of a neighborhood, or a gap is torn.
                if !triangle.iter().any(|v| out.contains(v)) {
                    out.insert(inner);
                }
                None
            } else {
                apex(mesh, sides[0], domain)
            }
        } else if side_length(mesh, longest) > LONG * edge_length {
            let middle = lerp(mesh.points[longest[0]], mesh.points[longest[1]], 0.5);
            clearance.is_clear(middle, 0.9).then_some(middle)
        } else {
            None
        };
        if let Some(point) = new {
            let near = 0.6 * side_length(mesh, sides[0]);
            let mut others = triangle.iter().map(|&v| &mesh.points[v]).chain(&put);
            if others.all(|&p| distance(p, point) > near) {
                put.push(point);
            }
        }
    }
    let kept = (fixed..mesh.points.len()).filter(|v| !out.contains(v));
    kept.map(|v| mesh.points[v])
        .chain(put.iter().copied())
        .collect()
}

/// Two vertices and the one opposite, from the shortest side to the longest.
fn sorted_sides(mesh: &PanelTriangles, triangle: [usize; 3]) -> [[usize; 3]; 3] {
    let mut sides = [0, 1, 2].map(|i| [0, 1, 2].map(|k| triangle[(i + k) % 3]));
    sides.sort_by(|a, b| side_length(mesh, *a).total_cmp(&side_length(mesh, *b)));
    sides
}

fn side_length(mesh: &PanelTriangles, [a, b, _]: [usize; 3]) -> f64 {
    distance(mesh.points[a], mesh.points[b])
}

/// A point over a short boundary part whose triangle reaches too far; none if that is not what is
/// wrong.
fn apex(mesh: &PanelTriangles, [a, b, opposite]: [usize; 3], domain: &Domain) -> Option<Point2> {
    let (p, q) = (mesh.points[a], mesh.points[b]);
    let [x, y] = point::sub(q, p);
    let middle = lerp(p, q, 0.5);
    let point = [middle[0] - y * APEX, middle[1] + x * APEX];
    let length = x.hypot(y);
    (domain.is_fixed(a, b) && distance(middle, mesh.points[opposite]) > 2.0 * APEX * length)
        .then_some(point)
}
