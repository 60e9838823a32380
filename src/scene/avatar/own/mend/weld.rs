//! Vertices at one place made one: files split them where texture coordinates or normals differ.

use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;
use std::collections::HashSet;

/// Returns the surface with equal vertices made one, without the triangles that then have a corner
/// twice or stand twice, and without vertices that no triangle has.
pub(in super::super) fn weld(surface: &TriangleMesh) -> TriangleMesh {
    let representative = representatives(surface);
    let mut seen = HashSet::with_capacity(surface.triangles.len());
    let mut triangles = Vec::with_capacity(surface.triangles.len());
    for triangle in &surface.triangles {
        let [a, b, c] = triangle.map(|v| representative[v]);
        let mut key = [a, b, c];
        key.sort_unstable();
        if a != b && b != c && c != a && seen.insert(key) {
            triangles.push([a, b, c]);
        }
    }
    compact(&surface.vertices, &triangles)
}

/// Returns the surface of triangles, without the vertices that none of them has.
pub(super) fn compact(vertices: &[Vector3<f64>], triangles: &[[usize; 3]]) -> TriangleMesh {
    const UNUSED: usize = usize::MAX;
    let mut number = vec![UNUSED; vertices.len()];
    let mut surface = TriangleMesh::default();
    for triangle in triangles {
        let corners = triangle.map(|v| {
            if number[v] == UNUSED {
                number[v] = surface.vertices.len();
                surface.vertices.push(vertices[v]);
            }
            number[v]
        });
        surface.triangles.push(corners);
    }
    surface
}

/// The first vertex at the place of each one.
fn representatives(surface: &TriangleMesh) -> Vec<usize> {
    // adding 0 makes -0 equal to 0
    let place = |v: usize| surface.vertices[v].map(|x| x + 0.0);
    let mut order: Vec<usize> = (0..surface.vertices.len()).collect();
    order.sort_unstable_by(|&a, &b| {
        let (p, q) = (place(a), place(b));
        let by_place = p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
        by_place.then(p.z.total_cmp(&q.z)).then(a.cmp(&b))
    });
    let mut representative: Vec<usize> = (0..surface.vertices.len()).collect();
    for pair in order.windows(2) {
        if place(pair[0]) == place(pair[1]) {
            representative[pair[1]] = representative[pair[0]];
        }
    }
    representative
}
