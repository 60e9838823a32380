//! What the body does to each vertex of a drape across its skin: pressure \[Pa\] and force \[N\], friction left out.
//!
//! Both follow from the shape alone: the layer on the skin (see `body.rs`) presses by its stiffness times how deep a vertex lies in it.

use super::body::LAYER_STIFFNESS;
use crate::scene::Scene;
use crate::solver::assemble::{kept_distance, vertex_areas};
use nalgebra::Vector3;

/// Pressure of the body on each vertex \[Pa\], 0 where they do not touch; `#V` for `positions` \[m\] of `#V`.
pub fn contact_pressure(scene: &Scene, positions: &[Vector3<f64>]) -> Vec<f64> {
    presses(scene, positions).map(|(p, _)| p).collect()
}

/// Normal force of the body on each vertex \[N\]: its pressure times the cloth area of the vertex; `#V` for `positions` \[m\] of `#V`.
///
/// The forces on the vertices of one particle, where a seam is closed, add up to the force on the particle.
pub fn contact_force(scene: &Scene, positions: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    presses(scene, positions)
        .zip(vertex_areas(scene))
        .map(|((pressure, normal), area)| normal * (pressure * area))
        .collect()
}

/// Pressure on each vertex and the way in which it presses.
fn presses(scene: &Scene, positions: &[Vector3<f64>]) -> impl Iterator<Item = (f64, Vector3<f64>)> {
    let offset = kept_distance(scene);
    positions.iter().map(move |p| {
        let near = scene.body.as_ref().and_then(|body| body.sample(p));
        match near.filter(|near| near.distance < offset) {
            Some(near) => (LAYER_STIFFNESS * (offset - near.distance), near.normal),
            None => (0.0, Vector3::zeros()),
        }
    })
}
