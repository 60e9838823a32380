//! Builds a system from a scene: its particles and the terms that act on them.

pub use crate::solver::model::membrane::springs;

use crate::scene::{Fabric, Scene};
use crate::solver::forces::contact::{BodyContact, Chord, ChordContact, ClothContact, Friction};
use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::forces::{BendForce, Gravity, Hold, ParticleHold, SewingForce, WindForce};
use crate::solver::model::bending::bend_patches;
use crate::solver::model::cloth_surface::{cloth_surface, layer_friction};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::membrane::membrane_force;
use crate::solver::model::rest_shape::{rest_area, vertex_areas};
use crate::solver::model::seams::Seams;
use crate::solver::model::system::{System, TimedTerm};
use crate::solver::options::SolverOptions;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Distance that cloth is kept from the skin, besides half its thickness \[m\]: what keeps the
/// middles of triangles, which cut across the body's curves, outside too (an edge of 12 mm sags 0.9
/// mm into a shoulder of 20 mm radius).
const SKIN_OFFSET: f64 = 2e-3;

/// Distance for which explicit steps carry on a sample of the body \[m\]: third-order terms stay
/// below 1e-11 m.
const EXPLICIT_REUSE: f64 = 2e-5;

/// Stiffness by which sewing holds panels on their places, over their area \[N/m³\]: at 50 mm as
/// much as a shirt weighs.
const HOLD: f64 = 30.0;

/// Seams, loads and contact of a system, besides the cloth of its scene.
pub(crate) struct BuildOptions<'a> {
    /// Joint of the stitches.
    pub(crate) seams: Seams,
    /// True if panels are held weakly where they were placed.
    pub(crate) hold: bool,
    /// True if weight and wind act.
    pub(crate) gravity: bool,
    /// Friction anchors to begin with; none without friction.
    pub(crate) friction: Option<&'a FrictionAnchors>,
    /// True for explicit steps, which are many and small.
    pub(crate) explicit: bool,
    /// Thickness that cloth has at least where it touches itself \[m\]; none if cloth may pass
    /// through cloth.
    pub(crate) least_thickness: Option<f64>,
    /// True on the mesh asked for: there the middles of edges are kept off the body too, and layers
    /// of cloth rub on each other. The edges of coarser meshes cut so far into the body that
    /// pushing them out would stretch the garment; their thick cloth, with friction, locks where it
    /// is crumpled (a shirt with bands did not come to rest on 275 vertices).
    pub(crate) finest: bool,
}

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
        // The pressure of the skin acts over the area of the cloth: harder skin is more of it.
        let mut area = dof_map.sum(&vertex_areas(scene));
        area.iter_mut()
            .for_each(|area| *area *= scene.body_hardness);
        let anchors = build_options.friction.filter(|_| scene.friction > 0.0);
        let friction = anchors.map(|a| Friction::new(scene.friction, mass.len()).with_anchors(a));
        let reuse = if build_options.explicit {
            EXPLICIT_REUSE
        } else {
            0.0
        };
        let contact = BodyContact::new(body.clone(), kept_distance(scene), &area)
            .with_friction(friction)
            .with_reuse(reuse);
        forces.push(Box::new(contact));
        if build_options.finest {
            let chords = chords(scene, &dof_map);
            forces.push(Box::new(ChordContact::new(body.clone(), chords, reuse)));
        }
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

/// Returns the edges of the mesh, each with a third of the area of the triangles beside it.
fn chords(scene: &Scene, dof_map: &DofMap) -> Vec<Chord> {
    let mut areas: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for t in &scene.mesh.triangles {
        let third = rest_area(t.map(|v| scene.mesh.uv[v])).abs() / 3.0;
        let [a, b, c] = t.map(|v| dof_map.of_vertex[v]);
        for [i, j] in [[a, b], [b, c], [c, a]] {
            if i != j {
                *areas.entry([i.min(j), i.max(j)]).or_default() += third;
            }
        }
    }
    let chord = |(ends, area): ([usize; 2], f64)| Chord {
        ends,
        area: area * scene.body_hardness,
    };
    areas.into_iter().map(chord).collect()
}

/// Returns true if anything of the scene resists bending.
pub(crate) fn bends(scene: &Scene) -> bool {
    let rigidity = |f: &Fabric| f.bending_warp_n_m.max(f.bending_weft_n_m);
    let fabrics = scene.fabrics.iter().map(rigidity);
    let has_triangles = !scene.mesh.triangles.is_empty();
    has_triangles && fabrics.fold(scene.least_bending_n_m, f64::max) > 0.0
}

/// Returns the distance that cloth is kept from the skin \[m\].
pub fn kept_distance(scene: &Scene) -> f64 {
    let thickness = scene.fabrics.iter().map(|f| f.thickness_m);
    SKIN_OFFSET + 0.5 * thickness.fold(0.0, f64::max)
}
