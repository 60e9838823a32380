//! Bodies, read within their limits.

use crate::http::respond::Problem;
use axum::body::Bytes;
use axum::extract::Request;
use axum::http::{HeaderMap, header};
use headers::{ContentLength, HeaderMapExt};
use tokio_stream::StreamExt;

/// Bytes above a limit that are still read before the refusal: a client that is cut off while it
/// sends cannot read why.
const LINGER_BYTES: usize = 64 << 20;

/// Reads a body of at most `limit` bytes.
pub(super) async fn read_body(request: Request, limit: usize) -> Result<Bytes, Problem> {
    let length = request.headers().typed_get::<ContentLength>();
    let waits_for_consent = request.headers().contains_key(header::EXPECT);
    let linger = if waits_for_consent { 0 } else { LINGER_BYTES };
    if length.is_some_and(|ContentLength(length)| length > (limit + linger) as u64) {
        return Err(Problem::body_too_large(limit));
    }
    let mut stream = request.into_body().into_data_stream();
    let (mut bytes, mut total) = (vec![], 0);
    while let Some(chunk) = stream.next().await {
        let chunk = chunk.map_err(Problem::unreadable_body)?;
        total += chunk.len();
        if total > limit + LINGER_BYTES {
            break;
        }
        if total <= limit {
            bytes.extend_from_slice(&chunk);
        }
    }
    if total > limit {
        return Err(Problem::body_too_large(limit));
    }
    Ok(bytes.into())
}

/// Returns the type of the body in small letters, without parameters; empty if it has none.
pub(super) fn content_type(headers: &HeaderMap) -> String {
    let value = headers.get(header::CONTENT_TYPE);
    let value = value.and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = value.split(';').next().unwrap_or("");
    essence.trim().to_ascii_lowercase()
}
