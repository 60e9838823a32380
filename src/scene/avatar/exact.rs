//! The exact signed distance of a closed surface.

use super::TriangleMesh;
use super::hull::Hull;
use super::tree::{Feature, Nearest, Tree};
use super::winding::Winding;
use nalgebra::Vector3;

/// Distances by the nearest point, signs by angle-weighted pseudonormals, which tell inside from
/// outside at edges and corners as well (J. A. Bærentzen, H. Aanæs, "Signed distance computation
/// using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005).
#[derive(Clone, Debug)]
pub(super) struct ExactDistance {
    tree: Tree,
    normals: Vec<Normals>,
    /// The triangle beyond each edge of a triangle.
    neighbors: Vec<[usize; 3]>,
    bounds: [Vector3<f64>; 2],
    /// Of a surface that crosses itself: they tell inside from outside.
    winding: Option<Winding>,
}

/// Outward directions of a triangle; only their signs against a vector matter, so the edges' are
/// not of length 1.
#[derive(Clone, Copy, Debug, Default)]
struct Normals {
    face: Vector3<f64>,
    edges: [Vector3<f64>; 3],
    corners: [Vector3<f64>; 3],
}

impl ExactDistance {
    /// For a surface that passed its check.
    pub(super) fn new(surface: &TriangleMesh) -> Self {
        let corners = || {
            surface
                .triangles
                .iter()
                .flatten()
                .map(|&v| surface.vertices[v])
        };
        let lower = corners().fold(Vector3::repeat(f64::INFINITY), |l, v| l.inf(&v));
        let upper = corners().fold(Vector3::repeat(f64::NEG_INFINITY), |u, v| u.sup(&v));
        let (normals, neighbors) = normals(surface);
        Self {
            tree: Tree::new(surface),
            normals,
            neighbors,
            bounds: [lower, upper],
            winding: None,
        }
    }

    /// For the outside of a surface that crosses itself.
    pub(super) fn of_hull(hull: Hull) -> Self {
        let corners = || {
            let corners = hull.surface.triangles.iter().flatten();
            corners.map(|&v| hull.surface.vertices[v])
        };
        let lower = corners().fold(Vector3::repeat(f64::INFINITY), |l, v| l.inf(&v));
        let upper = corners().fold(Vector3::repeat(f64::NEG_INFINITY), |u, v| u.sup(&v));
        Self {
            tree: Tree::new(&hull.surface),
            normals: Vec::new(),
            neighbors: Vec::new(),
            bounds: [lower, upper],
            winding: Some(hull.winding),
        }
    }

    /// Returns the triangle of a hull that is nearer to `p` than `squared` \[m²\], with its own
    /// squared distance; none if none is, or if triangles have neighbors to search along.
    pub(super) fn nearer_on_hull(&self, p: &Vector3<f64>, squared: f64) -> Option<(usize, f64)> {
        self.winding.as_ref()?;
        let nearest = self.tree.nearest(p, squared.sqrt())?;
        Some((nearest.triangle, nearest.distance_squared))
    }

    /// Returns true if triangles have no neighbors.
    pub(super) fn is_hull(&self) -> bool {
        self.winding.is_some()
    }

    /// Lowest and highest coordinates of the surface \[m\].
    pub(super) fn bounds(&self) -> [Vector3<f64>; 2] {
        self.bounds
    }

    /// Signed distance \[m\], negative inside; NaN where `p` is no point.
    pub(super) fn signed(&self, p: &Vector3<f64>) -> f64 {
        self.tree
            .nearest(p, f64::INFINITY)
            .map_or(f64::NAN, |nearest| self.sign(p, &nearest))
    }

    /// The triangles beyond the edges of a triangle.
    pub(super) fn neighbors(&self, triangle: usize) -> [usize; 3] {
        self.neighbors[triangle]
    }

    /// Returns true if `p`, which is nearest to `point` on this feature of a triangle, is inside.
    pub(super) fn is_inside(
        &self,
        p: &Vector3<f64>,
        (triangle, feature, point): (usize, Feature, Vector3<f64>),
    ) -> bool {
        if let Some(winding) = &self.winding {
            return winding.number(p) > 0;
        }
        self.normal(triangle, feature).dot(&(p - point)) < 0.0
    }

    /// The point of the surface nearest to `p` \[m\]; `p` where it is no point.
    pub(super) fn nearest(&self, p: &Vector3<f64>) -> Vector3<f64> {
        self.tree.nearest(p, f64::INFINITY).map_or(*p, |n| n.point)
    }

    fn sign(&self, p: &Vector3<f64>, nearest: &Nearest) -> f64 {
        if let Some(winding) = &self.winding {
            let side = if winding.number(p) > 0 { -1.0 } else { 1.0 };
            return side * nearest.distance_squared.sqrt();
        }
        let normal = self.normal(nearest.triangle, nearest.feature);
        nearest
            .distance_squared
            .sqrt()
            .copysign(normal.dot(&(p - nearest.point)))
    }

    fn normal(&self, triangle: usize, feature: Feature) -> Vector3<f64> {
        let normals = &self.normals[triangle];
        match feature {
            Feature::Face => normals.face,
            Feature::Edge(k) => normals.edges[k],
            Feature::Corner(k) => normals.corners[k],
        }
    }
}

fn normals(surface: &TriangleMesh) -> (Vec<Normals>, Vec<[usize; 3]>) {
    let mut at_vertex = vec![Vector3::zeros(); surface.vertices.len()];
    // (lower vertex, higher vertex, triangle, which edge of it): the two users of an edge come to
    // lie side by side
    let mut edges = Vec::with_capacity(3 * surface.triangles.len());
    let mut normals = vec![Normals::default(); surface.triangles.len()];
    let mut neighbors = vec![[0; 3]; surface.triangles.len()];
    for (t, triangle) in surface.triangles.iter().enumerate() {
        let corners = surface.corners(t);
        let face = (corners[1] - corners[0])
            .cross(&(corners[2] - corners[0]))
            .normalize();
        normals[t].face = face;
        for k in 0..3 {
            let [here, next, last] = [k, (k + 1) % 3, (k + 2) % 3].map(|k| corners[k]);
            at_vertex[triangle[k]] += face * (next - here).angle(&(last - here));
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            edges.push((a.min(b), a.max(b), t, k));
        }
    }
    edges.sort_unstable();
    for pair in edges.chunks_exact(2) {
        let sum = normals[pair[0].2].face + normals[pair[1].2].face;
        for (&(_, _, t, k), &(_, _, other, _)) in pair.iter().zip(pair.iter().rev()) {
            normals[t].edges[k] = sum;
            neighbors[t][k] = other;
        }
    }
    for (normals, triangle) in normals.iter_mut().zip(&surface.triangles) {
        normals.corners = triangle.map(|v| at_vertex[v]);
    }
    (normals, neighbors)
}
