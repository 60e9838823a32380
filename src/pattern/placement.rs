//! Placement as a file or a client states it: where a panel starts in space (P7).

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Where a panel starts in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Placement {
    /// Key point of the body that the panel's key point is put at; found from the panel's name if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<PlacementAnchor>,
    /// Direction on the drawing that is up on the body, counter-clockwise from +x; 90 (+y) if absent \[degrees\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up_deg: Option<f64>,
    /// Moved by this after all else \[m\].
    #[serde(default)]
    pub offset_m: [f64; 3],
    /// Turned about the panel's centre, R = Rx Ry Rz \[degrees\].
    #[serde(default)]
    pub rotate_deg: [f64; 3],
    /// Whether it lies flat or is rolled about the body; chosen from the key point if absent.
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
    /// Round the neck, standing on it.
    Neck,
    /// In front of the neck (half a collar).
    NeckFront,
    /// Behind the neck.
    NeckBack,
    /// The origin of space, between the feet: the panel's centre is put there, flat, facing +z, never mirrored.
    Origin,
}

/// Whether a panel starts flat or rolled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Wrap {
    /// Flat.
    Flat,
    /// Rolled about the body's vertical axis, without stretch.
    Cylinder,
}
