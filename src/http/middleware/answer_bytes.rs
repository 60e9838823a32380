//! Bounds the bytes of answers that wait for their clients.

use crate::http::connection::held;
use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::body::{Body, HttpBody};
use axum::extract::{Request, State};
use axum::http::{HeaderValue, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::sync::Arc;
use tokio_stream::StreamExt;

/// Counts an answer in the bytes in flight until its client has taken it. Where there is no room,
/// the client is asked to come again.
pub(in crate::http) async fn count_answer_bytes(
    State(state): State<AppState>,
    request: Request,
    next: Next,
) -> Response {
    let client = state.access.client(request.headers()).unwrap_or_default();
    let response = next.run(request).await;
    // Streams of events have no length; they are bounded by their number.
    let Some(length) = response.body().size_hint().exact() else {
        return response;
    };
    let bytes = usize::try_from(length).unwrap_or(usize::MAX);
    let Some(right) = state.answers.take(client, bytes) else {
        return Problem::too_many_bytes().into_response();
    };
    if right.is_free() {
        return response;
    }
    let right = Arc::new(right);
    let mut response = response.map(|body| {
        let chunks = body.into_data_stream();
        Body::from_stream(chunks.map(move |chunk| chunk.map(|chunk| held(chunk, &right))))
    });
    let headers = response.headers_mut();
    headers.insert(header::CONTENT_LENGTH, HeaderValue::from(length));
    response
}
