//! Panels that a file puts about the arms of its own body, moved to those of the body at hand.

use super::Placed;
use super::anchored::outline;
use crate::pattern::Panel;
use crate::scene::{Avatar, Limb};
use nalgebra::Vector3;

/// Distance from the middle beyond which all of a panel about an arm is \[m\].
const BESIDE: f64 = 0.15;
/// Furthest that the middle of such a panel may be from the axis of the arm \[m\].
const NEAR: f64 = 0.2;
/// Least cosine between a side of its drawing and the arm: a panel beside the trunk hangs straight.
const ALIKE: f64 = 0.9;

/// Returns the start with its middle before or behind the axis of the arm, if the panel is one that
/// stands about an arm and along it; else as it is. Its depth before or behind the arm stays.
pub(super) fn onto_arm(mut placed: Placed, panel: &Panel, avatar: &Avatar) -> Placed {
    let points: Vec<_> = outline(panel).map(|uv| placed.position(uv)).collect();
    let middle = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
    let side = middle.x.signum();
    let is_beside = points.iter().all(|p| p.x * side > BESIDE);
    let limb = if side > 0.0 {
        Limb::ArmLeft
    } else {
        Limb::ArmRight
    };
    let Some(arm) = avatar.limb(limb).filter(|_| is_beside) else {
        return placed;
    };
    let (joint, direction) = arm.at(0.0);
    let sides = [Vector3::x(), Vector3::y()].map(|side| placed.rotation * side);
    if sides.iter().all(|side| side.dot(&direction).abs() < ALIKE) {
        return placed;
    }
    let from_joint = middle - joint;
    let along = from_joint.dot(&direction);
    let mut across = direction * along - from_joint;
    across.z = 0.0;
    if (0.0..arm.length()).contains(&along) && across.norm() < NEAR {
        placed.offset += across;
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Placement, PlacementAnchor};
    use crate::scene::placement::AnchoredPlacement;
    use crate::scene::{DressForm, Limbs};
    use crate::seam::Face;

    fn body() -> Avatar {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: true,
                legs: false,
            }),
            ..DressForm::default()
        };
        form.build().expect("a body")
    }

    /// The middle of a square of 20 cm, put at a place and turned, before and after it is moved
    /// \[m\].
    fn moved(at: [f64; 3], turned_deg: f64, avatar: &Avatar) -> [Vector3<f64>; 2] {
        let placement = Placement {
            at: Some(PlacementAnchor::Origin),
            offset_m: at,
            rotate_deg: [0.0, 0.0, turned_deg],
            ..Placement::default()
        };
        let panel = Panel::rectangle("half", [0.2, 0.2]);
        let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let placed = anchored.place(&panel, Face::Up, None);
        let after = onto_arm(placed.clone(), &panel, avatar);
        [placed, after].map(|placed| placed.position([0.1, 0.1]))
    }

    #[test]
    fn half_a_sleeve_is_moved_before_the_axis_of_the_arm() {
        let avatar = body();
        let [_, after] = moved([0.5, 1.15, 0.15], -50.0, &avatar);
        let (joint, direction) = avatar.limb(Limb::ArmLeft).expect("an arm").at(0.0);
        let off = (after - joint).cross(&direction);
        // Across the arm it is on the axis as seen from the front; its depth is as it was.
        assert!(off.z.abs() < 1e-12, "{off}");
        assert!((after.z - 0.15).abs() < 1e-12, "{after}");
    }

    #[test]
    fn a_side_panel_of_the_trunk_stays() {
        let [before, after] = moved([0.3, 1.0, 0.15], 0.0, &body());
        assert_eq!(before, after);
    }
}
