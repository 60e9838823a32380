//! Builds a system from a scene: its particles and the terms that act on them.

pub use crate::solver::model::membrane::springs;

use crate::scene::{Fabric, Scene};
use crate::solver::forces::contact::ClothContact;
use crate::solver::forces::{BendForce, Gravity, Hold, WindForce};
use crate::solver::model::bending::bend_patches;
use crate::solver::model::body_contact::body_contact;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::cloth_surface::{cloth_surface, layer_friction};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::holds::holds;
use crate::solver::model::membrane::membrane_force;
use crate::solver::model::system::{System, TimedTerm};
use crate::solver::options::SolverOptions;
use nalgebra::Vector3;

/// A system, and the particle of each vertex of the scene that it was built from.
pub(crate) struct Model<'a> {
    pub(crate) dof_map: DofMap,
    pub(crate) system: System<'a>,
}

/// Builds the particles of a scene and the terms that act on them: only those that it needs.
pub(crate) fn build<'a>(
    scene: &Scene,
    options: &SolverOptions,
    build_options: &BuildOptions<'_>,
    clock: &'a dyn Fn() -> f64,
) -> Model<'a> {
    let dof_map = build_options.seams.dof_map(scene);
    let mass = dof_map.sum(&scene.mass);
    let mut forces = vec![membrane_force(scene, options.membrane, &dof_map)];
    let patches = bends(scene).then(|| bend_patches(scene, &dof_map));
    if let Some(patches) = patches.filter(|patches| !patches.is_empty()) {
        forces.push(Box::new(BendForce::new(patches)));
    }
    if build_options.gravity && scene.gravity != Vector3::zeros() {
        let weight = mass.iter().map(|m| scene.gravity * *m).collect();
        forces.push(Box::new(Gravity {
            weight,
            start: dof_map.average(&scene.start),
        }));
    }
    // Wind acts as weight does: on a garment that is sewn.
    if let Some(wind) = scene.wind.filter(|_| build_options.gravity) {
        let triangles = dof_map.triangles(&scene.mesh.triangles);
        let start = dof_map.average(&scene.start);
        forces.push(Box::new(WindForce::new(wind, triangles, &start)));
    }
    if let Some(springs) = build_options.seams.springs(scene, &dof_map) {
        forces.push(Box::new(springs));
    }
    if let Some(held) = &build_options.hold {
        forces.push(Box::new(Hold::new(holds(scene, &dof_map, held))));
    }
    let mut is_fixed = vec![false; mass.len()];
    for &pin in &scene.pins {
        is_fixed[dof_map.of_vertex[pin]] = true;
    }
    if let Some(body) = &scene.body {
        forces.extend(body_contact(scene, body, &dof_map, build_options));
    }
    if let Some(least_thickness) = build_options.least_thickness {
        let (surface, area) = cloth_surface(scene, &dof_map, least_thickness);
        let friction = build_options.finest && build_options.friction.is_some();
        let friction = friction.then(|| layer_friction(scene, &dof_map)).flatten();
        let contact = ClothContact::new(surface, area).with_friction(friction);
        forces.push(Box::new(contact));
    }
    let terms = forces
        .into_iter()
        .map(|potential| TimedTerm {
            potential,
            cpu_s: 0.0,
        })
        .collect();
    let system = System {
        mass,
        is_fixed,
        fixed_axis: scene.fixed_axis,
        terms,
        clock,
    };
    Model { dof_map, system }
}

/// Returns true if anything of the scene resists bending.
pub(crate) fn bends(scene: &Scene) -> bool {
    let rigidity = |f: &Fabric| f.bending_warp_n_m.max(f.bending_weft_n_m);
    let fabrics = scene.fabrics.iter().map(rigidity);
    let has_triangles = !scene.mesh.triangles.is_empty();
    has_triangles && fabrics.fold(scene.least_bending_n_m, f64::max) > 0.0
}
