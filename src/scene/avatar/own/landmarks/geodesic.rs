//! Distances along the edges of a surface.

use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Neighbors of each vertex.
pub(super) struct EdgeGraph {
    first: Vec<usize>,
    next: Vec<usize>,
}

impl EdgeGraph {
    pub(super) fn new(surface: &TriangleMesh) -> Self {
        let count = surface.vertices.len();
        let edges = || {
            surface
                .triangles
                .iter()
                .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
        };
        let mut first = vec![0; count + 1];
        for (a, _) in edges() {
            first[a + 1] += 1;
        }
        for v in 0..count {
            first[v + 1] += first[v];
        }
        let mut place = first.clone();
        let mut next = vec![0; first[count]];
        for (a, b) in edges() {
            next[place[a]] = b;
            place[a] += 1;
        }
        Self { first, next }
    }

    /// The vertices at the other ends of the edges from `v`: on a closed surface each edge leaves
    /// both its ends once.
    pub(super) fn neighbors(&self, v: usize) -> &[usize] {
        &self.next[self.first[v]..self.first[v + 1]]
    }
}

/// Returns the distance of each vertex from vertex `from` along edges between vertices that `may`
/// be passed (E. W. Dijkstra, 1959) \[m\]; infinite where there is no way.
pub(super) fn distances(
    (surface, graph): (&TriangleMesh, &EdgeGraph),
    from: usize,
    may: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let place = |v: usize| surface.vertices[v];
    let mut distance = vec![f64::INFINITY; surface.vertices.len()];
    distance[from] = 0.0;
    // distances of one sign are in the order of their bits
    let mut queue = BinaryHeap::from([Reverse((0.0_f64.to_bits(), from))]);
    while let Some(Reverse((bits, v))) = queue.pop() {
        if f64::from_bits(bits) > distance[v] {
            continue;
        }
        for &w in graph.neighbors(v) {
            let length: f64 = (place(w) - place(v)).norm();
            let through = distance[v] + length;
            if through < distance[w] && may(w) {
                distance[w] = through;
                queue.push(Reverse((through.to_bits(), w)));
            }
        }
    }
    distance
}

/// Returns the middle of the line of points at distance `at` from where `distance` is 0 \[m\].
pub(super) fn middle_of_ring(
    surface: &TriangleMesh,
    distance: &[f64],
    at: f64,
) -> Option<Vector3<f64>> {
    let (mut sum, mut total) = (Vector3::zeros(), 0.0);
    for triangle in &surface.triangles {
        let mut ends = Vec::with_capacity(2);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            let (from, to) = (distance[a], distance[b]);
            if (from < at) != (to < at) && from.is_finite() && to.is_finite() {
                let share = (at - from) / (to - from);
                let [p, q] = [a, b].map(|v| surface.vertices[v]);
                ends.push(p + (q - p) * share);
            }
        }
        if let [p, q] = ends[..] {
            let length = (q - p).norm();
            sum += (p + q) * (0.5 * length);
            total += length;
        }
    }
    (total > 0.0).then(|| sum / total)
}
