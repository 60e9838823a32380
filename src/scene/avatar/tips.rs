//! Tips of a body: what stands out of it sharply.

use super::TriangleMesh;
use super::field::DistanceField;
use super::tree::Tree;
use nalgebra::Vector3;

/// The triangles of a body that are at its tips.
#[derive(Clone, Debug)]
pub struct Tips(Tree);

impl Tips {
    /// Finds the triangles where the smooth distance has a curvature above `sharpness` \[1/m\];
    /// none if there are none.
    pub(super) fn new(
        surface: &TriangleMesh,
        field: &DistanceField,
        sharpness: f64,
    ) -> Option<Self> {
        let is_sharp = |p| {
            let sample = field.sample(p);
            sample.is_some_and(|s| s.curvature.symmetric_eigenvalues().max() > sharpness)
        };
        let is_sharp: Vec<bool> = surface.vertices.iter().map(is_sharp).collect();
        let triangles = surface.triangles.iter().enumerate();
        let sharp = triangles.filter(|(_, t)| t.iter().any(|&v| is_sharp[v]));
        let sharp: Vec<usize> = sharp.map(|(t, _)| t).collect();
        (!sharp.is_empty()).then(|| Self(Tree::of(surface, sharp)))
    }

    /// Distance of a point from the nearest tip, or `within` \[m\] if that is less.
    pub fn distance(&self, p: &Vector3<f64>, within: f64) -> f64 {
        let nearest = self.0.nearest(p, within);
        nearest.map_or(within, |nearest| nearest.distance_squared.sqrt())
    }
}
