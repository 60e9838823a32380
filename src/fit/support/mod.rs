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
use crate::mesh::PanelRange;
use crate::scene::{Avatar, Body, Scene};
use crate::solver::{Support, SupportOpening};
use nalgebra::Vector3;

/// Furthest that a garment may turn about the body \[degrees\].
const TURNED_DEG: f64 = 20.0;
/// Cosine of the angle up to which triangles of a flat panel lie in one plane.
const FLAT: f64 = 0.999_999;
/// Openings that are shorter at the start are holes for a button or a drawstring \[m\].
const SHORT: f64 = 0.12;

/// An opening at the start and at the end.
struct WornOpening {
    panels: Vec<usize>,
    names: String,
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
                names: names.join(", "),
                panels: opening.panels.clone(),
                before: ends.encircled(&start),
                after: ends.encircled(&end),
                start,
                end,
            }
        });
    let openings: Vec<_> = openings
        .filter(|opening| carried::length(&opening.end) >= SHORT)
        .collect();
    let mut faults: Vec<String> = openings
        .iter()
        .filter_map(|opening| misplaced(opening, &ends))
        .collect();
    faults.extend(hanging(avatar, &openings, positions));
    faults.extend(turned(scene, positions));
    let seam = crotch_seam(scene, &openings).map(|v| positions[v]);
    faults.extend(carried::low_crotch(avatar, seam));
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

/// Returns the vertices at which panels along the opening of the left leg are sewn to panels along
/// that of the right one.
fn crotch_seam<'a>(
    scene: &'a Scene,
    openings: &'a [WornOpening],
) -> impl Iterator<Item = usize> + 'a {
    let along = |leg: Encircled, vertex: usize| {
        let panel = scene
            .mesh
            .panels
            .partition_point(|range| range.vertices.end <= vertex);
        let of_leg = openings.iter().filter(move |opening| opening.before == leg);
        of_leg
            .into_iter()
            .any(|opening| opening.panels.contains(&panel))
    };
    let is_between =
        move |a: usize, b: usize| along(Encircled::LeftLeg, a) && along(Encircled::RightLeg, b);
    let stitches = scene.mesh.stitches.iter();
    let between = stitches.filter(move |s| is_between(s.a, s.b) || is_between(s.b, s.a));
    between.map(|s| s.a)
}

/// Returns the fault of a garment that has turned about the body, in words.
fn turned(scene: &Scene, positions: &[Vector3<f64>]) -> Option<String> {
    let flat = flat_panels(scene);
    let of = |x: &[Vector3<f64>]| flat.iter().map(|&v| x[v]).collect::<Vec<_>>();
    let turned = turn::turn_deg(&of(&scene.start), &of(positions));
    (turned.abs() > TURNED_DEG)
        .then(|| format!("it has turned by {turned:.0} degrees about the body since it was placed"))
}

/// Returns the vertices of the panels that start flat: those that are rolled may start turned.
fn flat_panels(scene: &Scene) -> Vec<usize> {
    let normal = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|v| scene.start[v]);
        (b - a).cross(&(c - a)).normalize()
    };
    let is_flat = |range: &&PanelRange| {
        let mut normals = scene.mesh.triangles[range.triangles.clone()]
            .iter()
            .map(normal);
        let first = normals.next().unwrap_or_default();
        normals.all(|n| n.dot(&first) > FLAT)
    };
    let flat = scene.mesh.panels.iter().filter(is_flat);
    flat.flat_map(|range| range.vertices.clone()).collect()
}

/// Returns the fault of an opening that is not round what it was placed round, in words. An opening
/// that was placed round nothing, or round a limb that the body lacks, may go round nothing.
fn misplaced(opening: &WornOpening, ends: &BodyEnds) -> Option<String> {
    let WornOpening {
        names,
        before,
        after,
        ..
    } = opening;
    if *after == Encircled::Other {
        return Some(format!("the opening along {names} goes round {after}"));
    }
    let is_lost = *after == Encircled::Nothing && !ends.has(*before);
    if before != after && !is_lost && !matches!(before, Encircled::Nothing | Encircled::Other) {
        return Some(format!(
            "the opening along {names} was placed round {before} and goes round {after}"
        ));
    }
    None
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
        panels: opening.names.clone(),
        placed_round: opening.before.to_string(),
        goes_round: opening.after.to_string(),
        length_m: carried::length(&opening.end),
        height_m: height,
    }
}
