//! Normal force \[N\] and pressure \[Pa\] of the body on each vertex of a drape, without friction.
//!
//! Both follow from the shape alone: the layer on the skin (see `body.rs`) presses harder the
//! deeper a vertex lies in it, that on the middles of edges (see `chord.rs`) on their ends, and
//! that on places near tips of the body (see `tip.rs`) on the corners of their triangles.

use crate::scene::Scene;
use crate::solver::forces::Potential;
use crate::solver::forces::contact::{chord, kept_distance, layer};
use crate::solver::model::body_contact::tip_contact;
use crate::solver::model::rest_shape::{rest_area, vertex_areas};
use nalgebra::Vector3;

/// Returns the normal force of the body on each vertex \[N\], zero where they do not touch; `#V`
/// for `positions` \[m\] of `#V`.
///
/// The forces on the vertices of one particle, where a seam is closed, add up to the force on the
/// particle.
pub fn contact_force(scene: &Scene, positions: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let Some(body) = &scene.body else {
        return vec![Vector3::zeros(); positions.len()];
    };
    let press = |p: &Vector3<f64>, offset: f64, area: f64| match body.sample(p) {
        Some(near) if near.distance < offset => {
            let pressure = scene.body_hardness * layer::pressure(offset - near.distance);
            near.normal * (area * pressure)
        }
        _ => Vector3::zeros(),
    };
    let offset = kept_distance(scene);
    let vertices = positions.iter().zip(vertex_areas(scene));
    let mut force: Vec<_> = vertices.map(|(p, area)| press(p, offset, area)).collect();
    for &[a, b, c] in &scene.mesh.triangles {
        let area = rest_area([a, b, c].map(|v| scene.mesh.uv[v])) / 3.0;
        for (i, j) in [(a, b), (b, c), (c, a)] {
            let middle = (positions[i] + positions[j]) * 0.5;
            let half = press(&middle, chord::OFFSET, area) * 0.5;
            force[i] += half;
            force[j] += half;
        }
    }
    if let Some(mut tips) = tip_contact(scene, body, scene.mesh.triangles.clone()) {
        tips.accept(positions);
        tips.add_force(positions, &mut force);
    }
    force
}

/// Returns the pressure of the body on the cloth at each vertex \[Pa\]: the normal force over the
/// area that the cloth has there as it lies, a third of each triangle; `#V` for `positions` \[m\]
/// of `#V`.
pub fn contact_pressure(scene: &Scene, positions: &[Vector3<f64>]) -> Vec<f64> {
    let mut area = vec![0.0; positions.len()];
    for triangle in &scene.mesh.triangles {
        let [p, q, r] = triangle.map(|v| positions[v]);
        let third = (q - p).cross(&(r - p)).norm() / 6.0;
        for &v in triangle {
            area[v] += third;
        }
    }
    contact_force(scene, positions)
        .iter()
        .zip(area)
        .map(|(force, area)| if area > 0.0 { force.norm() / area } else { 0.0 })
        .collect()
}
