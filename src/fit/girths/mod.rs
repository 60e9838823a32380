//! Girths of a garment against those of its body: before it is sewn, on the pattern; after, as
//! far as its cloth is stretched.

mod section;
mod trunk;
mod words;

use self::section::{Plane, Section, Sections, level, steps};
use self::words::section_in_words;
use super::sides::arm_side;
use crate::fault::{FitCode, Warning};
use crate::scene::{Avatar, Body, Limb, Scene};
use nalgebra::Vector3;

/// Furthest that cloth may start above or below the thigh that it is meant for \[m\].
const OFF_LEVEL: f64 = 0.03;
/// Distance of the places along a limb at which it is measured \[m\].
const STEP: f64 = 0.02;
/// Distance of the planes across a tube of cloth: a few in a waistband \[m\].
const TUBE_STEP: f64 = 0.005;
/// Part of an arm below the armpit in which the upper arm is measured \[m\].
const UPPER_ARM: f64 = 0.12;
/// Distance below the crotch at which the thigh is measured \[m\].
const BELOW_CROTCH: f64 = 0.05;
/// Lack of a girth that is none \[m\]: polygons of the body and of the cloth differ by that.
const NO_LACK: f64 = 0.005;
/// Share by which cloth may be stretched beyond what it gives, for the same reason.
const OVER: f64 = 0.01;
/// Shortest section that says how far cloth is stretched \[m\].
const SHORT: f64 = 0.1;

/// A place of the body at which a garment is measured.
struct Place {
    name: &'static str,
    planes: Vec<Plane>,
    panels: Vec<usize>,
    /// Girth of the body there \[m\].
    body_m: f64,
}

/// Returns the warning of a garment that is too small for its body, as it starts: the panels are
/// cut by the levels of the trunk, by thighs and upper arms, where they go all round.
pub(super) fn too_small(scene: &Scene) -> Option<Warning> {
    let avatar = scene.body.as_ref().and_then(Body::avatar)?;
    let sections = Sections::new(scene);
    let parts = parts(scene);
    let lack = |place: Place| {
        let of = |plane: &Plane| sections.of(*plane, &place.panels, &scene.start);
        let closed = place.planes.iter().map(of).filter(|s| s.is_closed);
        let widest = closed.max_by(|a, b| a.stretched_m.total_cmp(&b.stretched_m))?;
        let is_lacking = place.body_m - widest.stretched_m > NO_LACK;
        is_lacking.then(|| section_in_words(&widest, place.name, place.body_m))
    };
    let trunk = trunk::lack(avatar, scene, &sections, &parts[0]);
    let limbs = limbs(avatar, scene, &parts).into_iter().filter_map(lack);
    let lacks: Vec<String> = trunk.into_iter().chain(limbs).collect();
    (!lacks.is_empty()).then(|| {
        let detail = format!("the garment is too small: {}", lacks.join("; "));
        Warning::new(FitCode::TooSmall, "", detail)
    })
}

/// Returns the fault of a garment at `positions` \[m\] whose cloth is stretched round the body
/// further than it gives, in words.
pub(super) fn overstretched(scene: &Scene, positions: &[Vector3<f64>]) -> Option<String> {
    let avatar = scene.body.as_ref().and_then(Body::avatar)?;
    let sections = Sections::new(scene);
    let measured = tubes(avatar, scene)
        .into_iter()
        .flat_map(|(name, panels, planes)| {
            let sections = &sections;
            planes
                .into_iter()
                .map(move |plane| (name, sections.of(plane, &panels, positions)))
        });
    let excess = |section: &Section| section.shape_m / section.stretched_m - 1.0;
    let over = measured.filter(|(_, s)| s.rest_m > SHORT && excess(s) > OVER);
    let (name, worst) = over.max_by(|a, b| excess(&a.1).total_cmp(&excess(&b.1)))?;
    let percent = |length: f64| 100.0 * (length / worst.rest_m - 1.0);
    Some(format!(
        "its cloth is stretched by {:.0} % round the {name} and gives {:.0} %: it is too small",
        percent(worst.shape_m),
        percent(worst.stretched_m)
    ))
}

