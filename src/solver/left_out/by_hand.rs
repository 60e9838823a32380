//! A program that puts together by hand the two terms of a hung sheet, and nothing else.

use crate::scene::Scene;
use crate::solver::forces::{ContinuumForce, Gravity, MembraneTriangle, Potential};
use crate::solver::model::system::{System, TimedTerm};
use nalgebra::Vector3;

/// A clock that stands still.
pub(crate) fn no_clock() -> f64 {
    0.0
}

/// Stretch alone, or with weight, of a scene whose cloth is cut along its warp.
pub(crate) fn system(scene: &Scene, weight: bool) -> System<'static> {
    let mut forces: Vec<Box<dyn Potential>> = vec![Box::new(ContinuumForce::new(membranes(scene)))];
    if weight {
        forces.push(Box::new(Gravity {
            weight: scene.mass.iter().map(|m| scene.gravity * *m).collect(),
            start: scene.start.clone(),
        }));
    }
    let terms = forces.into_iter();
    let mut is_fixed = vec![false; scene.mass.len()];
    for &pin in &scene.pins {
        is_fixed[pin] = true;
    }
    System {
        mass: scene.mass.clone(),
        is_fixed,
        fixed_axis: None,
        terms: terms
            .map(|potential| TimedTerm {
                potential,
                cpu_s: 0.0,
            })
            .collect(),
        clock: &no_clock,
    }
}

fn membranes(scene: &Scene) -> Vec<MembraneTriangle> {
    let (fabric, edge) = (&scene.fabrics[0], scene.mesh.mean_edge());
    let moduli = [
        fabric.stretch_warp_n_m,
        fabric.stretch_weft_n_m,
        fabric.shear_n_m,
    ];
    let of_triangle = |t: &[usize; 3]| {
        let membrane = MembraneTriangle::new(*t, t.map(|v| scene.mesh.uv[v]), moduli)?;
        Some(membrane.with_buckling([0.0; 2], edge))
    };
    scene
        .mesh
        .triangles
        .iter()
        .filter_map(of_triangle)
        .collect()
}

/// Bytes \[B\] of the arrays of [`system`] that has as many particles and triangles, counted from
/// what they hold.
pub(crate) fn bytes_of_arrays(scene: &Scene, weight: bool) -> usize {
    let vectors = if weight { 2 } else { 0 };
    let of_particle = size_of::<f64>() + size_of::<bool>() + vectors * size_of::<Vector3<f64>>();
    scene.mass.len() * of_particle + scene.mesh.triangles.len() * size_of::<MembraneTriangle>()
}
