//! Placement as a file or a client states it: the first position of a panel in space (P7).

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// First position of a panel in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Placement {
    /// Key point of the body that the panel's key point is put at; found from the panel's name if
    /// absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<PlacementAnchor>,
    /// Direction on the drawing that is up on the body, counter-clockwise from +x; 90 (+y) if
    /// absent \[degrees\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up_deg: Option<f64>,
    /// Translation, after all else \[m\].
    #[serde(default)]
    pub offset_m: [f64; 3],
    /// Rotation about the panel's center, R = Rx Ry Rz \[degrees\].
    #[serde(default)]
    pub rotate_deg: [f64; 3],
    /// Flat, rolled about the body, or level round it; chosen from the key point if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrap: Option<Wrap>,
}

/// A key point of the body for placement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = Anchor)]
pub enum PlacementAnchor {
    /// In front of the torso, hung from the shoulders.
    TorsoFront,
    /// Behind the torso, hung from the shoulders.
    TorsoBack,
    /// In front of the hips, hung from the waist.
    SkirtFront,
    /// Behind the hips, hung from the waist.
    SkirtBack,
    /// Round the waist.
    Waist,
    /// In front of the waist (half a waistband).
    WaistFront,
    /// Behind the waist (half a waistband).
    WaistBack,
    /// Round the left arm, hung from the shoulder.
    ArmLeft,
    /// Round the right arm, hung from the shoulder.
    ArmRight,
    /// In front of the left arm (half a sleeve).
    ArmLeftFront,
    /// Behind the left arm.
    ArmLeftBack,
    /// In front of the right arm.
    ArmRightFront,
    /// Behind the right arm.
    ArmRightBack,
    /// Round the left leg and that half of the hips, hung from the waist (a leg in one piece).
    LegLeft,
    /// Round the right leg and that half of the hips.
    LegRight,
    /// Round the neck, standing on it.
    Neck,
    /// In front of the neck (half a collar).
    NeckFront,
    /// Behind the neck.
    NeckBack,
    /// The origin of space, between the feet: the panel's center is put there, flat, facing +z,
    /// never mirrored.
    Origin,
}

/// Shape in which a panel starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Wrap {
    /// Flat.
    Flat,
    /// Rolled about the body's vertical axis, without stretch; to a cone where two edges of the
    /// panel run about a point of its plane and are sewn to each other, as of a circle skirt in one
    /// piece.
    Cylinder,
    /// Level, the outer side up and the drawn +y to the back: the middle of its largest hole lies
    /// on the body's vertical axis, at the height of the key point.
    Level,
}
