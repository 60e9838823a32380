//! `Last-Event-ID`: the event after which a client resumes.

use super::invalid;
use crate::fault::Fault;
use axum::http::HeaderMap;

/// Returns the id of the last event that the client read.
pub(in crate::http) fn last_event_id(headers: &HeaderMap) -> Result<Option<u64>, Fault> {
    let Some(value) = headers.get("Last-Event-ID") else {
        return Ok(None);
    };
    let id = value.to_str().ok().and_then(|id| id.trim().parse().ok());
    id.map(Some).ok_or_else(invalid::event_id)
}
