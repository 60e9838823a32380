//! Panels that a file puts about the arms and legs of its own body, rolled about those of the body
//! at hand.
//!
//! Left flat, half a sleeve before an arm and half behind it close over it like two hands, and on a
//! coarse mesh the edges of one cut through the arm. Rolled, they are round it from the start.

use super::Placed;
use super::anchored::{bounds, outline};
use super::limb_pose::LimbPose;
use crate::pattern::{Panel, Wrap};
use crate::scene::{Avatar, Limb};
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Distance from the middle beyond which all of a panel about an arm is, caps of raglan sleeves
/// among them, and beyond which the middle of it is \[m\].
const BESIDE: f64 = 0.05;
const BESIDE_SHOULDER: f64 = 0.2;
/// Furthest that the middle of such a panel may be from the axis of the limb \[m\].
const NEAR: f64 = 0.2;
/// Distance from the body that a panel has where it starts \[m\], and steps in which it is moved
/// down a limb for it, and their number.
const CLEAR: f64 = 0.005;
const STEP: f64 = 0.01;
const STEPS: u32 = 20;
/// Least cosine between a side of its drawing and the limb: a panel beside the trunk hangs
/// straight.
const ALIKE: f64 = 0.9;
/// Angle that a panel is rolled by \[rad\]: half a turn less a gap to the other half.
const HALF: f64 = 0.9 * PI;

/// Returns the start of a panel that stands about an arm or a leg and along it, rolled by half a
/// turn about it, before or behind it and as far down as it was; any other is as it is.
pub(super) fn onto_limb(placed: Placed, panel: &Panel, avatar: &Avatar) -> Placed {
    let points: Vec<_> = outline(panel).map(|uv| placed.position(uv)).collect();
    let middle = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
    let side = middle.x.signum();
    let [least, most] = reach(&points, &Vector3::zeros(), &(Vector3::x() * side));
    let highest = points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
    let crotch = avatar.landmarks.get("crotch");
    let found = if crotch.is_some_and(|crotch| highest < crotch.y) && least > 0.0 {
        leg_pose(&points, side, avatar)
    } else if least > BESIDE && 0.5 * (least + most) > BESIDE_SHOULDER {
        arm_pose(&points, side, avatar).map(|pose| {
            let along = (middle - pose.top).dot(&pose.direction);
            (pose, along)
        })
    } else {
        None
    };
    let Some((pose, along)) = found else {
        return placed;
    };
    let beside = pose.top + pose.direction * (middle - pose.top).dot(&pose.direction);
    let mut across = beside - middle;
    let depth = -across.z;
    across.z = 0.0;
    let is_near = across.norm() < NEAR;
    let Some(up) = up_along(&placed, &-pose.direction).filter(|_| is_near) else {
        return placed;
    };
    let place = LimbPlace {
        axis: pose.top + pose.direction * along,
        tilt: pose.tilt(),
        outward: if depth > 0.0 { 0.0 } else { PI },
        least_radius: pose.radius,
    };
    clear_of_the_body(rolled(&placed, panel, up, &place), panel, avatar)
}

/// Returns the same start so far down the limb that all of the panel is outside the body: a cap
/// would start within the trunk. Where no place is clear, it stays.
fn clear_of_the_body(placed: Placed, panel: &Panel, avatar: &Avatar) -> Placed {
    let down = placed
        .tilt
        .map_or(-Vector3::y(), |tilt| tilt * -Vector3::y());
    let points: Vec<_> = outline(panel).map(|uv| placed.position(uv)).collect();
    let is_clear = |way: &f64| {
        let mut moved = points.iter().map(|p| p + down * *way);
        moved.all(|p| avatar.distance(&p) > CLEAR)
    };
    let way = (0..=STEPS).map(|k| STEP * f64::from(k)).find(is_clear);
    Placed {
        offset: placed.offset + down * way.unwrap_or(0.0),
        ..placed
    }
}

/// Returns the pose of the arm on a side for a panel with these points, if its middle is beside it:
/// as far as the panel reaches along the arm, which is looked at that far.
fn arm_pose(points: &[Vector3<f64>], side: f64, avatar: &Avatar) -> Option<LimbPose> {
    let limb = if side > 0.0 {
        Limb::ArmLeft
    } else {
        Limb::ArmRight
    };
    let axis = avatar.limb(limb)?;
    let upper = LimbPose::of(Some(avatar), limb, 0.0);
    let [first, last] = reach(points, &upper.top, &upper.direction);
    let is_beside = (0.0..axis.length()).contains(&(0.5 * (first + last)));
    is_beside.then(|| LimbPose::of(Some(avatar), limb, last.max(0.0)))
}

/// Returns the pose of the part of the leg on a side that a panel with these points is beside, and
/// the way to its middle: above the ankle, where it is put lower.
fn leg_pose(points: &[Vector3<f64>], side: f64, avatar: &Avatar) -> Option<(LimbPose, f64)> {
    let limb = if side > 0.0 {
        Limb::LegLeft
    } else {
        Limb::LegRight
    };
    let axis = avatar.limb(limb)?;
    let (joint, thigh) = axis.at(0.0);
    let [first, last] = reach(points, &joint, &thigh);
    let end = last.min(axis.length());
    let start = end - (last - first);
    let is_beside = start > 0.0 && start < end;
    is_beside.then(|| {
        let pose = LimbPose::between(axis, &joint, [start, end]);
        (pose, 0.5 * (start + end))
    })
}

