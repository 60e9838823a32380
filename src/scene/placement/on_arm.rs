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

/// Returns the start with its middle before or behind the axis of the arm, if the panel is one that
/// stands about an arm; else as it is. It moves across the axis and level with the depth that it
/// has.
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
    let from_joint = middle - joint;
    let along = from_joint.dot(&direction);
    let mut across = direction * along - from_joint;
    across.z = 0.0;
    if (0.0..arm.length()).contains(&along) && across.norm() < NEAR {
        placed.offset += across;
    }
    placed
}
