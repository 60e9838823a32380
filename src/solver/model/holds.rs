//! The hold of cloth while its seams close.

use crate::scene::Scene;
use crate::solver::forces::ParticleHold;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::rest_shape::vertex_areas;
use nalgebra::Vector3;

/// Stiffness of the hold of panels on their places at the start, per area \[N/m³\]: a shirt held by
/// it sinks by 50 mm under its own weight.
const HOLD: f64 = 30.0;
/// Stiffness of the hold of what carries a garment once it is sewn, per area \[N/m³\]: a skirt that
/// is pulled together beside it does not draw its waistband over the hip.
const FIRM_HOLD: f64 = 3e4;

/// What is held while seams close, and where.
#[derive(Clone, Copy)]
pub(crate) struct SewingHold<'a> {
    /// Panels that are held firmly where they are: what carries the garment, once it is sewn.
    pub(crate) panels: &'a [usize],
    /// Place of each vertex when these seams began to close \[m\]; empty without such panels.
    pub(crate) places: &'a [Vector3<f64>],
}

/// Returns the hold of each particle on its place at the start, free along the mean normal of the
/// triangles about it; that of a firmly held panel on where it is, every way.
pub(super) fn holds(
    scene: &Scene,
    dof_map: &DofMap,
    SewingHold { panels, places }: &SewingHold<'_>,
) -> Vec<ParticleHold> {
    let area = dof_map.sum(&vertex_areas(scene));
    let place = dof_map.average(&scene.start);
    let mut normal = vec![Vector3::zeros(); dof_map.count];
    for t in dof_map.triangles(&scene.mesh.triangles) {
        let [a, b, c] = t.map(|i| place[i]);
        for i in t {
            normal[i] += (b - a).cross(&(c - a));
        }
    }
    let weak = |((place, normal), area): ((&Vector3<f64>, &Vector3<f64>), &f64)| ParticleHold {
        place: *place,
        free: normal.try_normalize(0.0).unwrap_or_default(),
        stiffness: HOLD * area,
    };
    let mut holds: Vec<_> = place.iter().zip(&normal).zip(&area).map(weak).collect();
    for &panel in *panels {
        for vertex in scene.mesh.panels[panel].vertices.clone() {
            let particle = dof_map.of_vertex[vertex];
            holds[particle] = ParticleHold {
                place: places[vertex],
                free: Vector3::zeros(),
                stiffness: FIRM_HOLD * area[particle],
            };
        }
    }
    holds
}
