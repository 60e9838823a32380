//! Bodies, read within their limits.

use crate::http::connection::{Client, HeldBytes, Patience, held};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::body::Bytes;
use axum::extract::Request;
use axum::http::{HeaderMap, header};
use headers::{ContentLength, HeaderMapExt};
use std::sync::Arc;
use std::time::Instant;
use tokio::time::timeout;
use tokio_stream::StreamExt;

/// Bytes above a limit that are still read before the refusal: a client that is cut off while it
/// sends cannot read why.
const LINGER_BYTES: usize = 64 << 20;

/// Reads a body of at most `limit` bytes, as fast as the patience with clients asks for and within
/// the bytes in flight, which it counts for as long as a part of it is held.
pub(super) async fn read_body(
    state: &AppState,
    request: Request,
    limit: usize,
) -> Result<Bytes, Problem> {
    let length = request.headers().typed_get::<ContentLength>();
    let waits_for_consent = request.headers().contains_key(header::EXPECT);
    let linger = if waits_for_consent { 0 } else { LINGER_BYTES };
    if length.is_some_and(|ContentLength(length)| length > (limit + linger) as u64) {
        return Err(Problem::body_too_large(limit));
    }
    let client = Client::of(request.extensions());
    let mut patience = Patience::new(state.limits().stall_timeout_s);
    let mut right = HeldBytes::new(client);
    let mut stream = request.into_body().into_data_stream();
    let (mut bytes, mut total) = (vec![], 0);
    loop {
        let start = Instant::now();
        let next = timeout(patience.left(), stream.next()).await;
        let Some(chunk) = next.map_err(|_| Problem::too_slow())? else {
            break;
        };
        let chunk = chunk.map_err(Problem::unreadable_body)?;
        patience.note(start.elapsed(), chunk.len());
        total += chunk.len();
        if total > limit + LINGER_BYTES {
            break;
        }
        if total > limit {
            // Read on, and kept no longer.
            bytes = vec![];
            right = HeldBytes::new(client);
            continue;
        }
        // The buffer doubles: its room counts, not what is in it.
        let room = total.next_power_of_two().min(limit);
        if !state.uploads.extend(&mut right, room) {
            return Err(Problem::too_many_bytes());
        }
        bytes.reserve_exact(room.saturating_sub(bytes.len()));
        bytes.extend_from_slice(&chunk);
    }
    if total > limit {
        return Err(Problem::body_too_large(limit));
    }
    Ok(held(bytes.into(), &Arc::new(right)))
}

/// Returns a copy of a part of a body, counted in the bytes in flight of `client`.
pub(super) fn keep_part(state: &AppState, client: Client, part: Bytes) -> Result<Bytes, Problem> {
    let right = state.uploads.take(client, part.len());
    let right = right.ok_or_else(Problem::too_many_bytes)?;
    Ok(held(part, &Arc::new(right)))
}

/// Returns the type of the body in small letters, without parameters; empty if it has none.
pub(super) fn content_type(headers: &HeaderMap) -> String {
    let value = headers.get(header::CONTENT_TYPE);
    let value = value.and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = value.split(';').next().unwrap_or("");
    essence.trim().to_ascii_lowercase()
}