/// Returns the places of the limbs at which the start of a garment is measured.
fn limbs(avatar: &Avatar, scene: &Scene, [trunk, left, right]: &[Vec<usize>; 3]) -> Vec<Place> {
    let arms = [
        ("left upper arm", Limb::ArmLeft, left),
        ("right upper arm", Limb::ArmRight, right),
    ];
    let arms = arms.into_iter().filter_map(|(name, limb, panels)| {
        let alongs = upper_arm(avatar, limb)?;
        let girths = alongs
            .iter()
            .filter_map(|&along| avatar.limb_girth(limb, along));
        Some(Place {
            name,
            body_m: girths.max_by(f64::total_cmp)?,
            planes: alongs
                .iter()
                .filter_map(|&along| normal_to(avatar, limb, along))
                .collect(),
            panels: panels.clone(),
        })
    });
    arms.chain(thighs(avatar, scene, trunk)).collect()
}

/// Returns the thighs, measured by the panels on their own side: they go all round one only where
/// they are legs of trousers.
fn thighs(avatar: &Avatar, scene: &Scene, trunk: &[usize]) -> Vec<Place> {
    let on_side = |side: f64| {
        let panels = trunk.iter().copied();
        panels
            .filter(move |&panel| side * center_x(scene, panel) > 0.0)
            .collect::<Vec<_>>()
    };
    let legs = [
        ("left thigh", Limb::LegLeft, 1.0),
        ("right thigh", Limb::LegRight, -1.0),
    ];
    let thighs = legs.into_iter().filter_map(|(name, limb, side)| {
        let height = avatar.landmarks.get("crotch")?.y - BELOW_CROTCH;
        let (joint, direction) = avatar.limb(limb)?.at(0.0);
        let along = (height - joint.y) / direction.y;
        Some(Place {
            name,
            planes: vec![level(height), level(height - OFF_LEVEL)],
            panels: on_side(side),
            body_m: avatar.limb_girth(limb, along)?,
        })
    });
    thighs.collect()
}

/// A tube of a garment: its name, its panels, and planes across it.
type Tube = (&'static str, Vec<usize>, Vec<Plane>);

/// Returns the tubes of a garment round trunk and arms, with planes all along them.
fn tubes(avatar: &Avatar, scene: &Scene) -> Vec<Tube> {
    let [trunk, left, right] = parts(scene);
    let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
    let mut tubes = vec![];
    if let (Some(low), Some(high)) = (height("crotch"), height("armpit_l")) {
        tubes.push((
            "trunk",
            trunk,
            steps([low, high], TUBE_STEP).map(level).collect(),
        ));
    }
    let arms = [
        ("left arm", Limb::ArmLeft, left),
        ("right arm", Limb::ArmRight, right),
    ];
    for (name, limb, panels) in arms {
        let (Some(axis), Some(along)) = (avatar.limb(limb), upper_arm(avatar, limb)) else {
            continue;
        };
        let alongs = steps([along[0], axis.length()], TUBE_STEP);
        let planes = alongs.filter_map(|along| normal_to(avatar, limb, along));
        tubes.push((name, panels, planes.collect()));
    }
    tubes
}

/// Returns the panels about the trunk, the left and the right arm.
fn parts(scene: &Scene) -> [Vec<usize>; 3] {
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
fn upper_arm(avatar: &Avatar, limb: Limb) -> Option<Vec<f64>> {
    let side = if limb == Limb::ArmLeft { "l" } else { "r" };
    let armpit = avatar.landmarks.get(&format!("armpit_{side}"))?;
    let (joint, direction) = avatar.limb(limb)?.at(0.0);
    let along = direction.dot(&(armpit - joint)) + STEP;
    Some(steps([along, along + UPPER_ARM], STEP).collect())
}

fn normal_to(avatar: &Avatar, limb: Limb, along: f64) -> Option<Plane> {
    let (point, normal) = avatar.limb(limb)?.at(along);
    Some(Plane { point, normal })
}

#[cfg(test)]
mod tests;
