//! The unit of a body's file, by the height that a person has.

use super::super::TriangleMesh;
use super::upright::{Axes, extent};
use crate::fault::{AvatarCode, Fault};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Heights that a body has \[m\].
const HEIGHTS: [f64; 2] = [0.9, 2.3];
/// Height that decides between two units \[m\].
const USUAL: f64 = 1.7;

/// Unit of the coordinates of a body's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub enum BodyUnits {
    /// Meter.
    #[serde(rename = "m")]
    Meter,
    /// Decimeter.
    #[serde(rename = "dm")]
    Decimeter,
    /// Centimeter.
    #[serde(rename = "cm")]
    Centimeter,
    /// Millimeter.
    #[serde(rename = "mm")]
    Millimeter,
    /// Inch, 25.4 mm.
    #[serde(rename = "inch")]
    Inch,
    /// Foot, 12 inches.
    #[serde(rename = "ft")]
    Foot,
}

impl BodyUnits {
    const ALL: [Self; 6] = [
        Self::Meter,
        Self::Centimeter,
        Self::Millimeter,
        Self::Inch,
        Self::Decimeter,
        Self::Foot,
    ];

    /// Returns its length \[m\].
    pub fn meters(self) -> f64 {
        match self {
            Self::Meter => 1.0,
            Self::Decimeter => 0.1,
            Self::Centimeter => 0.01,
            Self::Millimeter => 0.001,
            Self::Inch => 0.0254,
            Self::Foot => 0.3048,
        }
    }

    /// Returns its name in a query.
    pub fn name(self) -> &'static str {
        match self {
            Self::Meter => "m",
            Self::Decimeter => "dm",
            Self::Centimeter => "cm",
            Self::Millimeter => "mm",
            Self::Inch => "inch",
            Self::Foot => "ft",
        }
    }
}

/// Finds the unit in which a body has the height of a person.
///
/// # Errors
/// `avatar/units` if there is none, or the stated one makes no person of it.
pub(super) fn units(
    surface: &TriangleMesh,
    axes: &Axes,
    stated: Option<BodyUnits>,
) -> Result<BodyUnits, Fault> {
    let [low, high] = extent(surface, &axes.up);
    let height = high - low;
    let fits = |unit: &BodyUnits| (HEIGHTS[0]..=HEIGHTS[1]).contains(&(height * unit.meters()));
    let fault = |detail: String| {
        Err(Fault::new(AvatarCode::Units, "", detail)
            .fix("state the unit with `units`, the axis with `up`, or scale the body"))
    };
    if let Some(stated) = stated {
        if fits(&stated) {
            return Ok(stated);
        }
        return fault(format!(
            "the body is {:.3} m high in {}; bodies of {} to {} m are taken",
            height * stated.meters(),
            stated.name(),
            HEIGHTS[0],
            HEIGHTS[1]
        ));
    }
    let off = |unit: &BodyUnits| (height * unit.meters() / USUAL).ln().abs();
    let fitting = BodyUnits::ALL.into_iter().filter(fits);
    let best = fitting.min_by(|a, b| off(a).total_cmp(&off(b)));
    best.map_or_else(
        || {
            fault(format!(
                "the body is {height:.4} units of the file high, which is a person in no unit"
            ))
        },
        Ok,
    )
}
