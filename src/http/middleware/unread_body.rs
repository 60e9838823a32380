//! Tells clients that a connection ends whose request was answered before its body was read.

use axum::body::{Body, HttpBody};
use axum::extract::Request;
use axum::http::{HeaderValue, header};
use axum::middleware::Next;
use axum::response::Response;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tokio_stream::StreamExt;

/// Adds `Connection: close` to an answer that came before the body of its request was read: what is
/// left of it would be taken for the next request.
pub(in crate::http) async fn close_after_unread_body(request: Request, next: Next) -> Response {
    if request.body().is_end_stream() {
        return next.run(request).await;
    }
    let is_read = Arc::new(AtomicBool::new(false));
    let at_end = Arc::clone(&is_read);
    let request = request.map(|body| {
        let end = std::iter::from_fn(move || {
            at_end.store(true, Ordering::Relaxed);
            None
        });
        Body::from_stream(body.into_data_stream().chain(tokio_stream::iter(end)))
    });
    let mut response = next.run(request).await;
    if !is_read.load(Ordering::Relaxed) {
        let close = HeaderValue::from_static("close");
        response.headers_mut().insert(header::CONNECTION, close);
    }
    response
}
