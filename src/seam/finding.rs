//! Findings about a set of seams and about each of them.

use super::{Face, MatchedMarks};
use crate::fault::{Fault, Warning};
use crate::pattern::{Direction, SeamPair};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Findings about a set of seams: the answer of `seams/check`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SeamCheck {
    /// True if all of them can be sewn.
    pub ok: bool,
    /// The face of each panel, by id.
    pub faces: BTreeMap<String, Face>,
    /// Each seam as requested, in order.
    pub seams: Vec<SeamFinding>,
    /// Warnings that belong to no single seam.
    #[serde(default)]
    pub warnings: Vec<Warning>,
    /// For seams that could be corrected: how.
    pub corrected: Vec<SeamPair>,
}

/// Findings about one seam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SeamFinding {
    /// The client's name for it.
    pub id: String,
    /// True if it can be sewn.
    pub ok: bool,
    /// Stitches it would get at the requested mesh edge length.
    pub stitch_count: usize,
    /// Arc length of side A \[m\].
    pub length_a_m: f64,
    /// Arc length of side B \[m\].
    pub length_b_m: f64,
    /// Longer over shorter, less 1.
    pub ease: f64,
    /// Longer less shorter \[m\].
    pub ease_m: f64,
    /// Direction of the first run of A.
    pub direction_a: Option<Direction>,
    /// Direction of the first run of B, as sewn.
    pub direction_b: Option<Direction>,
    /// True if the order of B was reversed (`match: auto`).
    pub reversed: bool,
    /// Notches of A and B that are sewn onto each other, in order; between them points meet by arc
    /// length.
    #[serde(default)]
    pub notches: Vec<MatchedMarks>,
    /// Faults that keep it from being sewn.
    pub errors: Vec<Fault>,
    /// Warnings about it.
    pub warnings: Vec<Warning>,
}

impl SeamFinding {
    /// Returns a finding of which only the name is known yet.
    pub(super) fn blank(id: &str) -> Self {
        Self {
            id: id.to_owned(),
            ok: false,
            stitch_count: 0,
            length_a_m: 0.0,
            length_b_m: 0.0,
            ease: 0.0,
            ease_m: 0.0,
            direction_a: None,
            direction_b: None,
            reversed: false,
            notches: vec![],
            errors: vec![],
            warnings: vec![],
        }
    }
}
