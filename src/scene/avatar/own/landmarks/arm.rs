//! The joints of the arms, whatever their pose: along the middles of rings about them, from the
//! tip of the hand.

use super::geodesic::{EdgeGraph, distances, middle_of_ring};
use crate::scene::avatar::TriangleMesh;
use crate::scene::avatar::slice::girth_across;
use nalgebra::Vector3;

/// Shares of the height of a person between which the wrist is from the tip of the hand, along the
/// skin.
const WRIST: [f64; 2] = [0.095, 0.135];
/// Length of an arm with its hand along the skin, as a share of the height, at least.
const ARM: f64 = 0.3;
/// Rings between two places.
const RINGS: usize = 24;
/// Shares of the arm between which the elbow is looked for, and where it is in a straight arm.
const ELBOW: [f64; 2] = [0.45, 0.57];
const STRAIGHT: f64 = 0.505;
/// Share by which a bend must fit the middles better than the straight place does.
const BENT: f64 = 0.7;
/// Share of the height below which only legs are.
const LOW: f64 = 0.2;

/// The tips of the hands, left and right, where there are hands.
pub(super) fn hand_tips(
    (surface, graph): (&TriangleMesh, &EdgeGraph),
    (crotch, neck, height): (f64, f64, f64),
    from: &Vector3<f64>,
) -> [Option<usize>; 2] {
    let legs = part(graph, surface, |p| p.y < crotch, |p| p.y < LOW * height);
    let head = part(
        graph,
        surface,
        |p| p.y > neck,
        |p| p.y > 0.5 * (neck + height),
    );
    let start = nearest_vertex(surface, from);
    let distance = distances((surface, graph), start, |v| !legs[v]);
    [1.0, -1.0].map(|side| {
        let own = |v: &usize| {
            surface.vertices[*v].x * side > 0.0
                && !legs[*v]
                && !head[*v]
                && distance[*v].is_finite()
        };
        let own = (0..surface.vertices.len()).filter(own);
        own.max_by(|a, b| distance[*a].total_cmp(&distance[*b]))
    })
}

/// Marks the vertices within `inside` that hang together with those of `seed` there.
fn part(
    graph: &EdgeGraph,
    surface: &TriangleMesh,
    inside: impl Fn(&Vector3<f64>) -> bool,
    seed: impl Fn(&Vector3<f64>) -> bool,
) -> Vec<bool> {
    let is_in = |v: usize| inside(&surface.vertices[v]);
    let mut marks = vec![false; surface.vertices.len()];
    let is_seed = |v: &usize| is_in(*v) && seed(&surface.vertices[*v]);
    let mut stack: Vec<usize> = (0..surface.vertices.len()).filter(is_seed).collect();
    for &v in &stack {
        marks[v] = true;
    }
    while let Some(v) = stack.pop() {
        for &w in graph.neighbors(v) {
            if !marks[w] && is_in(w) {
                marks[w] = true;
                stack.push(w);
            }
        }
    }
    marks
}

fn nearest_vertex(surface: &TriangleMesh, to: &Vector3<f64>) -> usize {
    let off = |v: &usize| (surface.vertices[*v] - to).norm_squared();
    let all = 0..surface.vertices.len();
    all.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
}

/// Finds elbow and wrist of the arm from `joint`, whose hand ends at vertex `tip`.
pub(super) fn elbow_and_wrist(
    (surface, graph): (&TriangleMesh, &EdgeGraph),
    (joint, tip): (Vector3<f64>, usize),
    height: f64,
) -> Option<[Vector3<f64>; 2]> {
    let distance = distances((surface, graph), tip, |_| true);
    let end = {
        let near = nearest_vertex(surface, &joint);
        distance[near]
    };
    let ring = |at: f64| middle_of_ring(surface, &distance, at);
    let [low, high] = WRIST.map(|share| share * height);
    if end < ARM * height {
        return None;
    }
    let wrists = (0..=RINGS).filter_map(|k| {
        let at = low + (high - low) * k as f64 / RINGS as f64;
        let (here, up) = (ring(at)?, ring(at + 0.03)?);
        let girth = girth_across(surface, &here, &(up - here))?;
        Some((girth, at, here))
    });
    let (_, at, wrist) = wrists.min_by(|a, b| a.0.total_cmp(&b.0))?;
    // near the joint, rings begin to go round the trunk
    let last = at + 0.8 * (end - at);
    let middles: Vec<_> = (0..=RINGS)
        .filter_map(|k| ring(at + (last - at) * k as f64 / RINGS as f64))
        .collect();
    Some([elbow(&joint, &wrist, &middles)?, wrist])
}

/// The place among the middles of an arm at which it bends, or that of a straight arm.
fn elbow(
    joint: &Vector3<f64>,
    wrist: &Vector3<f64>,
    middles: &[Vector3<f64>],
) -> Option<Vector3<f64>> {
    let length = (wrist - joint).norm();
    let share = |p: &Vector3<f64>| (p - joint).norm() / ((p - joint).norm() + (wrist - p).norm());
    let misfit = |p: &Vector3<f64>| {
        let squares = middles.iter().map(|q| {
            let to_upper = distance_to_segment(q, joint, p);
            to_upper.min(distance_to_segment(q, p, wrist)).powi(2)
        });
        squares.sum::<f64>() + 1e-9 * length * length
    };
    let nearest_to = |at: f64| {
        let off = |p: &&Vector3<f64>| (share(p) - at).abs();
        middles.iter().min_by(|a, b| off(a).total_cmp(&off(b)))
    };
    let straight = nearest_to(STRAIGHT)?;
    let bends = middles
        .iter()
        .filter(|p| (ELBOW[0]..ELBOW[1]).contains(&share(p)));
    let bent = bends.min_by(|a, b| misfit(a).total_cmp(&misfit(b)))?;
    let best = if misfit(bent) < BENT * misfit(straight) {
        bent
    } else {
        straight
    };
    Some(*best)
}

fn distance_to_segment(p: &Vector3<f64>, a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let along = b - a;
    let share = ((p - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (a + along * share - p).norm()
}
