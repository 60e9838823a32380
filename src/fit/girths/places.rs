//! Places of a body at which a garment is measured, and the panels that go round each.

use super::section::{Plane, level, steps};
use crate::fit::sides::arm_side;
use crate::scene::{Avatar, Limb, Scene};

/// Furthest that cloth may start above or below the thigh that it is meant for \[m\].
const OFF_LEVEL: f64 = 0.03;
/// Distance of the places along a limb at which it is measured \[m\].
const STEP: f64 = 0.02;
/// Part of an arm below the armpit in which the upper arm is measured \[m\].
const UPPER_ARM: f64 = 0.12;
/// Distance from the middle beyond which the middle of a panel on one side is \[m\].
const BESIDE_MIDDLE: f64 = 0.03;
/// Distance below the crotch at which the thigh is measured \[m\].
const BELOW_CROTCH: f64 = 0.05;

/// A place of the body at which a garment is measured.
pub(super) struct Place {
    pub(super) name: &'static str,
    /// Planes that it is cut by, with the girth of the body at each \[m\].
    pub(super) cuts: Vec<(Plane, f64)>,
    pub(super) panels: Vec<usize>,
}

impl Place {
    /// Returns the largest girth of the body there \[m\].
    pub(super) fn body_m(&self) -> f64 {
        self.cuts
            .iter()
            .map(|(_, girth)| *girth)
            .fold(0.0, f64::max)
    }
}

/// Returns the places of the limbs at which the start of a garment is measured.
pub(super) fn limbs(
    avatar: &Avatar,
    scene: &Scene,
    [trunk, left, right]: &[Vec<usize>; 3],
) -> Vec<Place> {
    let arms = [
        ("left upper arm", Limb::ArmLeft, left),
        ("right upper arm", Limb::ArmRight, right),
    ];
    let arms = arms.into_iter().filter_map(|(name, limb, panels)| {
        let alongs = upper_arm(avatar, limb)?.into_iter();
        let cut = |along| {
            Some((
                normal_to(avatar, limb, along)?,
                avatar.limb_girth(limb, along)?,
            ))
        };
        Some(Place {
            name,
            cuts: alongs.filter_map(cut).collect(),
            panels: panels.clone(),
        })
    });
    arms.chain(thighs(avatar, scene, trunk)).collect()
}

/// Returns the thighs, measured by the panels on their own side: they go all round one only where
/// they are legs of trousers.
fn thighs(avatar: &Avatar, scene: &Scene, trunk: &[usize]) -> Vec<Place> {
    let legs = [
        ("left thigh", Limb::LegLeft, 1.0),
        ("right thigh", Limb::LegRight, -1.0),
    ];
    let thighs = legs.into_iter().filter_map(|(name, limb, side)| {
        let first = avatar.landmarks.get("crotch")?.y - BELOW_CROTCH;
        let cut = |height: f64| {
            let along = along_leg(avatar, limb, height)?;
            Some((level(height), avatar.limb_girth(limb, along)?))
        };
        Some(Place {
            name,
            cuts: [first, first - OFF_LEVEL]
                .into_iter()
                .filter_map(cut)
                .collect(),
            panels: on_side(scene, trunk, side),
        })
    });
    thighs.collect()
}

/// Returns the panels of the trunk whose middles start on one side of it, 1 at +x or -1 at -x: the
/// front of a skirt is on neither.
pub(super) fn on_side(scene: &Scene, trunk: &[usize], side: f64) -> Vec<usize> {
    let panels = trunk.iter().copied();
    panels
        .filter(|&panel| side * center_x(scene, panel) > BESIDE_MIDDLE)
        .collect()
}

/// Returns how far down a leg from its joint a height is \[m\].
pub(super) fn along_leg(avatar: &Avatar, limb: Limb, height: f64) -> Option<f64> {
    let (joint, direction) = avatar.limb(limb)?.at(0.0);
    Some((height - joint.y) / direction.y)
}

/// Returns the panels about the trunk, the left and the right arm.
pub(super) fn parts(scene: &Scene) -> [Vec<usize>; 3] {
    let mut parts = [vec![], vec![], vec![]];
    for (panel, range) in scene.mesh.panels.iter().enumerate() {
        let part = match arm_side(&scene.start[range.vertices.clone()]) {
            None => 0,
            Some(side) if side > 0.0 => 1,
            Some(_) => 2,
        };
        parts[part].push(panel);
    }
    parts
}

fn center_x(scene: &Scene, panel: usize) -> f64 {
    let points = &scene.start[scene.mesh.panels[panel].vertices.clone()];
    points.iter().map(|p| p.x).sum::<f64>() / points.len().max(1) as f64
}

/// Returns places along an arm at which the upper arm is measured: from beside the armpit on \[m\].
pub(super) fn upper_arm(avatar: &Avatar, limb: Limb) -> Option<Vec<f64>> {
    let side = if limb == Limb::ArmLeft { "l" } else { "r" };
    let armpit = avatar.landmarks.get(&format!("armpit_{side}"))?;
    let (joint, direction) = avatar.limb(limb)?.at(0.0);
    let along = direction.dot(&(armpit - joint)) + STEP;
    Some(steps([along, along + UPPER_ARM], STEP).collect())
}

/// Returns the plane across a limb at a length along its axis \[m\].
pub(super) fn normal_to(avatar: &Avatar, limb: Limb, along: f64) -> Option<Plane> {
    let (point, normal) = avatar.limb(limb)?.at(along);
    Some(Plane { point, normal })
}
