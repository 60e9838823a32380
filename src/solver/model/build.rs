//! Builds a system from a scene: its particles and the terms that act on them.

pub use crate::solver::model::membrane::springs;

use crate::scene::{Fabric, Scene};
use crate::solver::forces::contact::ClothContact;
use crate::solver::forces::{BendForce, Gravity, Hold, ParticleHold, SewingForce, WindForce};
use crate::solver::model::bending::bend_patches;
use crate::solver::model::body_contact::body_contact;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::cloth_surface::{cloth_surface, layer_friction};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::membrane::membrane_force;
use crate::solver::model::rest_shape::vertex_areas;
use crate::solver::model::system::{System, TimedTerm};
use crate::solver::options::SolverOptions;
use nalgebra::Vector3;

/// Stiffness by which sewing holds panels on their places, over their area \[N/m³\]: at 50 mm as
/// much as a shirt weighs.
const HOLD: f64 = 30.0;

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
    if let Some((stitches, stiffness)) = build_options.seams.springs(scene) {
        let pairs = dof_map.pairs(&stitches);
        forces.push(Box::new(SewingForce::new(pairs, stiffness)));
    }
    if build_options.hold {
        forces.push(Box::new(Hold::new(holds(scene, &dof_map))));
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

/// Returns the hold of each particle on its place at the start, free along the mean normal of the
/// triangles about it.
fn holds(scene: &Scene, dof_map: &DofMap) -> Vec<ParticleHold> {
    let area = dof_map.sum(&vertex_areas(scene));
    let place = dof_map.average(&scene.start);
    let mut normal = vec![Vector3::zeros(); dof_map.count];
    for t in dof_map.triangles(&scene.mesh.triangles) {
        let [a, b, c] = t.map(|i| place[i]);
        for i in t {
            normal[i] += (b - a).cross(&(c - a));
        }
    }
    let of_particle =
        |((place, normal), area): ((&Vector3<f64>, &Vector3<f64>), f64)| ParticleHold {
            place: *place,
            free: normal.try_normalize(0.0).unwrap_or_default(),
            stiffness: HOLD * area,
        };
    place
        .iter()
        .zip(&normal)
        .zip(area)
        .map(of_particle)
        .collect()
}

/// Returns true if anything of the scene resists bending.
pub(crate) fn bends(scene: &Scene) -> bool {
    let rigidity = |f: &Fabric| f.bending_warp_n_m.max(f.bending_weft_n_m);
    let fabrics = scene.fabrics.iter().map(rigidity);
    let has_triangles = !scene.mesh.triangles.is_empty();
    has_triangles && fabrics.fold(scene.least_bending_n_m, f64::max) > 0.0
}
