//! Verdict on how a body carries a garment: what each opening goes round, where the garment hangs,
//! and the reasons, in words.
//!
//! An opening is meant to go round what it goes round at the start, where the panels stand about
//! the body as they were placed. A garment is worn if each of its openings goes round that at the
//! end, once, has not turned about it, and if the opening that carries it is where the body can.

mod body_ends;
mod carried;
mod linking;
mod openings;
mod turn;

use self::body_ends::{BodyEnds, Encircled};
use self::openings::{Opening, openings};
use crate::scene::{Avatar, Body, Scene};
use crate::solver::{Support, SupportOpening};
use nalgebra::Vector3;

/// Furthest that an opening may turn about the body \[degrees\].
const TURNED_DEG: f64 = 20.0;
/// Openings that are shorter at the start are holes for a button or a drawstring \[m\].
const SHORT: f64 = 0.12;

/// An opening at the start and at the end.
struct WornOpening {
    panels: String,
    before: Encircled,
    after: Encircled,
    start: Vec<Vector3<f64>>,
    end: Vec<Vector3<f64>>,
}

/// Returns how the body of `scene` carries the garment of panels `panels` at `positions` \[m\],
/// where the solver found that it came to rest as `found` says.
pub(super) fn support(
    scene: &Scene,
    panels: &[&str],
    positions: &[Vector3<f64>],
    found: &Support,
) -> Support {
    let Some(avatar) = scene.body.as_ref().and_then(Body::avatar) else {
        return found.clone();
    };
    if !scene.pins.is_empty() {
        return not_judged("corners are pinned, which carry it");
    }
    let Some(ends) = BodyEnds::new(avatar) else {
        return not_judged("the body has no landmarks");
    };
    let is_face_down: Vec<bool> = scene.cut.iter().map(|cut| cut.face_down).collect();
    let places = |opening: &Opening, x: &[Vector3<f64>]| {
        opening.vertices.iter().map(|&v| x[v]).collect::<Vec<_>>()
    };
    let openings = openings(&scene.mesh, &is_face_down)
        .into_iter()
        .map(|opening| {
            let (start, end) = (places(&opening, &scene.start), places(&opening, positions));
            let names: Vec<&str> = opening.panels.iter().map(|&panel| panels[panel]).collect();
            WornOpening {
                panels: names.join(", "),
                before: ends.encircled(&start),
                after: ends.encircled(&end),
                start,
                end,
            }
        });
    let openings: Vec<_> = openings
        .filter(|opening| carried::length(&opening.end) >= SHORT)
        .collect();
    let cloth = || scene.mesh.triangles.iter().map(|t| t.map(|v| positions[v]));
    let mut faults: Vec<String> = openings
        .iter()
        .filter_map(|opening| misplaced(opening, &ends))
        .collect();
    faults.extend(hanging(avatar, &openings, positions));
    if openings.iter().any(|opening| is_leg(opening.after)) {
        faults.extend(carried::low_crotch(avatar, cloth()));
    }
    if found.ok != Some(true) {
        faults.insert(0, found.because.clone());
    }
    Support {
        ok: Some(faults.is_empty()),
        because: if faults.is_empty() {
            found.because.clone()
        } else {
            faults.join("; ")
        },
        openings: openings.iter().map(told).collect(),
    }
}

fn not_judged(because: &str) -> Support {
    Support {
        ok: None,
        because: format!("not judged: {because}"),
        openings: vec![],
    }
}

fn is_leg(around: Encircled) -> bool {
    matches!(around, Encircled::LeftLeg | Encircled::RightLeg)
}

/// Returns the fault of an opening that is not round what it was placed round, in words. An opening
/// that was placed round nothing, or round a limb that the body lacks, may go round nothing.
fn misplaced(opening: &WornOpening, ends: &BodyEnds) -> Option<String> {
    let WornOpening {
        panels,
        before,
        after,
        ..
    } = opening;
    if *after == Encircled::Other {
        return Some(format!("the opening along {panels} goes round {after}"));
    }
    let is_lost = *after == Encircled::Nothing && !ends.has(*before);
    if before != after && !is_lost && !matches!(before, Encircled::Nothing | Encircled::Other) {
        return Some(format!(
            "the opening along {panels} was placed round {before} and goes round {after}"
        ));
    }
    let turned = turn::turn_deg(&opening.start, &opening.end);
    let can_turn = matches!(after, Encircled::Trunk | Encircled::Neck);
    (can_turn && turned.abs() > TURNED_DEG).then(|| {
        format!("the opening along {panels} has turned by {turned:.0} degrees about the body")
    })
}

/// Returns the fault of the opening that is to carry the garment, in words: the neck, or else the
/// highest one round the trunk.
fn hanging(avatar: &Avatar, openings: &[WornOpening], cloth: &[Vector3<f64>]) -> Option<String> {
    let height = |opening: &&WornOpening| {
        opening.end.iter().map(|p| p.y).sum::<f64>() / opening.end.len().max(1) as f64
    };
    let highest = |around: &[Encircled]| {
        let of_kind = openings
            .iter()
            .filter(|opening| around.contains(&opening.after));
        of_kind.max_by(|a, b| height(a).total_cmp(&height(b)))
    };
    if highest(&[Encircled::Neck]).is_some() {
        return carried::off_the_shoulders(avatar, cloth);
    }
    if highest(&[
        Encircled::BothArms,
        Encircled::NeckAndLeftArm,
        Encircled::NeckAndRightArm,
    ])
    .is_some()
    {
        return None;
    }
    let Some(top) = highest(&[Encircled::Trunk]) else {
        return Some("no opening goes round the neck or the trunk: nothing carries it".to_owned());
    };
    if carried::begins_at_the_bust(avatar, &top.start) {
        carried::off_the_bust(avatar, &top.end)
    } else {
        carried::off_the_waist(avatar, &top.end)
    }
}

fn told(opening: &WornOpening) -> SupportOpening {
    let height = opening.end.iter().map(|p| p.y).sum::<f64>() / opening.end.len().max(1) as f64;
    SupportOpening {
        panels: opening.panels.clone(),
        placed_round: opening.before.to_string(),
        goes_round: opening.after.to_string(),
        length_m: carried::length(&opening.end),
        height_m: height,
    }
}
