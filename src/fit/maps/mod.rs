//! Maps on a draped garment (P11): how far the cloth is stretched, how hard the body presses on it,
//! how far it stands off; each with its error from the mesh levels.

mod shape_map;
mod strain;
mod summary;

pub use shape_map::ShapeMap;

use super::garment::MapKind;
use crate::export::GarmentMesh;
use crate::scene::{self, Body, Scene};
use crate::solver::{self, Drape, MapSummary, kept_distance};
use nalgebra::Vector3;
use strain::Strains;
use summary::ClothParts;

/// Adds the maps that are wanted of a drape of a scene, whose panels have these names, to its mesh,
/// and returns their summaries.
pub(super) fn add(
    kinds: &[MapKind],
    (scene, names): (&Scene, &[&str]),
    drape: &Drape,
    mesh: &mut GarmentMesh,
) -> Vec<MapSummary> {
    let maps = shape_maps(kinds, scene, drape);
    let parts = ClothParts::new(scene, names, &drape.positions);
    let summaries = maps.iter().map(|map| parts.summary(map)).collect();
    for (panel, range) in mesh.panels.iter_mut().zip(&scene.mesh.panels) {
        for map in &maps {
            let values = map.values[range.vertices.clone()].to_vec();
            *(map.place)(&mut panel.maps) = values;
        }
    }
    summaries
}

/// Returns the maps of a drape of a scene, those of each kind once, with their errors; those of the
/// body only where there is one.
///
/// The error of a map is how much it differs from that of the next coarser mesh, carried over to
/// this one.
pub fn shape_maps(kinds: &[MapKind], scene: &Scene, drape: &Drape) -> Vec<ShapeMap> {
    let mut maps = maps(kinds, scene, &drape.positions);
    let handed_on = drape.handed_on.as_ref();
    if let Some(coarser) = handed_on.and_then(|shape| coarser_maps(kinds, scene, shape)) {
        for (map, coarser) in maps.iter_mut().zip(&coarser) {
            map.error = rms(&map.values, coarser);
        }
    }
    maps
}

/// Returns the maps of a shape \[m; `#V`\] without their errors.
fn maps(kinds: &[MapKind], scene: &Scene, positions: &[Vector3<f64>]) -> Vec<ShapeMap> {
    let mut maps = vec![];
    let mut map = |name, unit, place, values| {
        maps.push(ShapeMap {
            name,
            unit,
            error: None,
            values,
            place,
        });
    };
    if kinds.contains(&MapKind::Strain) {
        let Strains { warp, weft, share } = Strains::of(scene, positions);
        map("strain_warp", "1", |maps| &mut maps.strain_warp, warp);
        map("strain_weft", "1", |maps| &mut maps.strain_weft, weft);
        map("strain_share", "1", |maps| &mut maps.strain_share, share);
    }
    if let Some(body) = &scene.body {
        if kinds.contains(&MapKind::Pressure) {
            let pressure = solver::contact_pressure(scene, positions);
            let in_kpa = pressure.into_iter().map(|p| 1e-3 * p).collect();
            map("pressure", "kPa", |maps| &mut maps.pressure_kpa, in_kpa);
        }
        if kinds.contains(&MapKind::Gap) {
            let gaps = gaps(scene, body, positions);
            map("gap", "mm", |maps| &mut maps.gap_mm, gaps);
        }
    }
    maps
}

/// Returns the gap between each vertex and the body \[mm\]: its distance less the one that contact
/// keeps, 0 in contact; within the body its depth, negative.
fn gaps(scene: &Scene, body: &Body, positions: &[Vector3<f64>]) -> Vec<f64> {
    let kept = kept_distance(scene);
    let gap = |p: &Vector3<f64>| {
        let distance = body.exact_distance(p);
        1e3 * if distance < 0.0 {
            distance
        } else {
            (distance - kept).max(0.0)
        }
    };
    positions.iter().map(gap).collect()
}

/// Returns the maps of the next coarser mesh, carried over to this one, to which it handed on
/// `shape` \[m; `#V`\].
fn coarser_maps(kinds: &[MapKind], scene: &Scene, shape: &[Vector3<f64>]) -> Option<Vec<Vec<f64>>> {
    let coarser = scene::coarser(scene)?;
    let own: Vec<_> = coarser.finer.iter().map(|&v| shape[v]).collect();
    let maps = maps(kinds, &coarser.scene, &own).into_iter().map(|map| {
        let at =
            |corners: &[(usize, f64); 3]| corners.iter().map(|(v, w)| map.values[*v] * w).sum();
        coarser.weights.iter().map(at).collect()
    });
    Some(maps.collect())
}

/// Returns the RMS difference of two maps; none of empty ones.
fn rms(a: &[f64], b: &[f64]) -> Option<f64> {
    let sum: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (!a.is_empty()).then(|| (sum / a.len() as f64).sqrt())
}
