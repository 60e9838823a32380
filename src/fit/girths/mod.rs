//! Girths of a garment against those of its body: before it is sewn, on the pattern; after, as
//! far as its cloth is stretched.

mod measured;
mod places;
mod section;
mod trunk;
mod words;

pub(super) use self::measured::measured;

use self::places::{Place, along_leg, limbs, normal_to, on_side, parts, upper_arm};
use self::section::{Plane, Section, Sections, level, steps};
use self::words::section_in_words;
use crate::fault::{FitCode, Warning};
use crate::scene::{Avatar, Body, Limb, Scene};
use nalgebra::Vector3;

/// Distance of the planes across a tube of cloth: a few in a waistband \[m\].
const TUBE_STEP: f64 = 0.005;
/// Lack of a girth that is none \[m\]: polygons of the body and of the cloth differ by that.
const NO_LACK: f64 = 0.005;
/// Share by which cloth may be stretched beyond what it gives, for the same reason.
const OVER: f64 = 0.01;
/// Shortest section that says how far cloth is stretched \[m\].
const SHORT: f64 = 0.1;

/// Returns the warning of a garment that is too small for its body, as it starts: the panels are
/// cut by the levels of the trunk, by thighs and upper arms, where they go all round.
pub(super) fn too_small(scene: &Scene) -> Option<Warning> {
    let avatar = scene.body.as_ref().and_then(Body::avatar)?;
    let sections = Sections::new(scene);
    let parts = parts(scene);
    let lack = |place: Place| {
        let of = |(plane, _): &(Plane, f64)| sections.of(*plane, &place.panels, &scene.start);
        let closed = place.cuts.iter().map(of).filter(|s| s.is_closed);
        let widest = closed.max_by(|a, b| a.stretched_m.total_cmp(&b.stretched_m))?;
        let body_m = place.body_m();
        let is_lacking = body_m - widest.stretched_m > NO_LACK;
        is_lacking.then(|| section_in_words(&widest, place.name, body_m))
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

/// A tube of a garment: its name, its panels, and planes across it.
type Tube = (&'static str, Vec<usize>, Vec<Plane>);

/// Returns the tubes of a garment round trunk, arms and legs, with planes all along them.
fn tubes(avatar: &Avatar, scene: &Scene) -> Vec<Tube> {
    let [trunk, left, right] = parts(scene);
    let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
    let mut tubes = vec![];
    if let (Some(low), Some(high)) = (height("crotch"), height("armpit_l")) {
        tubes.push((
            "trunk",
            trunk.clone(),
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
    let legs = [
        ("left leg", Limb::LegLeft, 1.0),
        ("right leg", Limb::LegRight, -1.0),
    ];
    for (name, limb, side) in legs {
        let crotch = height("crotch").and_then(|height| along_leg(avatar, limb, height));
        let (Some(axis), Some(crotch)) = (avatar.limb(limb), crotch) else {
            continue;
        };
        let panels = on_side(scene, &trunk, side);
        if panels.is_empty() {
            continue;
        }
        let alongs = steps([crotch, axis.length()], TUBE_STEP);
        let planes = alongs.filter_map(|along| normal_to(avatar, limb, along));
        tubes.push((name, panels, planes.collect()));
    }
    tubes
}

#[cfg(test)]
mod tests;
