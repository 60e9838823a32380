//! Openings that are too wide to carry a garment, told before it is sewn.

use super::body_ends::{BodyEnds, Encircled};
use super::carried::{begins_at_the_bust, mean_height};
use super::openings::openings;
use crate::fault::{FitCode, Warning};
use crate::scene::{Avatar, Body, Scene};
use nalgebra::Vector3;

/// Share by which an opening may be wider than the body and still hold: friction, and cloth that
/// lies over cloth beneath it.
const HOLDS: f64 = 0.01;
/// Tape laid over both shoulders, as a multiple of the distance of their tips: there and back, and
/// round the ends.
const ROUND_SHOULDERS: f64 = 2.1;

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
    let (what, opening, holds) = match highest(Encircled::Neck) {
        Some((_, _, neck)) => ("neck", neck, round_shoulders(avatar)?),
        None => {
            let (_, start, top) = highest(Encircled::Trunk)?;
            ("top edge", top, widest_below(avatar, start)?)
        }
    };
    let wide = opening.rest_m;
    (wide > holds * (1.0 + HOLDS)).then(|| {
        let detail = format!(
            "the garment is too large: its {what} measures {:.0} cm and the body {:.0} cm where it is to hold",
            wide * 100.0,
            holds * 100.0
        );
        Warning::new(FitCode::TooLarge, "", detail)
    })
}

/// Returns the length of a tape laid over both shoulders \[m\].
fn round_shoulders(avatar: &Avatar) -> Option<f64> {
    let tip = |side: &str| avatar.landmarks.get(&format!("shoulder_tip_{side}"));
    Some(ROUND_SHOULDERS * (tip("l")? - tip("r")?).norm())
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
