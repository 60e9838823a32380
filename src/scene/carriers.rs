//! Panels that carry a garment, which are sewn before what hangs from them.
//!
//! Pulled together all at once, the gores of a wide skirt draw an open waistband down over the hip
//! on their way to it, and it closes below, for good.

use super::Avatar;
use super::crotch::is_between_legs;
use crate::mesh::{ClothMesh, Stitch};
use nalgebra::Vector3;

/// Depth below the top of a garment, or below the shoulders, that panels which carry it reach
/// above \[m\].
const CARRYING: f64 = 0.12;

/// Returns the panels that reach the top of a garment, or the shoulders, if they are sewn to each
/// other before and behind the body, and others hang from them; none if the garment orders its
/// seams itself. Of trousers there are none: where their band comes to lie, the crotch says too.
pub(super) fn carriers(mesh: &ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) -> Vec<usize> {
    let is_ordered = mesh.stitches.iter().any(|stitch| stitch.stage != 0);
    if is_ordered || has_legs(mesh, start, avatar) {
        return vec![];
    }
    let high = high_panels(mesh, start, avatar);
    let (between, others): (Vec<&Stitch>, Vec<&Stitch>) =
        mesh.stitches.iter().partition(|stitch| {
            high[mesh.panel_of_vertex(stitch.a)] && high[mesh.panel_of_vertex(stitch.b)]
        });
    let middle = avatar.landmarks.get("crotch").map_or(0.0, |p| p.z);
    let ends = between.iter().flat_map(|stitch| [stitch.a, stitch.b]);
    let sides: Vec<bool> = ends.map(|vertex| start[vertex].z > middle).collect();
    if others.is_empty() || !sides.contains(&true) || !sides.contains(&false) {
        return vec![];
    }
    (0..high.len()).filter(|&panel| high[panel]).collect()
}

/// Returns true if there is a seam from front to back between the legs.
fn has_legs(mesh: &ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) -> bool {
    let mut ends = mesh.stitches.iter().map(|s| [start[s.a], start[s.b]]);
    let crotch = avatar.landmarks.get("crotch");
    crotch.is_some_and(|crotch| ends.any(|ends| is_between_legs(&ends, crotch)))
}

/// Returns the panels that reach the top of the garment, or the shoulders, true each.
fn high_panels(mesh: &ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) -> Vec<bool> {
    let highest = |vertices: &[Vector3<f64>]| {
        let heights = vertices.iter().map(|p| p.y);
        heights.fold(f64::NEG_INFINITY, f64::max)
    };
    let shoulder = avatar.landmarks.get("shoulder_tip_l");
    let top = highest(start).min(shoulder.map_or(f64::INFINITY, |tip| tip.y));
    let panels = mesh
        .panels
        .iter()
        .map(|panel| &start[panel.vertices.clone()]);
    panels
        .map(|vertices| highest(vertices) > top - CARRYING)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::PanelRange;
    use crate::scene::DressForm;

    /// The carriers among panels of two vertices each, from one height to another \[m\], before or
    /// behind the body, sewn to each other as stated.
    fn found(panels: &[([f64; 2], f64)], stitches: &[[usize; 2]], stage: u32) -> Vec<usize> {
        let range = |i: usize| PanelRange {
            vertices: 2 * i..2 * i + 2,
            triangles: 0..0,
            corners: vec![],
        };
        let stitch = |&[a, b]: &[usize; 2]| Stitch {
            seam: 0,
            stage,
            a: 2 * a,
            b: 2 * b + 1,
        };
        let mesh = ClothMesh {
            panels: (0..panels.len()).map(range).collect(),
            stitches: stitches.iter().map(stitch).collect(),
            ..ClothMesh::default()
        };
        let ends = |(heights, z): &([f64; 2], f64)| heights.map(|y| Vector3::new(0.0, y, *z));
        let start: Vec<_> = panels.iter().flat_map(ends).collect();
        carriers(
            &mesh,
            &start,
            &DressForm::default().build().expect("a body"),
        )
    }

    const BAND: [([f64; 2], f64); 2] = [([0.98, 1.1], 0.2), ([0.98, 1.1], -0.2)];

    #[test]
    fn a_waistband_carries_a_skirt() {
        let panels = [BAND[0], BAND[1], ([0.5, 0.93], 0.2), ([0.5, 0.93], -0.2)];
        let sewn = [[0, 1], [1, 0], [0, 2], [1, 3], [2, 3]];
        assert_eq!(found(&panels, &sewn, 0), [0, 1]);
    }

    #[test]
    fn a_bodice_under_a_hood_carries() {
        let panels = [
            ([1.4, 1.75], -0.2),
            ([0.9, 1.4], 0.2),
            ([0.9, 1.4], -0.2),
            ([0.2, 0.9], 0.2),
        ];
        assert_eq!(found(&panels, &[[0, 1], [1, 2], [2, 3]], 0), [0, 1, 2]);
    }

    #[test]
    fn a_garment_that_orders_its_seams_keeps_its_order() {
        let panels = [BAND[0], BAND[1], ([0.5, 0.93], 0.2)];
        assert!(found(&panels, &[[0, 1], [1, 2]], 3).is_empty());
    }

    #[test]
    fn a_front_with_a_dart_carries_nothing() {
        let panels = [BAND[0], ([0.5, 0.93], 0.2), ([0.5, 0.93], -0.2)];
        let sewn = [[0, 0], [0, 1], [0, 2], [1, 2]];
        assert!(found(&panels, &sewn, 0).is_empty());
    }

    #[test]
    fn from_what_is_all_high_nothing_hangs() {
        assert!(found(&BAND, &[[0, 1], [1, 0]], 0).is_empty());
    }
}
