//! Seam pairs as a file or a client states them: two picks, unchecked (P3, P4).

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Two stretches of outline that are to be sewn together, unchecked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SeamPair {
    /// The client's name for it, unique in the garment.
    pub id: String,
    /// One side.
    pub a: Side,
    /// The other side.
    pub b: Side,
    /// Order in which the points of the two sides are put together.
    #[serde(default, rename = "match")]
    pub matching: Match,
    /// Order of sewing: lower stages are sewn first.
    #[serde(default)]
    pub stage: u32,
    /// True if much ease is wanted.
    #[serde(default)]
    pub gather: bool,
    /// True if it may lie over another seam.
    #[serde(default)]
    pub layered: bool,
    /// True if it may make the surface one-sided.
    #[serde(default)]
    pub allow_twist: bool,
    /// Confidence of a suggested seam, from 0 (a guess) to 1 (certain).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub confidence: Option<f64>,
    /// Reason of a suggested seam, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub because: Option<String>,
}

/// One side of a seam: a run, or several one after another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
pub enum Side {
    /// A single run.
    One(OutlineRun),
    /// Runs one after another (M:N seams).
    Many(Vec<OutlineRun>),
}

impl Side {
    /// Returns the runs of this side, in order.
    pub fn runs(&self) -> &[OutlineRun] {
        match self {
            Self::One(run) => std::slice::from_ref(run),
            Self::Many(runs) => runs,
        }
    }
}

/// A stretch of a panel's outline, of one of its holes or of one of its internal lines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = Run)]
pub struct OutlineRun {
    /// Id of the panel.
    pub panel: String,
    /// Its first point.
    pub from: Place,
    /// Its last point.
    pub to: Place,
    /// Direction; needed only where the places do not determine it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<Direction>,
}

/// A point of an outline, of a hole or of an internal line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum Place {
    /// A corner of the outline by its index.
    Corner(usize),
    /// A point inside an edge.
    OnEdge {
        /// Index of the edge.
        edge: usize,
        /// Fraction of its arc length, clockwise.
        at: f64,
    },
    /// A notch.
    AtNotch {
        /// Index of the notch.
        notch: usize,
    },
    /// A corner of a hole.
    HoleCorner {
        /// Index of the hole.
        hole: usize,
        /// Index of its corner.
        corner: usize,
    },
    /// A point inside an edge of a hole.
    OnHoleEdge {
        /// Index of the hole.
        hole: usize,
        /// Index of its edge.
        edge: usize,
        /// Fraction of that edge's arc length, in the order of the hole's corners.
        at: f64,
    },
    /// A point of an internal line.
    OnLine {
        /// Index of the line.
        line: usize,
        /// Fraction of its arc length: 0 where it is drawn from, 1 where it ends.
        at: f64,
    },
}

/// Direction round an outline or a hole, or along an internal line.
///
/// Going `cw` keeps the cloth on one and the same side of the way, on the outline as on holes
/// (which are stored the other way round in space for that reason).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// In the order of corners as stored: clockwise on the outline of a panel as drawn. Along a
    /// line: as it is drawn.
    Cw,
    /// Against it.
    Ccw,
}

/// Order in which the points of the two sides of a seam are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Match {
    /// `from` of A meets `from` of B.
    #[default]
    AsPicked,
    /// The service chooses the order of B and says so.
    Auto,
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{from_value, json};

    #[test]
    fn places_of_holes_and_lines_are_read_as_written() {
        let cases = [
            (json!(4), Place::Corner(4)),
            (json!({"notch": 2}), Place::AtNotch { notch: 2 }),
            (
                json!({"hole": 0, "corner": 2}),
                Place::HoleCorner { hole: 0, corner: 2 },
            ),
            (
                json!({"hole": 0, "edge": 1, "at": 0.5}),
                Place::OnHoleEdge {
                    hole: 0,
                    edge: 1,
                    at: 0.5,
                },
            ),
            (
                json!({"line": 1, "at": 0.25}),
                Place::OnLine { line: 1, at: 0.25 },
            ),
        ];
        for (written, place) in cases {
            assert_eq!(from_value::<Place>(written.clone()).ok(), Some(place));
            assert_eq!(serde_json::to_value(place).ok(), Some(written));
        }
    }

    #[test]
    fn place_with_a_field_too_many_is_refused() {
        let on_edge = Place::OnEdge { edge: 3, at: 0.25 };
        assert_eq!(
            from_value::<Place>(json!({"edge": 3, "at": 0.25})).ok(),
            Some(on_edge)
        );
        for wrong in [
            json!({"edge": 3, "at": 0.25, "notch": 1}),
            json!({"edge": 3, "at": 0.25, "att": 0.5}),
            json!({"notch": 1, "at": 0.5}),
            json!({"hole": 0}),
            json!({"hole": 0, "corner": 1, "at": 0.5}),
            json!({"hole": 0, "edge": 1}),
            json!({"hole": 0, "edge": 1, "at": 0.5, "line": 2}),
            json!({"hole": 0, "at": 0.5}),
            json!({"line": 0}),
            json!({"line": 0, "edge": 0, "at": 0.5}),
        ] {
            assert!(from_value::<Place>(wrong.clone()).is_err(), "{wrong}");
        }
    }
}
