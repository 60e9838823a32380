//! Panels that a file puts about the arms and legs of its own body, rolled about those of the body
//! at hand.
//!
//! Left flat, half a sleeve before an arm and half behind it close over it like two hands, and on a
//! coarse mesh the edges of one cut through the arm. Rolled, they are round it from the start.

use super::Placed;
use super::anchored::{bounds, outline};
use super::limb_pose::LimbPose;
use super::panel_placement::{OwnStitch, PanelPlacement};
use super::taper::{Lines, Taper};
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
/// Gain in clearance for which a panel is moved \[m\].
const GAIN: f64 = 1e-3;
/// Least cosine between a side of its drawing and the limb: a panel beside the trunk hangs
/// straight.
const ALIKE: f64 = 0.9;
/// Angle that a panel is rolled by \[rad\]: half a turn less a gap to the other half.
const HALF: f64 = 0.9 * PI;

/// A panel rolled by half a turn about a limb.
struct HalfRound {
    limb: Limb,
    /// True if it is before the limb, false if behind it.
    is_before: bool,
    start: Placed,
}

/// Rolls the panels that a file puts about an arm or a leg, and along it, by half a turn about it,
/// before or behind it and as far down as they were: those that are sewn to another half, or to
/// themselves. A godet beside a leg is neither.
pub(super) fn roll(
    placed: &mut [Placed],
    panels: &[PanelPlacement<'_>],
    of_panel: &[Vec<OwnStitch>],
    avatar: &Avatar,
) {
    let half = |(panel, at): (&PanelPlacement<'_>, &Placed)| {
        let is_of_file = panel.placement.is_about_other_body();
        is_of_file.then(|| half_round(at, panel.panel, avatar))?
    };
    let halves: Vec<Option<HalfRound>> = panels.iter().zip(&*placed).map(half).collect();
    for (panel, half) in halves.iter().enumerate() {
        let Some(half) = half else { continue };
        let goes_round = of_panel[panel].iter().any(|[_, other]| {
            let other_half = halves[other.panel].as_ref();
            let is_opposite = |o: &HalfRound| o.limb == half.limb && o.is_before != half.is_before;
            other.panel == panel || other_half.is_some_and(is_opposite)
        });
        if goes_round {
            placed[panel] = half.start.clone();
        }
    }
}

/// Returns the start of a panel that stands about a limb and along it, rolled about that.
fn half_round(flat: &Placed, panel: &Panel, avatar: &Avatar) -> Option<HalfRound> {
    let points: Vec<_> = outline(panel).map(|uv| flat.position(uv)).collect();
    let middle = mean(&points);
    let stretch = limb_stretch(&points, middle.x.signum(), avatar)?;
    let pose = &stretch.pose;
    let away = middle - pose.top;
    let off = away - pose.direction * away.dot(&pose.direction);
    let up = up_along(flat, &-pose.direction)?;
    let is_before = off.z > 0.0;
    (off.xy().norm() < NEAR).then(|| {
        let place = LimbPlace {
            axis: pose.top + pose.direction * stretch.middle,
            tilt: pose.tilt(),
            outward: if is_before { 0.0 } else { PI },
            least_radius: pose.radius,
            line: pose.line,
        };
        HalfRound {
            limb: stretch.limb,
            is_before,
            start: clear_of_the_body(rolled(flat, panel, up, &place), panel, avatar),
        }
    })
}

/// Returns the same start so far down the limb that all of the panel is clear of the body, or where
/// it is clearest: a cap would start within the trunk.
fn clear_of_the_body(placed: Placed, panel: &Panel, avatar: &Avatar) -> Placed {
    let down = placed
        .tilt
        .map_or(-Vector3::y(), |tilt| tilt * -Vector3::y());
    let points: Vec<_> = outline(panel).map(|uv| placed.position(uv)).collect();
    let mut best = [0.0, f64::NEG_INFINITY];
    for way in (0..=STEPS).map(|k| STEP * f64::from(k)) {
        let needed = best[1] + GAIN;
        let mut distances = points.iter().map(|p| avatar.distance(&(p + down * way)));
        let clearance = distances.try_fold(CLEAR, |least, d| (d > needed).then(|| least.min(d)));
        best = clearance.map_or(best, |clearance| [way, clearance]);
        if best[1] == CLEAR {
            break;
        }
    }
    Placed {
        offset: placed.offset + down * best[0],
        ..placed
    }
}

/// The stretch of a limb that a panel is beside.
struct LimbStretch {
    limb: Limb,
    pose: LimbPose,
    /// Way along the pose's direction to the middle of the panel \[m\].
    middle: f64,
}

/// Returns the stretch that a panel with these points on a side of the body is beside: of the leg
/// if it is all below the crotch, else of the arm if it is beside the shoulder.
fn limb_stretch(points: &[Vector3<f64>], side: f64, avatar: &Avatar) -> Option<LimbStretch> {
    let [least, most] = reach(points, &Vector3::zeros(), &(Vector3::x() * side));
    let [_, highest] = reach(points, &Vector3::zeros(), &Vector3::y());
    let crotch = avatar.landmarks.get("crotch");
    let is_left = side > 0.0;
    if crotch.is_some_and(|crotch| highest < crotch.y) && least > 0.0 {
        let limb = if is_left {
            Limb::LegLeft
        } else {
            Limb::LegRight
        };
        leg_stretch(limb, points, avatar)
    } else if least > BESIDE && 0.5 * (least + most) > BESIDE_SHOULDER {
        let limb = if is_left {
            Limb::ArmLeft
        } else {
            Limb::ArmRight
        };
        arm_stretch(limb, points, avatar)
    } else {
        None
    }
}

/// The stretch of an arm, as far as the panel reaches along it.
fn arm_stretch(limb: Limb, points: &[Vector3<f64>], avatar: &Avatar) -> Option<LimbStretch> {
    let length = avatar.limb(limb)?.length();
    let upper = LimbPose::of(Some(avatar), limb, 0.0);
    let [first, last] = reach(points, &upper.top, &upper.direction);
    (0.0..length).contains(&(0.5 * (first + last))).then(|| {
        let pose = LimbPose::of(Some(avatar), limb, last.max(0.0));
        LimbStretch {
            limb,
            middle: (mean(points) - pose.top).dot(&pose.direction),
            pose,
        }
    })
}

/// The stretch of a leg: one above the ankle for a panel that is put lower.
fn leg_stretch(limb: Limb, points: &[Vector3<f64>], avatar: &Avatar) -> Option<LimbStretch> {
    let axis = avatar.limb(limb)?;
    let (joint, thigh) = axis.at(0.0);
    let [first, last] = reach(points, &joint, &thigh);
    let end = last.min(axis.length());
    let start = end - (last - first);
    (start > 0.0 && start < end).then(|| LimbStretch {
        limb,
        pose: LimbPose::between(axis, &joint, [start, end]),
        middle: 0.5 * (start + end),
    })
}

fn mean(points: &[Vector3<f64>]) -> Vector3<f64> {
    points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64
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
    /// Radii at the panel's upper and lower end between which it may narrow \[m\].
    line: [f64; 2],
}

/// Returns the turn of the drawing that takes the side of it which leads along `up`, as seen in its
/// plane, to +y, if one does.
fn up_along(placed: &Placed, up: &Vector3<f64>) -> Option<Rotation2<f64>> {
    let sides = [Vector2::x(), Vector2::y(), -Vector2::x(), -Vector2::y()];
    // Files put panels in the plane of the shoulders; arms lean forward out of it.
    let normal = placed.rotation * Vector3::z();
    let up = (up - normal * normal.dot(up)).normalize();
    let leads = |side: &&Vector2<f64>| {
        let side = placed.up * **side;
        (placed.rotation * Vector3::new(side.x, side.y, 0.0)).dot(&up) >= ALIKE
    };
    let side = sides.iter().find(leads)?;
    Some(Rotation2::new(FRAC_PI_2 - side.y.atan2(side.x)))
}

/// Returns the same panel rolled by half a turn at a place about a limb, its drawing turned by
/// `up`.
fn rolled(flat: &Placed, panel: &Panel, up: Rotation2<f64>, place: &LimbPlace) -> Placed {
    let [[left, right], [bottom, top]] = bounds(panel, &up);
    let center_y = 0.5 * (bottom + top);
    let radius = ((right - left) / HALF).max(place.least_radius);
    let turned: Vec<_> = outline(panel).map(|uv| up * Vector2::from(uv)).collect();
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
        radius,
        wrap: Wrap::Cylinder,
        spread: 1.0,
        cone: None,
        taper: Taper::of(&Lines::of(&turned), radius, place.line),
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
    use crate::scene::placement::panel_placement::{SeamPoint, own_stitches};
    use crate::scene::placement::test_body::body;
    use crate::seam::Face;

    /// The starts of two panels of this size that a file puts at two places and turns, sewn to each
    /// other, before and after they are rolled.
    fn starts(
        size: [f64; 2],
        at: [[f64; 3]; 2],
        turned_deg: f64,
        avatar: &Avatar,
    ) -> [[Placed; 2]; 2] {
        let panel = Panel::rectangle("half", size);
        let placements = at.map(|offset_m| {
            let placement = Placement {
                at: Some(PlacementAnchor::Origin),
                offset_m,
                rotate_deg: [0.0, 0.0, turned_deg],
                wrap: Some(Wrap::Flat),
                ..Placement::default()
            };
            let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
            anchored.of_file()
        });
        let panels = placements.each_ref().map(|placement| PanelPlacement {
            panel: &panel,
            placement,
            face: Face::Up,
        });
        let flat = placements
            .each_ref()
            .map(|anchored| anchored.place(&panel, Face::Up, None));
        let mut rolled = flat.clone();
        let corner = |panel| SeamPoint {
            panel,
            uv: [0.0, 0.0],
        };
        let stitches = own_stitches(2, &[[corner(0), corner(1)]]);
        roll(&mut rolled, &panels, &stitches, avatar);
        [flat, rolled]
    }

    /// Half a sleeve, 30 cm long and 20 cm wide, drawn with its length along x, before and behind
    /// the left arm.
    #[test]
    fn half_a_sleeve_is_round_its_half_of_the_arm() {
        let avatar = body();
        let arm = avatar.limb(Limb::ArmLeft).expect("an arm");
        let (joint, direction) = arm.at(0.0);
        let depths = [0.15, -0.15];
        let at = depths.map(|depth| [0.42, 1.15, depth]);
        let [flat, rolled] = starts([0.3, 0.2], at, -50.0, &avatar);
        for (half, depth) in depths.into_iter().enumerate() {
            for uv in [[0.0, 0.0], [0.3, 0.0], [0.15, 0.1], [0.3, 0.2], [0.0, 0.2]] {
                let [before, after] = [&flat, &rolled].map(|starts| starts[half].position(uv));
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

    /// Half a cuff, 7 cm high, before and behind the right foot.
    #[test]
    fn a_cuff_is_round_the_leg_above_the_ankle() {
        let avatar = body();
        let at = [0.15, -0.15].map(|depth| [-0.13, 0.04, depth]);
        let [_, rolled] = starts([0.2, 0.07], at, 0.0, &avatar);
        let leg = avatar.limb(Limb::LegRight).expect("a leg");
        let (ankle, _) = leg.at(leg.length());
        for (half, sense) in rolled.iter().zip([1.0, -1.0]) {
            for uv in [[0.0, 0.0], [0.1, 0.0], [0.2, 0.07]] {
                let p = half.position(uv);
                assert!(p.y > ankle.y - 0.01 && avatar.distance(&p) > CLEAR, "{p}");
            }
            assert!(sense * (half.position([0.1, 0.0]).z - ankle.z) > 0.0);
        }
    }

    /// Two godets of a skirt, both before the leg, are sewn to each other: no half is behind it.
    #[test]
    fn what_has_no_other_half_stays_flat() {
        let at = [[0.13, 0.3, 0.15], [0.15, 0.3, 0.16]];
        let [flat, rolled] = starts([0.15, 0.3], at, 0.0, &body());
        for (before, after) in flat.iter().zip(&rolled) {
            assert_eq!(before.position([0.1, 0.1]), after.position([0.1, 0.1]));
        }
    }

    #[test]
    fn a_side_panel_of_the_trunk_stays() {
        let at = [0.15, -0.15].map(|depth| [0.3, 1.0, depth]);
        let [flat, rolled] = starts([0.2, 0.2], at, 0.0, &body());
        for (before, after) in flat.iter().zip(&rolled) {
            assert_eq!(before.position([0.1, 0.1]), after.position([0.1, 0.1]));
            assert_eq!(before.position([0.2, 0.0]), after.position([0.2, 0.0]));
        }
    }
}
