//! What carries a garment is sewn before what hangs from it.
//!
//! Pulled together all at once, the gores of a wide skirt draw an open waistband down over the hip
//! on their way to it, and it closes below, for good.

use super::Avatar;
use super::crotch::is_between_legs;
use crate::mesh::ClothMesh;
use nalgebra::Vector3;

/// Depth below the top of a garment, or below the shoulders, that panels which carry it reach
/// above \[m\].
const CARRYING: f64 = 0.12;

/// Puts the seams between panels that carry the garment in a stage before all others, if there are
/// both, and the garment does not order them itself. Trousers are sewn at once: where their band
/// comes to lie, the crotch says too.
pub(super) fn sew_first(mesh: &mut ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) {
    let is_ordered = mesh.stitches.iter().any(|stitch| stitch.stage != 0);
    if is_ordered || has_legs(mesh, start, avatar) {
        return;
    }
    let carries = carriers(mesh, start, avatar);
    let panel = |vertex| mesh.panels.partition_point(|p| p.vertices.end <= vertex);
    let stitches = mesh.stitches.iter();
    let hangs: Vec<bool> = stitches
        .map(|stitch| !carries[panel(stitch.a)] || !carries[panel(stitch.b)])
        .collect();
    if hangs.iter().all(|hangs| *hangs) {
        return;
    }
    for (stitch, hangs) in mesh.stitches.iter_mut().zip(hangs) {
        stitch.stage = u32::from(hangs);
    }
}

/// Returns true if there is a seam from front to back between the legs.
fn has_legs(mesh: &ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) -> bool {
    let ends = mesh.stitches.iter().map(|s| [start[s.a], start[s.b]]);
    let crotch = avatar.landmarks.get("crotch");
    crotch.is_some_and(|crotch| ends.into_iter().any(|ends| is_between_legs(&ends, crotch)))
}

/// Returns the panels that reach the top of the garment, or the shoulders, true each.
fn carriers(mesh: &ClothMesh, start: &[Vector3<f64>], avatar: &Avatar) -> Vec<bool> {
    let highest = |vertices: &[Vector3<f64>]| {
        let heights = vertices.iter().map(|p| p.y);
        heights.fold(f64::NEG_INFINITY, f64::max)
    };
    let shoulder = avatar.landmarks.get("shoulder_tip_l");
    let top = highest(start).min(shoulder.map_or(f64::INFINITY, |tip| tip.y));
    let reaches = |range: &std::ops::Range<usize>| highest(&start[range.clone()]) > top - CARRYING;
    mesh.panels.iter().map(|p| reaches(&p.vertices)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{PanelRange, Stitch};
    use crate::scene::DressForm;

    /// Panels of two vertices each, from one height to another \[m\], sewn to each other as
    /// stated.
    fn stages(heights: &[[f64; 2]], stitches: &[[usize; 2]], first: u32) -> Vec<u32> {
        let range = |i: usize| PanelRange {
            vertices: 2 * i..2 * i + 2,
            triangles: 0..0,
            corners: vec![],
        };
        let stitch = |&[a, b]: &[usize; 2]| Stitch {
            seam: 0,
            stage: first,
            a: 2 * a,
            b: 2 * b + 1,
        };
        let mut mesh = ClothMesh {
            panels: (0..heights.len()).map(range).collect(),
            stitches: stitches.iter().map(stitch).collect(),
            ..ClothMesh::default()
        };
        let start = heights.as_flattened().iter();
        let start: Vec<_> = start.map(|y| Vector3::y() * *y).collect();
        let avatar = DressForm::default().build().expect("a body");
        sew_first(&mut mesh, &start, &avatar);
        mesh.stitches.iter().map(|stitch| stitch.stage).collect()
    }

    #[test]
    fn a_waistband_is_closed_before_the_skirt_is_sewn_to_it() {
        let heights = [[0.98, 1.1], [0.98, 1.1], [0.5, 0.93], [0.5, 0.93]];
        let sewn = [[0, 1], [1, 0], [0, 2], [1, 3], [2, 3]];
        assert_eq!(stages(&heights, &sewn, 0), [0, 0, 1, 1, 1]);
    }

    #[test]
    fn a_bodice_under_a_hood_carries() {
        let heights = [[1.4, 1.75], [0.9, 1.4], [0.9, 1.4], [0.2, 0.9]];
        let sewn = [[0, 1], [1, 2], [2, 3]];
        assert_eq!(stages(&heights, &sewn, 0), [0, 0, 1]);
    }

    #[test]
    fn the_order_of_a_garment_stays() {
        let heights = [[0.98, 1.1], [0.98, 1.1], [0.5, 0.93]];
        assert_eq!(stages(&heights, &[[0, 1], [1, 2]], 3), [3, 3]);
    }

    #[test]
    fn a_band_that_is_not_closed_by_itself_waits_for_nothing() {
        let heights = [[0.98, 1.1], [0.5, 0.93], [0.5, 0.93]];
        assert_eq!(stages(&heights, &[[0, 1], [0, 2], [1, 2]], 0), [0; 3]);
    }
}
