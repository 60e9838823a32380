//! Sides from which a garment is looked at.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Side from which a picture shows a garment; left and right are the body's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The side that the body faces, +z.
    Front,
    /// The side opposite to it.
    Back,
    /// The body's left, +x.
    Left,
    /// The body's right, -x.
    Right,
    /// Between front and left, from above.
    ThreeQuarter,
}

impl View {
    /// Views of a sheet, in the order of walking round the body.
    pub(super) const SHEET: [Self; 4] = [Self::Front, Self::Right, Self::Back, Self::Left];

    /// Returns the unit vectors to the right and up in the picture, and towards its viewer.
    pub(super) fn axes(self) -> [Vector3<f64>; 3] {
        let toward = match self {
            Self::Front => Vector3::z(),
            Self::Back => -Vector3::z(),
            Self::Left => Vector3::x(),
            Self::Right => -Vector3::x(),
            Self::ThreeQuarter => Vector3::new(0.5, 0.25, 0.7).normalize(),
        };
        let right = Vector3::y().cross(&toward).normalize();
        [right, toward.cross(&right), toward]
    }
}
