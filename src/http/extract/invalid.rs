//! The faults of requests that their shape shows: each in one sentence, with the place.

use crate::fault::{Fault, FitCode, RequestCode};

/// Returns the fault of a form without a part that it needs.
pub(super) fn missing_part(name: &str) -> Fault {
    let detail = format!("the form has no part {name:?}");
    Fault::new(RequestCode::MissingPart, format!("/{name}"), detail)
}

/// Returns the fault of a part that the form does not have, or that came twice.
pub(super) fn unexpected_part(name: &str, names: &[&str]) -> Fault {
    let detail = format!("the part {name:?} is not expected here, or came twice");
    Fault::new(RequestCode::UnexpectedPart, format!("/{name}"), detail)
        .fix(format!("the parts are {}", names.join(", ")))
}

/// Returns the fault of a form with a pattern whose garment has a pattern too.
pub(super) fn two_patterns() -> Fault {
    let detail = "the pattern comes as a part of the form and in the garment too";
    Fault::new(FitCode::TwoPatterns, "/pattern", detail).fix("leave it out of the garment")
}

/// Returns the fault of a page of a list that is too small or too large.
pub(super) fn limit_out_of_range(limit: usize, most: usize) -> Fault {
    let detail = format!("limit is {limit}; it must be from 1 to {most}");
    Fault::new(RequestCode::OutOfRange, "/limit", detail)
}

/// Returns the fault of a query that cannot be read.
pub(super) fn unreadable_query(reason: String) -> Fault {
    Fault::new(RequestCode::Query, "", reason)
}

/// Returns the fault of an `Idempotency-Key` that is empty, too long or no text.
pub(super) fn idempotency_key(most: usize) -> Fault {
    let detail = format!("the key must be of 1 to {most} visible ASCII characters");
    Fault::new(RequestCode::Key, "/Idempotency-Key", detail)
}

/// Returns the fault of a `Last-Event-ID` that is no id.
pub(super) fn event_id() -> Fault {
    let detail = "event ids are whole numbers";
    Fault::new(RequestCode::EventId, "/Last-Event-ID", detail)
}
