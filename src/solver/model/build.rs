//! From a scene to the particles and terms of one stage: sewing, or the drape that follows.

pub use crate::solver::model::membrane::springs;

use crate::scene::{Fabric, Scene};
use crate::solver::forces::contact::{BodyContact, Friction, FrictionAnchors};
use crate::solver::forces::{BendForce, Gravity, SewingForce, WindForce};
use crate::solver::model::bending::bend_patches;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::membrane::membrane_force;
use crate::solver::model::rest_shape::vertex_areas;
use crate::solver::model::system::{System, TimedTerm};
use crate::solver::options::SolverOptions;
use nalgebra::Vector3;

/// Distance that cloth is kept from the skin, besides half its thickness \[m\]: what keeps the middles of triangles, which
/// cut across the body's curves, outside too (an edge of 12 mm sags 0.9 mm into a shoulder of 20 mm radius).
const SKIN_OFFSET: f64 = 2e-3;

/// Distance for which explicit steps carry on a sample of the body \[m\]: third-order terms stay below 1e-11 m.
const EXPLICIT_REUSE: f64 = 2e-5;

/// What one stage of a fit asks for.
pub(crate) struct Stage<'a> {
    /// Which vertices are one particle.
    pub(crate) dof_map: &'a DofMap,
    /// Vertex pairs that a spring pulls together, and its stiffness \[N/m\].
    pub(crate) stitches: Option<(Vec<(usize, usize)>, f64)>,
    /// Whether weight acts.
    pub(crate) gravity: bool,
    /// Where the body holds cloth by friction to begin with; none without friction.
    pub(crate) friction: Option<&'a FrictionAnchors>,
    /// Whether steps are many and small.
    pub(crate) explicit: bool,
}

/// The particles and terms of `stage`.
pub(crate) fn assemble<'a>(
    scene: &Scene,
    options: &SolverOptions,
    stage: &Stage<'_>,
    clock: &'a dyn Fn() -> f64,
) -> System<'a> {
    let dof_map = stage.dof_map;
    let mass = dof_map.sum(&scene.mass);
    let mut forces = vec![membrane_force(scene, options.membrane, dof_map)];
    let patches = bends(scene).then(|| bend_patches(scene, dof_map));
    if let Some(patches) = patches.filter(|patches| !patches.is_empty()) {
        forces.push(Box::new(BendForce::new(patches)));
    }
    if stage.gravity && scene.gravity != Vector3::zeros() {
        let weight = mass.iter().map(|m| scene.gravity * *m).collect();
        forces.push(Box::new(Gravity {
            weight,
            start: dof_map.average(&scene.start),
        }));
    }
    // Wind acts as weight does: on a garment that is sewn.
    if let Some(wind) = scene.wind.filter(|_| stage.gravity) {
        let triangles = particle_triangles(scene, dof_map);
        let start = dof_map.average(&scene.start);
        forces.push(Box::new(WindForce::new(wind, triangles, &start)));
    }
    if let Some((stitches, stiffness)) = &stage.stitches {
        let pairs = dof_map.pairs(stitches);
        forces.push(Box::new(SewingForce::new(pairs, *stiffness)));
    }
    let mut is_fixed = vec![false; mass.len()];
    for &pin in &scene.pins {
        is_fixed[dof_map.of_vertex[pin]] = true;
    }
    let contact = scene.body.as_ref().map(|body| {
        let area = dof_map.sum(&vertex_areas(scene));
        let held = stage.friction.filter(|_| scene.friction > 0.0);
        let friction =
            held.map(|held| Friction::new(scene.friction, mass.len()).with_anchors(held));
        BodyContact::new(body.clone(), kept_distance(scene), &area)
            .with_friction(friction)
            .with_reuse(if stage.explicit { EXPLICIT_REUSE } else { 0.0 })
    });
    let terms = forces
        .into_iter()
        .map(|potential| TimedTerm {
            potential,
            cpu_s: 0.0,
        })
        .collect();
    System {
        mass,
        is_fixed,
        fixed_axis: scene.fixed_axis,
        terms,
        contact,
        contact_cpu_s: 0.0,
        clock,
    }
}

/// Whether anything of the scene resists bending.
pub(crate) fn bends(scene: &Scene) -> bool {
    let rigidity = |f: &Fabric| f.bending_warp_n_m.max(f.bending_weft_n_m);
    let fabrics = scene.fabrics.iter().map(rigidity);
    let has_triangles = !scene.mesh.triangles.is_empty();
    has_triangles && fabrics.fold(scene.least_bending_n_m, f64::max) > 0.0
}

/// Distance that cloth is kept from the skin \[m\].
pub fn kept_distance(scene: &Scene) -> f64 {
    let thickness = scene.fabrics.iter().map(|f| f.thickness_m);
    SKIN_OFFSET + 0.5 * thickness.fold(0.0, f64::max)
}

pub(crate) fn particle_triangles(scene: &Scene, dof_map: &DofMap) -> Vec<[usize; 3]> {
    let of_vertex = |t: &[usize; 3]| t.map(|v| dof_map.of_vertex[v]);
    scene.mesh.triangles.iter().map(of_vertex).collect()
}
