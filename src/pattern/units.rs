//! Units of length in drawings.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A unit of length in drawings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// Millimeters.
    Mm,
    /// Centimeters.
    Cm,
    /// Meters.
    M,
    /// Inches of 25.4 mm.
    Inch,
}

impl Units {
    /// Returns its name: `mm`, `cm`, `m` or `inch`.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::M => "m",
            Self::Inch => "inch",
        }
    }

    /// Returns its length \[m\].
    pub(crate) fn in_meters(self) -> f64 {
        match self {
            Self::Mm => 0.001,
            Self::Cm => 0.01,
            Self::M => 1.0,
            Self::Inch => 0.0254,
        }
    }
}
