//! The left half of a body in the making: grids of vertices, then both halves.

use super::TriangleMesh;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// The half at x >= 0; its border lies in the plane x = 0.
#[derive(Debug, Default)]
pub(super) struct HalfMesh {
    vertices: Vec<Vector3<f64>>,
    triangles: Vec<[usize; 3]>,
}

impl HalfMesh {
    /// Adds a row of vertices; returns their indices.
    pub(super) fn row(&mut self, points: &[Vector3<f64>]) -> Vec<usize> {
        let first = self.vertices.len();
        self.vertices.extend_from_slice(points);
        (first..self.vertices.len()).collect()
    }

    pub(super) fn point(&self, vertex: usize) -> Vector3<f64> {
        self.vertices[vertex]
    }

    /// Adds the two triangles of a quadrilateral `[a, b]` above `[c, d]`, by its shorter diagonal.
    pub(super) fn quad(&mut self, [a, b]: [usize; 2], [c, d]: [usize; 2]) {
        let length = |i: usize, j: usize| (self.vertices[i] - self.vertices[j]).norm();
        let pair = if length(b, c) <= length(a, d) {
            [[a, c, b], [b, c, d]]
        } else {
            [[a, c, d], [a, d, b]]
        };
        self.triangles.extend(pair);
    }

    /// Adds the strip between two loops of as many vertices.
    pub(super) fn band(&mut self, above: &[usize], below: &[usize]) {
        for k in 0..above.len() {
            let next = (k + 1) % above.len();
            self.quad([above[k], above[next]], [below[k], below[next]]);
        }
    }

    /// Closes a loop by a fan about a point.
    pub(super) fn cap(&mut self, above: &[usize], pole: Vector3<f64>) {
        let pole = self.row(&[pole])[0];
        for k in 0..above.len() {
            let next = (k + 1) % above.len();
            self.triangles.push([above[k], pole, above[next]]);
        }
    }

    pub(super) fn triangle(&mut self, triangle: [usize; 3]) {
        self.triangles.push(triangle);
    }

    /// Fairs the surface at `free` vertices: lets its bending energy go down, vertices near their
    /// neighbors' means of means, and the others where they are.
    pub(super) fn fair(&mut self, free: &[usize], rounds: usize) {
        let neighbors = self.neighbors();
        let mut near: Vec<usize> = free
            .iter()
            .flat_map(|&v| neighbors[v].iter().copied().chain([v]))
            .collect();
        near.sort_unstable();
        near.dedup();
        let mut bend = vec![Vector3::zeros(); self.vertices.len()];
        for _ in 0..rounds {
            for &v in &near {
                bend[v] = umbrella(&self.vertices, &neighbors, v, &self.vertices);
            }
            let moves: Vec<_> = free
                .iter()
                .map(|&v| umbrella(&self.vertices, &neighbors, v, &bend))
                .collect();
            for (&v, step) in free.iter().zip(moves) {
                self.vertices[v] -= step * 0.2;
            }
        }
    }

    fn neighbors(&self) -> Vec<Vec<usize>> {
        let mut neighbors = vec![Vec::new(); self.vertices.len()];
        for &[a, b, c] in &self.triangles {
            for (i, j) in [(a, b), (b, c), (c, a)] {
                neighbors[i].push(j);
                neighbors[j].push(i);
            }
        }
        for list in &mut neighbors {
            list.sort_unstable();
            list.dedup();
        }
        neighbors
    }

    /// Both halves, joined where x = 0, without the vertices that no triangle has.
    pub(super) fn mirrored(self) -> TriangleMesh {
        let mut surface = TriangleMesh::default();
        let mut left = BTreeMap::new();
        let mut right = BTreeMap::new();
        for &v in self.triangles.iter().flatten() {
            if left.contains_key(&v) {
                continue;
            }
            let p = self.vertices[v];
            left.insert(v, surface.vertices.len());
            right.insert(v, surface.vertices.len());
            surface.vertices.push(p);
            if p.x != 0.0 {
                right.insert(v, surface.vertices.len());
                surface.vertices.push(Vector3::new(-p.x, p.y, p.z));
            }
        }
        for triangle in &self.triangles {
            surface.triangles.push(triangle.map(|v| left[&v]));
            let [a, b, c] = triangle.map(|v| right[&v]);
            surface.triangles.push([a, c, b]);
        }
        surface
    }
}

/// Mean of the neighbors' values less the vertex's own; in the plane x = 0 with the other half's.
fn umbrella(
    points: &[Vector3<f64>],
    neighbors: &[Vec<usize>],
    v: usize,
    values: &[Vector3<f64>],
) -> Vector3<f64> {
    let in_middle = points[v].x == 0.0;
    let (mut sum, mut weight) = (Vector3::zeros(), 0.0);
    for &n in &neighbors[v] {
        let share = if in_middle && points[n].x != 0.0 {
            2.0
        } else {
            1.0
        };
        sum += values[n] * share;
        weight += share;
    }
    let mut step = sum / weight - values[v];
    if in_middle {
        step.x = 0.0;
    }
    step
}
