//! Mean and largest value of a map on each panel and beside each zone of the body.

use super::shape_map::ShapeMap;
use crate::fit::zone::{self, Zone};
use crate::scene::{Body, Scene};
use crate::solver::{MapPart, MapSummary, vertex_areas};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Returns the summary of a map.
pub(super) fn summary(
    map: &ShapeMap,
    (scene, names): (&Scene, &[&str]),
    positions: &[Vector3<f64>],
) -> MapSummary {
    let areas = vertex_areas(scene);
    let part =
        |name: &str, vertices: &[usize]| part(name, vertices, (&map.values, &areas), positions);
    let panels = names.iter().zip(&scene.mesh.panels);
    let panels =
        panels.map(|(name, range)| part(name, &range.vertices.clone().collect::<Vec<_>>()));
    MapSummary {
        name: map.name.to_owned(),
        unit: map.unit.to_owned(),
        error: map.error,
        panels: panels.collect(),
        zones: zones(scene, positions)
            .iter()
            .map(|(zone, vertices)| part(zone.name(), vertices))
            .collect(),
    }
}

/// Returns the vertices beside each zone of the body, if there is one.
fn zones(scene: &Scene, positions: &[Vector3<f64>]) -> BTreeMap<Zone, Vec<usize>> {
    let mut zones: BTreeMap<_, Vec<usize>> = BTreeMap::new();
    if let Some(Body::Avatar(avatar)) = &scene.body {
        for (v, p) in positions.iter().enumerate() {
            zones.entry(zone::of(avatar, p)).or_default().push(v);
        }
    }
    zones
}

fn part(
    name: &str,
    vertices: &[usize],
    (values, areas): (&[f64], &[f64]),
    positions: &[Vector3<f64>],
) -> MapPart {
    let area: f64 = vertices.iter().map(|&v| areas[v]).sum();
    let sum: f64 = vertices.iter().map(|&v| areas[v] * values[v]).sum();
    let most = vertices
        .iter()
        .copied()
        .max_by(|&a, &b| values[a].total_cmp(&values[b]));
    MapPart {
        name: name.to_owned(),
        area_m2: area,
        mean: if area > 0.0 { sum / area } else { 0.0 },
        max: most.map_or(0.0, |v| values[v]),
        max_at_m: most.map_or([0.0; 3], |v| positions[v].into()),
    }
}
