//! Cloth that does not move: the garments that another one is worn over.

use nalgebra::Vector3;
use std::ops::Range;

/// Cloth that does not move, with two sides and a thickness. Only contact knows it: it has neither
/// mass nor forces of its own, and is no part of the garment's mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FixedCloth {
    /// Positions of the vertices \[m\]; `#V`.
    pub vertices: Vec<Vector3<f64>>,
    /// Thickness of the cloth at each vertex \[m\]; `#V`.
    pub thickness_m: Vec<f64>,
    /// Coulomb coefficient of the cloth at each vertex; `#V`.
    pub friction: Vec<f64>,
    /// Corners of the triangles; `#T`.
    pub triangles: Vec<[usize; 3]>,
    /// The parts that it consists of, in the order of the triangles.
    pub panels: Vec<FixedPanel>,
}

/// A panel of fixed cloth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FixedPanel {
    /// Name in reports.
    pub name: String,
    /// Its triangles.
    pub triangles: Range<usize>,
}

impl FixedCloth {
    /// Returns the area that each vertex stands for: a third of each of its triangles \[m²\].
    pub fn vertex_areas(&self) -> Vec<f64> {
        let mut areas = vec![0.0; self.vertices.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.vertices[v]);
            let third = (b - a).cross(&(c - a)).norm() / 6.0;
            triangle.iter().for_each(|&v| areas[v] += third);
        }
        areas
    }
}
