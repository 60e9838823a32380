//! Mean and largest value of a map on each panel and beside each zone of the body.

use super::shape_map::ShapeMap;
use crate::fit::zone::{self, Zone};
use crate::scene::{Body, Scene};
use crate::solver::{MapPart, MapSummary, vertex_areas};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// The parts of a draped garment on which maps are summed up.
pub(super) struct ClothParts<'a> {
    positions: &'a [Vector3<f64>],
    /// Area of each vertex on the pattern \[m²\]; `#V`.
    areas: Vec<f64>,
    /// Names of the panels, and their vertices.
    panels: Vec<(&'a str, Vec<usize>)>,
    /// Vertices beside each zone of the body, if there is one.
    zones: BTreeMap<Zone, Vec<usize>>,
}

impl<'a> ClothParts<'a> {
    /// The parts of a scene whose panels have these names, as it lies \[m; `#V`\].
    pub(super) fn new(scene: &Scene, names: &[&'a str], positions: &'a [Vector3<f64>]) -> Self {
        let panels = names.iter().zip(&scene.mesh.panels);
        let mut zones: BTreeMap<_, Vec<usize>> = BTreeMap::new();
        if let Some(Body::Avatar(avatar)) = &scene.body {
            for (v, p) in positions.iter().enumerate() {
                zones.entry(zone::of(avatar, p)).or_default().push(v);
            }
        }
        Self {
            positions,
            areas: vertex_areas(scene),
            panels: panels
                .map(|(name, range)| (*name, range.vertices.clone().collect()))
                .collect(),
            zones,
        }
    }

    pub(super) fn summary(&self, map: &ShapeMap) -> MapSummary {
        let panels = self.panels.iter();
        let zones = self.zones.iter();
        MapSummary {
            name: map.name.to_owned(),
            unit: map.unit.to_owned(),
            error: map.error,
            panels: panels
                .map(|(name, vertices)| self.part(name, vertices, &map.values))
                .collect(),
            zones: zones
                .map(|(zone, vertices)| self.part(zone.name(), vertices, &map.values))
                .collect(),
        }
    }

    fn part(&self, name: &str, vertices: &[usize], values: &[f64]) -> MapPart {
        let areas = &self.areas;
        let area: f64 = vertices.iter().map(|&v| areas[v]).sum();
        let sum: f64 = vertices.iter().map(|&v| areas[v] * values[v]).sum();
        let largest = vertices.iter().copied();
        let largest = largest.max_by(|&a, &b| values[a].total_cmp(&values[b]));
        MapPart {
            name: name.to_owned(),
            area_m2: area,
            mean: if area > 0.0 { sum / area } else { 0.0 },
            max: largest.map_or(0.0, |v| values[v]),
            max_at_m: largest.map_or([0.0; 3], |v| self.positions[v].into()),
        }
    }
}
