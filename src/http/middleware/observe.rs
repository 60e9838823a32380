//! A line of the log and a count for each request, and the headers of every answer.

use crate::http::state::AppState;
use axum::extract::{MatchedPath, Request, State};
use axum::http::{HeaderName, HeaderValue, header};
use axum::middleware::Next;
use axum::response::Response;
use std::time::Instant;
use tracing::Instrument;

/// Headers of every answer that does not set its own.
const HEADERS: [(HeaderName, &str); 5] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'none'; frame-ancestors 'none'",
    ),
    (
        HeaderName::from_static("cross-origin-resource-policy"),
        "same-origin",
    ),
    (
        HeaderName::from_static("cross-origin-opener-policy"),
        "same-origin",
    ),
];

/// Routes that are called every few seconds, and say nothing new.
const PROBES: &str = "/health/";
/// Most characters of the id that a client gives its request.
const MAX_ID_CHARS: usize = 128;

/// Drops an id of a request that is too long or no visible ASCII: a new one takes its place.
pub(in crate::http) async fn bound_request_id(mut request: Request, next: Next) -> Response {
    let id = request.headers().get("x-request-id");
    let is_good = |id: &HeaderValue| {
        let id = id.as_bytes();
        (1..=MAX_ID_CHARS).contains(&id.len()) && id.iter().all(u8::is_ascii_graphic)
    };
    if id.is_some_and(|id| !is_good(id)) {
        request.headers_mut().remove("x-request-id");
    }
    next.run(request).await
}

/// Logs and counts a request by its route, and adds the headers of every answer.
pub(in crate::http) async fn observe(
    State(state): State<AppState>,
    request: Request,
    next: Next,
) -> Response {
    let route = request.extensions().get::<MatchedPath>();
    let route = route.map_or("none", MatchedPath::as_str).to_owned();
    let method = request.method().clone();
    let id = request.headers().get("x-request-id");
    let id = id.and_then(|id| id.to_str().ok()).unwrap_or_default();
    let span = tracing::info_span!("request", id, %method, path = request.uri().path());
    let start = Instant::now();
    let mut response = next.run(request).instrument(span.clone()).await;
    let seconds = start.elapsed().as_secs_f64();
    let status = response.status().as_u16();
    if route.starts_with(PROBES) {
        span.in_scope(|| tracing::debug!(status, seconds, "answered"));
    } else {
        span.in_scope(|| tracing::info!(status, seconds, "answered"));
    }
    state.metrics.add(&method, route, status, seconds);
    for (name, value) in HEADERS {
        let value = HeaderValue::from_static(value);
        response.headers_mut().entry(name).or_insert(value);
    }
    response
}
