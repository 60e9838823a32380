//! From the bytes of a pattern file to a [`Pattern`]: panels with outlines, corners, edges, notches
//! and grain, in meters.
//!
//! [`import`] reads DXF (`dxf`) and `GarmentCode` specifications (`garmentcode`); [`checked`]
//! checks a pattern that came as JSON. Outlines are simple and clockwise, y up; a [`Point2`] is
//! `[x, y]`.

mod allowance;
mod bspline;
mod check;
mod copies;
mod crossing;
mod curve;
mod document;
mod dxf;
mod garmentcode;
mod grading;
mod ids;
pub(crate) mod inside_dart;
mod mirror;
mod options;
pub(crate) mod outline;
mod panel;
mod placement;
pub(crate) mod point;
pub(crate) mod polyline;
mod seam_pair;
mod text_encoding;
mod units;

pub use document::{Allowance, Pattern, PatternFormat, Source};
pub use grading::GradeTable;
pub use mirror::MIRROR;
pub use options::{DrawnDarts, DrawnNotches, ImportOptions, Outlines, RotationOrder, Unfold};
pub use panel::{Corner, Edge, Face, Grain, Hole, Notch, NotchKind, Panel, Quantity};
pub use placement::{Placement, PlacementAnchor, Wrap};
pub use point::Point2;
pub use seam_pair::{Direction, Match, OutlineRun, Place, SeamPair, Side};
pub use text_encoding::{TextEncoding, UnknownEncoding};
pub use units::Units;

pub(crate) use garmentcode::{is_gathered, rotation_matrix, seam_id};

use crate::config::Limits;
use crate::fault::{Fault, Faults, PatternCode};

/// Reads a pattern from the bytes of a DXF file or of a `GarmentCode` specification (JSON).
///
/// # Errors
/// Every fault that keeps the file from being read, each with the line or JSON Pointer it is about.
pub fn import(bytes: &[u8], options: &ImportOptions, limits: &Limits) -> Result<Pattern, Faults> {
    if garmentcode::is_json(bytes) {
        if options.grading.is_some() {
            let detail = "a grade rule table belongs to a DXF, and the file is JSON";
            let fault = Fault::new(PatternCode::GradeTable, "line 1", detail);
            return Err(fault.fix("leave the table out").into());
        }
        garmentcode::import(bytes, options, limits)
    } else {
        dxf::import(bytes, options, limits)
    }
}

/// Returns true if bytes look like a pattern file, be it right or wrong: a DXF, or JSON with the
/// panels of a `GarmentCode` specification.
pub fn is_pattern_file(bytes: &[u8]) -> bool {
    if garmentcode::is_json(bytes) {
        garmentcode::is_specification(bytes)
    } else {
        dxf::is_dxf(bytes)
    }
}

/// Checks a pattern that came as JSON and recomputes what is derived in it (lengths, areas).
///
/// # Errors
/// Every place where it is not a pattern: open, crossing or anticlockwise outlines, numbers that
/// are not finite, double ids.
pub fn checked(pattern: Pattern, limits: &Limits) -> Result<Pattern, Faults> {
    check::checked(pattern, limits)
}
