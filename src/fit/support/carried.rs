//! Places at which a body carries a garment: the shoulders by its neck, the waist or hip by its
//! band, the bust by its top edge.

use crate::scene::Avatar;
use nalgebra::Vector3;

/// Furthest that the line of the shoulder may be from the cloth that hangs on it \[m\].
const OFF_SHOULDER: f64 = 0.025;
/// Furthest that the upper edge of a band at the waist may be above it \[m\]: 30 mm for the band,
/// and half of a band 100 mm high.
const ABOVE_WAIST: f64 = 0.08;
/// Furthest that a band may be below the hip \[m\], in which its girth hardly changes.
const BELOW_HIP: f64 = 0.01;
/// Furthest that the top edge of a strapless garment may be below the points of the bust \[m\].
const BELOW_BUST: f64 = 0.02;
/// Share of the way from waist to bust above which a top edge starts that the bust holds: of the
/// 140 mm on a body of 1.68 m a band of 100 mm at the waist takes 0.7.
const HELD_BY_BUST: f64 = 0.8;
/// Furthest that a crotch seam may hang below the crotch \[m\].
const BELOW_CROTCH: f64 = 0.06;

/// Returns the fault of a garment that does not lie on both shoulders, in words: `cloth` are its
/// vertices.
pub(super) fn off_the_shoulders(avatar: &Avatar, cloth: &[Vector3<f64>]) -> Option<String> {
    let off = [("l", "left"), ("r", "right")].map(|(side, name)| {
        let end = |name: &str| avatar.landmarks.get(&format!("{name}_{side}"));
        let (inner, outer) = (end("neck_side")?, end("shoulder_tip")?);
        let distances = cloth.iter().map(|p| distance_to_segment(p, inner, outer));
        Some((distances.min_by(f64::total_cmp)?, name))
    });
    let worst = off.into_iter().flatten().max_by(|a, b| a.0.total_cmp(&b.0));
    let (off, side) = worst.filter(|(off, _)| *off > OFF_SHOULDER)?;
    Some(format!(
        "it is {:.0} mm off the {side} shoulder: it has slid down, or its neck is wider than the shoulders",
        off * 1e3
    ))
}

/// Returns the fault of the waist of a skirt or of trousers that is not between waist and hip, in
/// words.
pub(super) fn off_the_waist(avatar: &Avatar, waist: &[Vector3<f64>]) -> Option<String> {
    let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
    let (at_waist, at_hip) = (height("waist_front")?, height("hip_front")?);
    let mean = mean_height(waist);
    if mean > at_waist + ABOVE_WAIST {
        let above = (mean - at_waist) * 1e3;
        return Some(format!("its waist is {above:.0} mm above the body's"));
    }
    (mean < at_hip - BELOW_HIP).then(|| {
        let long = length(waist) * 100.0;
        let body = avatar.girth_at(at_waist).unwrap_or(f64::NAN) * 100.0;
        format!(
            "its waist is {:.0} mm below the hip: it measures {long:.0} cm, the body's waist {body:.0} cm; it needs a band, darts, elastic or a smaller size",
            (at_hip - mean) * 1e3
        )
    })
}

/// Returns the fault of the top edge of a strapless garment that has slid down, in words.
pub(super) fn off_the_bust(avatar: &Avatar, top: &[Vector3<f64>]) -> Option<String> {
    let bust = avatar.landmarks.get("bust_point_l")?.y;
    let lowest = top.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
    (lowest < bust - BELOW_BUST).then(|| {
        format!(
            "its top edge hangs {:.0} mm below the points of the bust",
            (bust - lowest) * 1e3
        )
    })
}

/// Returns true if a garment that begins with the edge `top` is held by the bust, not by the waist:
/// under the arms that edge may dip.
pub(super) fn begins_at_the_bust(avatar: &Avatar, top: &[Vector3<f64>]) -> bool {
    let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
    let (Some(waist), Some(bust)) = (height("waist_front"), height("bust_point_l")) else {
        return false;
    };
    mean_height(top) > waist + HELD_BY_BUST * (bust - waist)
}

/// Returns the fault of a crotch seam that hangs too low, in words: `seam` are the points at which
/// the panels of one leg are sewn to those of the other.
pub(super) fn low_crotch(
    avatar: &Avatar,
    seam: impl Iterator<Item = Vector3<f64>>,
) -> Option<String> {
    let crotch = avatar.landmarks.get("crotch")?;
    let lowest = seam.map(|p| p.y).fold(f64::INFINITY, f64::min);
    let below = crotch.y - lowest;
    (lowest.is_finite() && below > BELOW_CROTCH).then(|| {
        format!(
            "its crotch seam hangs {:.0} mm below the body's crotch",
            below * 1e3
        )
    })
}

/// Returns the mean height of points above the floor \[m\].
pub(super) fn mean_height(points: &[Vector3<f64>]) -> f64 {
    points.iter().map(|p| p.y).sum::<f64>() / points.len().max(1) as f64
}

/// Returns the length of a closed polygon \[m\].
pub(super) fn length(curve: &[Vector3<f64>]) -> f64 {
    let next = curve.iter().cycle().skip(1);
    curve.iter().zip(next).map(|(a, b)| (b - a).norm()).sum()
}

fn distance_to_segment(p: &Vector3<f64>, a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let along = b - a;
    let share = ((p - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    (a + along * share - p).norm()
}
