//! Bounds the bytes of answers that wait for their clients.

use crate::http::connection::{Client, held};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::body::{Body, HttpBody};
use axum::extract::{Request, State};
use axum::http::{HeaderValue, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::sync::Arc;
use tokio_stream::StreamExt;

/// Counts an answer in the bytes in flight until its client has taken it. Where there is no room
/// for it, the client is told to come again; the answer of a request which has changed something
/// goes out uncounted, since the client must learn of it.
pub(in crate::http) async fn count_answer_bytes(
    State(state): State<AppState>,
    request: Request,
    next: Next,
) -> Response {
    let client = Client::of(request.extensions());
    let response = next.run(request).await;
    // Streams of events have no length; they are bounded by their number.
    let Some(length) = response.body().size_hint().exact() else {
        return response;
    };
    let bytes = usize::try_from(length).unwrap_or(usize::MAX);
    let Some(right) = state.answers.take(client, bytes) else {
        // A handler that changes something and answers with a body sets it.
        if response.headers().contains_key(header::LOCATION) {
            return response;
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Limits;
    use axum::Router;
    use axum::http::Method;
    use axum::middleware::from_fn_with_state;
    use axum::routing::{get, post};
    use tower::ServiceExt;

    /// The status of an answer of 128 KiB to a method; `/made` is that to what was made.
    async fn status(state: &AppState, method: Method, path: &str) -> u16 {
        let answer = || async { vec![0; 128 << 10] };
        let made = || async { ([(header::LOCATION, "/made/1")], vec![0; 128 << 10]) };
        let router = Router::new()
            .route("/", get(answer).post(answer))
            .route("/made", post(made))
            .layer(from_fn_with_state(state.clone(), count_answer_bytes));
        let request = Request::builder().method(method).uri(path);
        let request = request.body(Body::empty());
        let answer = router.oneshot(request.unwrap()).await;
        answer.unwrap().status().as_u16()
    }

    #[test]
    fn only_answers_that_can_be_had_again_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let limits = Limits {
            answer_bytes_in_flight: 1 << 20,
            ..Limits::default()
        };
        let state = AppState::of_test(folder.path(), limits);
        let all = state.answers.take(Client::Token(0), 2 << 20);
        assert!(all.is_some());
        let runtime = tokio::runtime::Builder::new_current_thread().build();
        runtime.unwrap().block_on(async {
            for method in [Method::GET, Method::HEAD, Method::POST] {
                assert_eq!(status(&state, method, "/").await, 503);
            }
            assert_eq!(status(&state, Method::POST, "/made").await, 200);
            drop(all);
            assert_eq!(status(&state, Method::GET, "/").await, 200);
            assert_eq!(status(&state, Method::POST, "/").await, 200);
        });
    }
}
