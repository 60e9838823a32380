//! The order of panels from the body outwards: ranks of the layers that a garment names, and the
//! area in which they lie in the wrong order.

use super::crossings::{indices, single};
use super::garment::PanelSpec;
use crate::scene::Scene;
use nalgebra::Vector3;
use seamster_crossings::{SegmentSearch, Surface};
use std::collections::BTreeSet;

/// Length of a ray outwards \[m\]: what is further out does not lie on the cloth, but hangs away
/// from it or belongs to another part of the body.
const REACH: f64 = 0.05;
/// Least cosine between the body's normals at both ends of a ray: else they belong to other parts
/// of it, such as the two legs.
const SAME_WAY: f64 = 0.5;

/// Returns the rank of each panel's layer, counted from the body; empty if all are in one.
pub(super) fn ranks(specs: &[PanelSpec]) -> Vec<usize> {
    let layers: BTreeSet<i32> = specs.iter().map(|spec| spec.layer).collect();
    if layers.len() < 2 {
        return vec![];
    }
    let rank = |spec: &PanelSpec| layers.range(..spec.layer).count();
    specs.iter().map(rank).collect()
}

/// Returns the area of the triangles from the middle of which a ray along the body's normal meets a
/// lower layer further out \[m²\], at `positions` \[m\] in the precision in which meshes are
/// written; none where panels have no order, there is no avatar, or looking at `pairs` of a ray and
/// a triangle does not do.
pub(super) fn wrong_area(scene: &Scene, positions: &[Vector3<f64>], pairs: usize) -> Option<f64> {
    let avatar = scene.body.as_ref()?.avatar()?;
    if scene.layers.is_empty() {
        return None;
    }
    let (points, triangles) = (single(positions), indices(&scene.mesh.triangles));
    let surface = Surface::new(&points, &triangles, &[]).ok()?;
    let mut search = SegmentSearch::new(&surface, pairs);
    let layer = |triangle: usize| scene.layers[scene.mesh.panel_of_triangle(triangle)];
    let outwards = |p: &Vector3<f64>| avatar.outward(p);
    let mut wrong = 0.0;
    for (t, corners) in scene.mesh.triangles.iter().enumerate() {
        let own = layer(t);
        let [a, b, c] = corners.map(|v| positions[v]);
        let middle = (a + b + c) / 3.0;
        let Some(normal) = outwards(&middle).filter(|_| own > 0) else {
            continue;
        };
        let ends = single(&[middle, middle + normal * REACH]);
        let met = search.meeting([ends[0], ends[1]]).ok()?;
        let is_wrong = met.iter().any(|&(u, point)| {
            let normal_there = outwards(&Vector3::from(point));
            layer(u as usize) < own && normal_there.is_some_and(|n| n.dot(&normal) > SAME_WAY)
        });
        if is_wrong {
            wrong += 0.5 * (b - a).cross(&(c - a)).norm();
        }
    }
    Some(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Limits;
    use crate::fit::{Garment, ShippedAssets, resolve, scene};
    use crate::pattern::Panel;
    use crate::progress::CancelToken;
    use crate::solver::Context;
    use serde_json::json;

    /// Two squares in front of the default dress form, the second one smaller, in these layers.
    fn patches(layers: [i32; 2]) -> Scene {
        let place = |layer: i32| json!({"layer": layer, "placement": {"at": "torso_front"}});
        let garment = json!({
            "pattern": {"name": "patches", "source": {"format": "dxf", "units": "m", "scale_to_m": 1.0, "allowance": "none"},
                "panels": [Panel::rectangle("large", [0.12; 2]), Panel::rectangle("small", [0.06; 2])]},
            "seams": [], "panels": {"large": place(layers[0]), "small": place(layers[1])},
            "simulate": {"edge_length_m": 0.015},
        });
        let garment: Garment = serde_json::from_value(garment).expect("a garment");
        let limits = Limits::default();
        let resolved = resolve(garment, &ShippedAssets, &limits).expect("it is right");
        let context = Context {
            cpu_s: &|| 0.0,
            cancel: &CancelToken::new(),
            progress: &mut |_| {},
            limits: &limits,
        };
        scene(&resolved, &context).expect("it can be assembled")
    }

    /// Both squares before the middle of the chest, the large one `gap` \[m\] from it and the small
    /// one 5 mm further out.
    fn stacked(scene: &Scene, gap: f64) -> Vec<Vector3<f64>> {
        let avatar = scene.body.as_ref().and_then(|body| body.avatar());
        let form = avatar.expect("the default form");
        let [_, z] = form.section_bounds(1.2).expect("a section of the chest");
        let place = |(v, uv): (usize, &[f64; 2])| {
            let is_small = scene.mesh.panels[1].vertices.contains(&v);
            let (side, z) = if is_small {
                (0.06, z[1] + gap + 0.005)
            } else {
                (0.12, z[1] + gap)
            };
            Vector3::new(uv[0] - 0.5 * side, 1.2 + uv[1] - 0.5 * side, z)
        };
        scene.mesh.uv.iter().enumerate().map(place).collect()
    }

    #[test]
    fn ranks_count_the_layers_that_are_named() {
        let specs = [7, -3, 0, 7].map(|layer| PanelSpec {
            layer,
            ..PanelSpec::default()
        });
        assert_eq!(ranks(&specs), [2, 0, 1, 2]);
        assert!(ranks(&specs[..1]).is_empty());
    }

    /// All of the lower square lies on the other, so all of its area is in the wrong order.
    #[test]
    fn the_wrong_order_is_measured_and_the_right_one_is_zero() {
        let area = |layers: [i32; 2], gap: f64| {
            let mut scene = patches(layers);
            let mut shape = stacked(&scene, gap);
            let right = wrong_area(&scene, &shape, usize::MAX);
            // Swapped: the small one beneath the large one.
            let first = scene.mesh.panels[1].vertices.start;
            shape[first..].iter_mut().for_each(|p| p.z -= 0.01);
            let swapped = wrong_area(&scene, &shape, usize::MAX);
            assert_eq!(wrong_area(&scene, &shape, 0), None);
            scene.body = None;
            assert_eq!(wrong_area(&scene, &shape, usize::MAX), None);
            (right.expect("judged"), swapped.expect("judged"))
        };
        // Near the body, and as far from it as a flared skirt hangs.
        for gap in [0.02, 0.06] {
            let (right, swapped) = area([0, 1], gap);
            assert_eq!(right, 0.0);
            assert!((swapped - 0.06 * 0.06).abs() < 1e-9, "{swapped}");
        }
        // Of the large one only what lies beneath the small one counts.
        let (wrong, right) = area([5, -5], 0.02);
        assert_eq!(right, 0.0);
        assert!(
            wrong > 0.5 * 0.06 * 0.06 && wrong < 2.0 * 0.06 * 0.06,
            "{wrong}"
        );
    }

    #[test]
    fn a_garment_in_one_layer_is_not_judged() {
        let scene = patches([3, 3]);
        assert!(scene.layers.is_empty());
        assert_eq!(wrong_area(&scene, &stacked(&scene, 0.02), usize::MAX), None);
    }

    #[test]
    fn a_higher_layer_starts_further_out() {
        let scene = patches([0, 1]);
        let z = |panel: usize| scene.start[scene.mesh.panels[panel].vertices.start].z;
        assert!(z(1) > z(0) + 0.005, "{} {}", z(0), z(1));
    }
}