/// Returns how far along a line from `top` the first and the last of some points are \[m\].
fn reach(points: &[Vector3<f64>], top: &Vector3<f64>, direction: &Vector3<f64>) -> [f64; 2] {
    let along = points.iter().map(|p| (p - top).dot(direction));
    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[first, last], at| {
        [first.min(at), last.max(at)]
    })
}

/// Pose of a panel about a limb.
struct LimbPlace {
    /// Point of the axis beside the panel's middle \[m\].
    axis: Vector3<f64>,
    tilt: Rotation3<f64>,
    outward: f64,
    least_radius: f64,
}

/// Returns the turn of the drawing that takes the side of it which leads along `up` in space to +y,
/// if one does.
fn up_along(placed: &Placed, up: &Vector3<f64>) -> Option<Rotation2<f64>> {
    let sides = [Vector2::x(), Vector2::y(), -Vector2::x(), -Vector2::y()];
    let leads = |side: &&Vector2<f64>| {
        let side = placed.up * **side;
        (placed.rotation * Vector3::new(side.x, side.y, 0.0)).dot(up) >= ALIKE
    };
    let side = sides.iter().find(leads)?;
    Some(Rotation2::new(FRAC_PI_2 - side.y.atan2(side.x)))
}

/// Returns the same panel rolled by half a turn at a place about a limb, its drawing turned by
/// `up`.
fn rolled(flat: &Placed, panel: &Panel, up: Rotation2<f64>, place: &LimbPlace) -> Placed {
    let [[left, right], [bottom, top]] = bounds(panel, &up);
    let center_y = 0.5 * (bottom + top);
    // The drawing's own +x once it is turned, as it lay in space, against that of the roll.
    let drawn = flat.up * (up.inverse() * Vector2::x());
    let lay = flat.rotation * Vector3::new(drawn.x, drawn.y, 0.0);
    let runs = place.tilt * Vector3::new(place.outward.cos(), 0.0, -place.outward.sin());
    Placed {
        up,
        key: [0.5 * (left + right), center_y],
        center_y,
        sense: lay.dot(&runs).signum(),
        outward: place.outward,
        axis: place.axis,
        radius: ((right - left) / HALF).max(place.least_radius),
        wrap: Wrap::Cylinder,
        cone: None,
        tilt: Some(place.tilt),
        rotation: Rotation3::identity(),
        offset: Vector3::zeros(),
    }
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

    /// The start of a panel of this size put at a place and turned, before and after it is rolled
    /// about the arm.
    fn starts(size: [f64; 2], at: [f64; 3], turned_deg: f64, avatar: &Avatar) -> [Placed; 2] {
        let placement = Placement {
            at: Some(PlacementAnchor::Origin),
            offset_m: at,
            rotate_deg: [0.0, 0.0, turned_deg],
            wrap: Some(Wrap::Flat),
            ..Placement::default()
        };
        let panel = Panel::rectangle("half", size);
        let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let placed = anchored.place(&panel, Face::Up, None);
        [placed.clone(), onto_limb(placed, &panel, avatar)]
    }

    /// Half a sleeve, 30 cm long and 20 cm wide, drawn with its length along x, before and behind
    /// the left arm.
    #[test]
    fn half_a_sleeve_is_round_its_half_of_the_arm() {
        let avatar = body();
        let arm = avatar.limb(Limb::ArmLeft).expect("an arm");
        let (joint, direction) = arm.at(0.0);
        for depth in [0.15, -0.15] {
            let [flat, rolled] = starts([0.3, 0.2], [0.42, 1.15, depth], -50.0, &avatar);
            for uv in [[0.0, 0.0], [0.3, 0.0], [0.15, 0.1], [0.3, 0.2], [0.0, 0.2]] {
                let (before, after) = (flat.position(uv), rolled.position(uv));
                // As far down the arm, but for the angle between the drawing and the arm.
                let along = |p: Vector3<f64>| (p - joint).dot(&direction);
                assert!((along(before) - along(after)).abs() < 0.03, "{uv:?}");
                // All of it on its own side, and clear of the arm.
                let off = after - joint - direction * along(after);
                assert!(off.z * depth > -1e-12 && off.norm() > 0.05, "{uv:?} {off}");
                // Its upper edge stays above, its lower edge below.
                let above = |p: Vector3<f64>| (p - joint - direction * along(p)).y;
                let is_edge = uv[1] != 0.1;
                assert!(!is_edge || above(before) * above(after) > 0.0, "{uv:?}");
            }
        }
    }

    #[test]
    fn a_side_panel_of_the_trunk_stays() {
        let [before, after] = starts([0.2, 0.2], [0.3, 1.0, 0.15], 0.0, &body());
        assert_eq!(before.position([0.1, 0.1]), after.position([0.1, 0.1]));
        assert_eq!(before.position([0.2, 0.0]), after.position([0.2, 0.0]));
    }
}
