//! The request for a study: a garment, and the settings to vary.

use crate::config::Limits;
use crate::fit::{Garment, ReadError, RequestSchema, garment_bounds};
use crate::json::JsonBounds;
use crate::solver::Method;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;
use utoipa::ToSchema;

/// A garment, and the settings to vary. Only `garment` is required.
///
/// The garment's own `simulate` states the rest: what is wanted, the membrane (one for the whole
/// study), how seams close, and for a motion its duration and frame rate; its `method`,
/// `tolerance`, `step_s` and `edge_length_m` are what an empty list stands for or are not used; its
/// `time_limit_s` bounds every single run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = StudyAsked)]
pub struct StudyRequest {
    /// The garment, as for a fit; here it may want a motion.
    pub garment: Garment,
    /// Methods to compare. Empty: `newton`, `implicit_euler` and `symplectic_euler` for a drape,
    /// all four that step for a motion.
    #[serde(default)]
    #[schema(min_items = 0)]
    pub methods: Vec<Method>,
    /// Tolerances, as in `simulate.tolerance`: the residual r to reach for a drape, metres per
    /// simulated second for a motion. Empty: 1e-1, 1e-2, 1e-3 and 1e-4 for a drape, none for a
    /// motion.
    #[serde(default)]
    #[schema(min_items = 0)]
    pub tolerances: Vec<f64>,
    /// Fixed steps of a motion \[s\]. Empty, and no tolerances given: each method's own, from its
    /// stability limit or a frame downwards.
    #[serde(default)]
    #[schema(min_items = 0)]
    pub steps_s: Vec<f64>,
    /// Lengths of mesh edges \[m\]. Empty: the garment's.
    #[serde(default)]
    #[schema(min_items = 0)]
    pub edge_lengths_m: Vec<f64>,
    /// CPU time of the whole study \[s\]; what it does not suffice for is left out and listed.
    /// Absent: 600.
    #[serde(default)]
    pub time_limit_s: Option<f64>,
}

/// Reads the request for a study from its JSON; [`resolve`](super::resolve()) checks its meaning.
///
/// # Errors
/// Where it is not JSON or larger than the limits, or every field that is missing, unknown or of
/// the wrong kind.
pub fn read_study(bytes: &[u8], limits: &Limits) -> Result<StudyRequest, ReadError> {
    RequestSchema::measure(bytes, &study_bounds(limits))?;
    study_schema().read(bytes)
}

/// Returns the schema of requests for studies.
pub(crate) fn study_schema() -> &'static RequestSchema {
    // Made from the type alone, once.
    static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<StudyRequest>);
    &SCHEMA
}

/// Returns the bounds of the JSON of requests for studies.
pub(crate) fn study_bounds(limits: &Limits) -> JsonBounds {
    garment_bounds(limits).under("garment")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_any_length_are_read() {
        let text =
            br#"{"garment": {"seams": []}, "methods": ["newton", "verlet"], "tolerances": [1e-2],
            "edge_lengths_m": [0.03, 0.02, 0.015, 0.012]}"#;
        let request = read_study(text, &Limits::default()).expect("it is right");
        assert_eq!(request.methods, [Method::Newton, Method::Verlet]);
        assert_eq!(
            (request.tolerances.len(), request.edge_lengths_m.len()),
            (1, 4)
        );
        assert!(request.steps_s.is_empty() && request.time_limit_s.is_none());
    }

    #[test]
    fn all_faults_of_shape_come_at_once() {
        let text =
            br#"{"garment": {"seams": 7}, "methods": ["newtin"], "tolerance": [1], "steps_s": 3}"#;
        let Err(ReadError::Schema(faults)) = read_study(text, &Limits::default()) else {
            panic!("it is of another shape");
        };
        let mut at: Vec<&str> = faults.0.iter().map(|f| f.pointer.as_str()).collect();
        at.sort_unstable();
        assert_eq!(
            at,
            ["/garment/seams", "/methods/0", "/steps_s", "/tolerance"]
        );
    }
}
