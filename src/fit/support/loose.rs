//! Openings that are too wide to carry a garment, told before it is sewn.

use super::body_ends::{BodyEnds, Encircled};
use super::carried::{begins_at_the_bust, mean_height};
use super::openings::{Opening, openings};
use crate::fault::{FitCode, Warning};
use crate::scene::{Avatar, Body, Scene};
use nalgebra::Vector3;

/// Share by which an opening may be wider than the body and still hold: friction, and cloth that
/// lies over cloth beneath it.
const HOLDS: f64 = 0.01;

/// Returns the warning of a garment that starts as `scene` says and whose neck, or else whose
/// highest opening round the trunk, is wider than what is to hold it.
pub(in crate::fit) fn too_large(scene: &Scene) -> Option<Warning> {
    let avatar = scene.body.as_ref().and_then(Body::avatar)?;
    if !scene.pins.is_empty() {
        return None;
    }
    let ends = BodyEnds::new(avatar)?;
    let is_face_down: Vec<bool> = scene.cut.iter().map(|cut| cut.face_down).collect();
    let openings = openings(&scene.mesh, &is_face_down).into_iter();
    let openings = openings.map(|opening| {
        let start: Vec<_> = opening.vertices.iter().map(|&v| scene.start[v]).collect();
        (ends.encircled(&start), start, opening)
    });
    let openings: Vec<_> = openings.collect();
    let highest = |around: Encircled| {
        let of_kind = openings.iter().filter(|opening| opening.0 == around);
        of_kind.max_by(|a, b| mean_height(&a.1).total_cmp(&mean_height(&b.1)))
    };
    let too_wide = if let Some((_, _, neck)) = highest(Encircled::Neck) {
        wide_neck(scene, avatar, neck)
    } else if by_one_shoulder().any(|around| highest(around).is_some()) {
        None
    } else {
        let (_, start, top) = highest(Encircled::Trunk)?;
        wide_top(avatar, start, top.rest_m)
    };
    too_wide.map(|why| {
        let detail = format!("the garment is too large: {why}");
        Warning::new(FitCode::TooLarge, "", detail)
    })
}

/// Openings of what hangs from one shoulder, or is open before both.
fn by_one_shoulder() -> impl Iterator<Item = Encircled> {
    let around = [
        Encircled::NeckAndLeftArm,
        Encircled::NeckAndRightArm,
        Encircled::BothArms,
    ];
    around.into_iter()
}

/// Tells a top edge of this length \[m\] that does not hold.
fn wide_top(avatar: &Avatar, start: &[Vector3<f64>], top: f64) -> Option<String> {
    let holds = widest_below(avatar, start)?;
    (top > holds * (1.0 + HOLDS)).then(|| {
        format!(
            "its top edge measures {:.0} cm and the body {:.0} cm where it is to hold",
            top * 100.0,
            holds * 100.0
        )
    })
}

/// Tells a neck that does not hold.
fn wide_neck(scene: &Scene, avatar: &Avatar, neck: &Opening) -> Option<String> {
    let [wide, holds] = at_the_shoulders(scene, avatar, neck)?;
    (wide > holds * (1.0 + HOLDS)).then(|| {
        format!(
            "its neck is {:.0} cm wide at the shoulders, and those are {:.0} cm",
            wide * 100.0,
            holds * 100.0
        )
    })
}

/// Returns how far apart a neck goes from front to back over the shoulders, and the tips of those
/// \[m\]; nothing where that is the edge of a collar or a hood, which lies on what holds.
fn at_the_shoulders(scene: &Scene, avatar: &Avatar, neck: &Opening) -> Option<[f64; 2]> {
    let tip = |side: &str| avatar.landmarks.get(&format!("shoulder_tip_{side}"));
    let (left, right) = (tip("l")?, tip("r")?);
    let armpit = avatar.landmarks.get("armpit_l")?.y;
    let depth = 0.5 * (left.z + right.z);
    let hangs = |vertex: usize| {
        let panel = &scene.mesh.panels[scene.mesh.panel_of_vertex(vertex)];
        let panel = &scene.start[panel.vertices.clone()];
        panel.iter().any(|p| p.y < armpit)
    };
    let next = neck.vertices.iter().cycle().skip(1);
    let over = neck.vertices.iter().zip(next).filter_map(|(&v, &w)| {
        let [a, b] = [scene.start[v], scene.start[w]];
        let [a_off, b_off] = [a.z - depth, b.z - depth];
        ((a_off < 0.0) != (b_off < 0.0)).then(|| {
            let x = a.lerp(&b, a_off / (a_off - b_off)).x;
            (x, hangs(v) && hangs(w))
        })
    });
    let over: Vec<(f64, bool)> = over.collect();
    let xs = || over.iter().map(|(x, _)| *x);
    let wide = xs().fold(f64::NEG_INFINITY, f64::max) - xs().fold(f64::INFINITY, f64::min);
    let is_known = over.len() > 1 && over.iter().all(|(_, hangs)| *hangs);
    is_known.then(|| [wide, (left - right).norm()])
}

/// Returns the girth that keeps a garment with the top edge `start` from sliding down: of the bust,
/// or of the hip \[m\].
fn widest_below(avatar: &Avatar, start: &[Vector3<f64>]) -> Option<f64> {
    let landmark = if begins_at_the_bust(avatar, start) {
        "bust_point_l"
    } else {
        "hip_front"
    };
    avatar.girth_at(avatar.landmarks.get(landmark)?.y)
}
