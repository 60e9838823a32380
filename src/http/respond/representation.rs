//! Representations: bytes with a strong `ETag`, answered by `If-None-Match`, `If-Range` and `Range`
//! (RFC 9110).

use super::byte_range::RequestedRange;
use super::problem::Problem;
use crate::http::state::{App, AppState};
use axum::body::{Body, Bytes};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use headers::{AcceptRanges, CacheControl, ContentRange, ETag, HeaderMapExt, IfNoneMatch, IfRange};
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::ops::Range;

/// Bytes of a media type, ready to be requested in part.
#[derive(Clone, Debug)]
pub(in crate::http) struct Representation {
    bytes: Bytes,
    content_type: String,
    etag: ETag,
}

impl Representation {
    /// Creates a representation, and hashes its bytes for the entity tag: to be called on a thread
    /// that may block.
    pub(in crate::http) fn new(bytes: impl Into<Bytes>, content_type: impl Into<String>) -> Self {
        let bytes = bytes.into();
        let digest = Sha256::digest(&bytes).into();
        Self::with_digest(bytes, content_type, digest)
    }

    /// Creates a representation of bytes whose SHA-256 is known.
    pub(in crate::http) fn with_digest(
        bytes: impl Into<Bytes>,
        content_type: impl Into<String>,
        digest: [u8; 32],
    ) -> Self {
        Self {
            bytes: bytes.into(),
            content_type: content_type.into(),
            etag: entity_tag(&digest),
        }
    }

    /// Answers with all of it, a part, or that it has not changed, as the headers of the request
    /// ask.
    pub(in crate::http) fn respond(self, request: &HeaderMap) -> Result<Response, Problem> {
        let if_none_match = request.typed_get::<IfNoneMatch>();
        if if_none_match.is_some_and(|tags| !tags.precondition_passes(&self.etag)) {
            return Ok(self.response(StatusCode::NOT_MODIFIED, None));
        }
        match self.requested_range(request) {
            RequestedRange::Whole => Ok(self.response(StatusCode::OK, None)),
            RequestedRange::Part(range) => {
                Ok(self.response(StatusCode::PARTIAL_CONTENT, Some(range)))
            }
            RequestedRange::Unsatisfiable => Err(Problem::range_not_satisfiable(self.bytes.len())),
        }
    }

    /// Returns the requested part; the whole if the client knows another version than this.
    fn requested_range(&self, request: &HeaderMap) -> RequestedRange {
        let is_current = match request.typed_try_get::<IfRange>() {
            Ok(if_range) => if_range.is_none_or(|tag| !tag.is_modified(Some(&self.etag), None)),
            Err(_) => false,
        };
        let range = request.get(header::RANGE);
        match range.and_then(|range| range.to_str().ok()) {
            Some(range) if is_current => RequestedRange::parse(range, self.bytes.len()),
            _ => RequestedRange::Whole,
        }
    }

    fn response(self, status: StatusCode, range: Option<Range<usize>>) -> Response {
        let total = self.bytes.len();
        let body = match &range {
            Some(range) => self.bytes.slice(range.clone()),
            None if status == StatusCode::NOT_MODIFIED => Bytes::new(),
            None => self.bytes,
        };
        let content_type = [(header::CONTENT_TYPE, self.content_type)];
        let mut response = (status, content_type, Body::from(body)).into_response();
        let headers = response.headers_mut();
        headers.typed_insert(self.etag);
        headers.typed_insert(AcceptRanges::bytes());
        headers.typed_insert(CacheControl::new().with_no_cache());
        if let Some(range) = range {
            let range = range.start as u64..range.end as u64;
            let range = ContentRange::bytes(range, total as u64);
            headers.typed_insert(range.expect("the range is not empty and inside"));
        }
        response
    }
}

/// Makes a representation in the compute pool, its hash included, and answers with what the headers
/// ask for.
pub(in crate::http) async fn respond_computed<B: Into<Bytes>>(
    state: &AppState,
    request: &HeaderMap,
    content_type: &'static str,
    make: impl FnOnce(&App) -> Result<B, Problem> + Send + 'static,
) -> Result<Response, Problem> {
    let make = move |app: &App| Ok::<_, Problem>(Representation::new(make(app)?, content_type));
    state.run_compute(make).await??.respond(request)
}

/// Reads a representation from the store, hashes it there, and answers with what the headers ask
/// for.
pub(in crate::http) async fn respond_stored(
    state: &AppState,
    request: &HeaderMap,
    content_type: &'static str,
    read: impl FnOnce(&App) -> Result<Vec<u8>, Problem> + Send + 'static,
) -> Result<Response, Problem> {
    let read = move |app: &App| Ok::<_, Problem>(Representation::new(read(app)?, content_type));
    state.run_reading(read).await??.respond(request)
}

/// Returns a strong entity tag of the first half of a digest: equal bytes have equal tags.
fn entity_tag(digest: &[u8; 32]) -> ETag {
    let hex = digest.iter().take(16).fold(String::new(), |mut hex, byte| {
        write!(hex, "{byte:02x}").expect("a string takes all");
        hex
    });
    let tag = format!("\"{hex}\"");
    tag.parse().expect("hexadecimal digits in quotes are a tag")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_bytes_have_equal_tags() {
        let tag = |text: &'static str| Representation::new(text, "text/plain").etag;
        assert_eq!(tag("a"), tag("a"));
        assert_ne!(tag("a"), tag("b"));
    }
}
