//! Key points of a body, and the pose of panels that are put there.

use crate::pattern::PlacementAnchor;
use crate::scene::Avatar;
use crate::scene::avatar::Limb;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Key points of a garment without a body.
pub(super) const NO_BODY: BodyKeyPoints = BodyKeyPoints {
    shoulder: 1.4,
    neck: 1.42,
    waist: 1.05,
    center: 0.0,
    arm: ArmPose {
        top: Vector3::new(0.19, 1.37, 0.0),
        lean: ARM_SPREAD,
        radius: 0.0,
    },
};
/// A sleeve starts at this angle from the body where that has no arms \[rad\]: so that it clears
/// the sides.
const ARM_SPREAD: f64 = 0.7;

/// Room left between an arm and a sleeve at the start \[m\].
pub(super) const ARM_CLEARANCE: f64 = 0.01;

/// The left arm as sleeves see it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArmPose {
    /// Point of the axis beside the tip of the shoulder \[m\].
    pub(super) top: Vector3<f64>,
    /// Angle from the vertical \[rad\].
    pub(super) lean: f64,
    /// Largest radius \[m\].
    pub(super) radius: f64,
}

/// Key points of a body: heights, the middle in depth \[m\], and the left arm.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyKeyPoints {
    pub(super) shoulder: f64,
    pub(super) neck: f64,
    pub(super) waist: f64,
    pub(super) center: f64,
    pub(super) arm: ArmPose,
}

impl BodyKeyPoints {
    pub(super) fn of(avatar: &Avatar) -> Self {
        let height =
            |name: &str, otherwise: f64| avatar.landmarks.get(name).map_or(otherwise, |p| p.y);
        let waist = height("waist_front", NO_BODY.waist);
        let center = avatar
            .section_bounds(waist)
            .map_or(0.0, |[_, z]| 0.5 * (z[0] + z[1]));
        let shoulder = height("neck_side_l", NO_BODY.shoulder);
        Self {
            shoulder,
            neck: height("neck_front", shoulder),
            waist,
            center,
            arm: ArmPose::of(avatar, center),
        }
    }
}

impl ArmPose {
    fn of(avatar: &Avatar, center: f64) -> Self {
        let Some(tip) = avatar.landmarks.get("shoulder_tip_l") else {
            return NO_BODY.arm;
        };
        let Some(axis) = avatar.limb(Limb::ArmLeft) else {
            return Self {
                top: Vector3::new(tip.x, tip.y, center),
                ..NO_BODY.arm
            };
        };
        let (joint, direction) = axis.at(0.0);
        Self {
            top: joint + direction * direction.dot(&(tip - joint)),
            lean: direction.x.atan2(-direction.y),
            radius: axis.radii.iter().copied().fold(0.0, f64::max),
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
    pub(super) lean: f64,
    /// Radius that a rolled panel has at least \[m\].
    pub(super) radius: f64,
}

impl Spot {
    pub(super) fn of(anchor: PlacementAnchor, body: &BodyKeyPoints) -> Self {
        let spot = |height: f64, hangs: bool, outward: f64, turn: Option<f64>| Self {
            axis: Vector3::new(0.0, height, body.center),
            hangs,
            outward,
            turn,
            lean: 0.0,
            radius: 0.0,
        };
        let arm = |side: f64, outward: f64, turn: f64| Self {
            axis: Vector3::new(side * body.arm.top.x, body.arm.top.y, body.arm.top.z),
            lean: side * body.arm.lean,
            radius: body.arm.radius + ARM_CLEARANCE,
            ..spot(0.0, true, outward, Some(turn))
        };
        match anchor {
            PlacementAnchor::TorsoFront => spot(body.shoulder, true, 0.0, None),
            PlacementAnchor::TorsoBack => spot(body.shoulder, true, PI, None),
            PlacementAnchor::SkirtFront => spot(body.waist, true, 0.0, None),
            PlacementAnchor::SkirtBack => spot(body.waist, true, PI, None),
            PlacementAnchor::Waist => spot(body.waist, false, 0.0, Some(1.0)),
            PlacementAnchor::WaistFront => spot(body.waist, false, 0.0, Some(0.5)),
            PlacementAnchor::WaistBack => spot(body.waist, false, PI, Some(0.5)),
            PlacementAnchor::Neck => spot(body.neck, false, 0.0, Some(1.0)),
            PlacementAnchor::NeckFront => spot(body.neck, false, 0.0, Some(0.5)),
            PlacementAnchor::NeckBack => spot(body.neck, false, PI, Some(0.5)),
            PlacementAnchor::ArmLeft => arm(1.0, FRAC_PI_2, 1.0),
            PlacementAnchor::ArmRight => arm(-1.0, -FRAC_PI_2, 1.0),
            PlacementAnchor::ArmLeftFront => arm(1.0, 0.0, 0.5),
            PlacementAnchor::ArmRightFront => arm(-1.0, 0.0, 0.5),
            PlacementAnchor::ArmLeftBack => arm(1.0, PI, 0.5),
            PlacementAnchor::ArmRightBack => arm(-1.0, PI, 0.5),
            PlacementAnchor::Origin => Self {
                axis: Vector3::zeros(),
                ..spot(0.0, true, 0.0, None)
            },
        }
    }
}
