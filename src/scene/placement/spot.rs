//! Key points of a body, and the pose of panels that are put there.

use super::limb_pose::LimbPose;
use crate::pattern::PlacementAnchor;
use crate::scene::Avatar;
use crate::scene::avatar::Limb;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Height of a collar above the sides of the neck at the start \[m\]: there the neck is clear of
/// the slope of the shoulders.
const ABOVE_SHOULDERS: f64 = 0.01;

/// Key points of a garment without a body.
const NO_BODY: BodyKeyPoints = BodyKeyPoints {
    shoulder: 1.4,
    waist: 1.05,
    center: 0.0,
    neck: Vector3::new(0.0, 1.42, 0.0),
};

/// Key points of a body: heights, the middle in depth, and that of the foot of the neck \[m\].
#[derive(Clone, Copy, Debug)]
struct BodyKeyPoints {
    shoulder: f64,
    waist: f64,
    center: f64,
    neck: Vector3<f64>,
}

impl BodyKeyPoints {
    fn of(avatar: &Avatar) -> Self {
        let height =
            |name: &str, otherwise: f64| avatar.landmarks.get(name).map_or(otherwise, |p| p.y);
        let middle = |height: f64| {
            let bounds = avatar.section_bounds(height);
            bounds.map(|[_, z]| 0.5 * (z[0] + z[1]))
        };
        let waist = height("waist_front", NO_BODY.waist);
        let center = middle(waist).unwrap_or(0.0);
        let shoulder = height("neck_side_l", NO_BODY.shoulder);
        let neck = shoulder + ABOVE_SHOULDERS;
        Self {
            shoulder,
            waist,
            center,
            neck: Vector3::new(0.0, neck, middle(neck).unwrap_or(center)),
        }
    }
}

/// Position of an anchor, and the pose of panels there.
pub(super) struct Spot {
    /// Point of the axis at the key point's height \[m\].
    pub(super) axis: Vector3<f64>,
    /// True if the key point is the top of the panel, not its bottom.
    pub(super) hangs: bool,
    /// Angle of the outward direction from +z towards +x \[rad\].
    pub(super) outward: f64,
    /// The part of a turn that a rolled panel covers at least; nothing where panels lie flat unless
    /// told.
    pub(super) turn: Option<f64>,
    /// Turn of the axis onto that of an arm.
    pub(super) tilt: Option<Rotation3<f64>>,
    /// Radius that a rolled panel has at least \[m\].
    pub(super) radius: f64,
    /// Radii at its upper and its lower end between which it may narrow in a straight line \[m\].
    pub(super) line: [f64; 2],
}

impl Spot {
    /// The spot for a panel of this `length` along the axis \[m\].
    pub(super) fn of(anchor: PlacementAnchor, avatar: Option<&Avatar>, length: f64) -> Self {
        let body = avatar.map_or(NO_BODY, BodyKeyPoints::of);
        let spot = |height: f64, hangs: bool, outward: f64, turn: Option<f64>| Self {
            axis: Vector3::new(0.0, height, body.center),
            hangs,
            outward,
            turn,
            tilt: None,
            radius: 0.0,
            line: [0.0; 2],
        };
        let neck = |outward: f64, turn: f64| Self {
            axis: body.neck,
            ..spot(0.0, false, outward, Some(turn))
        };
        let arm = |limb: Limb, outward: f64, turn: f64| {
            let pose = LimbPose::of(avatar, limb, length);
            Self {
                axis: pose.top,
                tilt: Some(pose.tilt()),
                radius: pose.radius,
                line: pose.line,
                ..spot(0.0, true, outward, Some(turn))
            }
        };
        match anchor {
            PlacementAnchor::TorsoFront => spot(body.shoulder, true, 0.0, None),
            PlacementAnchor::TorsoBack => spot(body.shoulder, true, PI, None),
            PlacementAnchor::SkirtFront => spot(body.waist, true, 0.0, None),
            PlacementAnchor::SkirtBack => spot(body.waist, true, PI, None),
            PlacementAnchor::Waist => spot(body.waist, false, 0.0, Some(1.0)),
            PlacementAnchor::WaistFront => spot(body.waist, false, 0.0, Some(0.5)),
            PlacementAnchor::WaistBack => spot(body.waist, false, PI, Some(0.5)),
            PlacementAnchor::Neck => neck(0.0, 1.0),
            PlacementAnchor::NeckFront => neck(0.0, 0.5),
            PlacementAnchor::NeckBack => neck(PI, 0.5),
            PlacementAnchor::ArmLeft => arm(Limb::ArmLeft, FRAC_PI_2, 1.0),
            PlacementAnchor::ArmRight => arm(Limb::ArmRight, -FRAC_PI_2, 1.0),
            PlacementAnchor::ArmLeftFront => arm(Limb::ArmLeft, 0.0, 0.5),
            PlacementAnchor::ArmRightFront => arm(Limb::ArmRight, 0.0, 0.5),
            PlacementAnchor::ArmLeftBack => arm(Limb::ArmLeft, PI, 0.5),
            PlacementAnchor::ArmRightBack => arm(Limb::ArmRight, PI, 0.5),
            PlacementAnchor::LegLeft => spot(body.waist, true, FRAC_PI_2, Some(1.0)),
            PlacementAnchor::LegRight => spot(body.waist, true, -FRAC_PI_2, Some(1.0)),
            PlacementAnchor::Origin => Self {
                axis: Vector3::zeros(),
                ..spot(0.0, true, 0.0, None)
            },
        }
    }
}
