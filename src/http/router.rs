//! All routes with their middleware.

use super::middleware::{access, answer_bytes, observe, unread_body};
use super::respond::Problem;
use super::routes::{self, openapi, page};
use super::state::AppState;
use crate::config::Config;
use crate::job::Queue;
use axum::error_handling::HandleErrorLayer;
use axum::http::{Method, Uri};
use axum::middleware::{from_fn, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::{BoxError, Router};
use std::any::Any;
use std::sync::Arc;
use std::time::Duration;
use tower::ServiceBuilder;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::request_id::{MakeRequestUuid, PropagateRequestIdLayer, SetRequestIdLayer};

/// Time limit of a request: the largest upload over a slow line. Who stands still is cut off long
/// before.
const REQUEST_TIMEOUT: Duration = Duration::from_secs(1_800);

/// Builds the router of the service.
pub fn router(config: &Config, queue: Arc<Queue>) -> Router {
    let state = AppState::new(config, queue);
    let guarded = Router::from(routes::resources().merge(routes::metrics()))
        .route_layer(from_fn_with_state(state.clone(), access::require_token));
    let bounded = guarded
        .merge(page::docs_router())
        .merge(openapi::router())
        .fallback(page::file)
        .method_not_allowed_fallback(method_not_allowed)
        .layer(
            ServiceBuilder::new()
                .layer(HandleErrorLayer::new(given_up))
                .timeout(REQUEST_TIMEOUT),
        );
    let outermost = ServiceBuilder::new()
        .layer(from_fn(observe::bound_request_id))
        .layer(SetRequestIdLayer::x_request_id(MakeRequestUuid))
        .layer(PropagateRequestIdLayer::x_request_id())
        .layer(from_fn_with_state(state.clone(), observe::observe))
        .layer(CatchPanicLayer::custom(panicked))
        .layer(from_fn(unread_body::close_after_unread_body))
        .layer(from_fn_with_state(state.clone(), access::require_own_site))
        .layer(from_fn_with_state(state.clone(), access::identify_client))
        .layer(from_fn_with_state(
            state.clone(),
            answer_bytes::count_answer_bytes,
        ));
    // Probes are answered even where requests are turned away.
    bounded
        .merge(Router::from(routes::probes()))
        .layer(outermost)
        .with_state(state)
}

async fn method_not_allowed(method: Method, uri: Uri) -> Problem {
    Problem::method_not_allowed(method.as_str(), uri.path())
}

async fn given_up(error: BoxError) -> Problem {
    if error.is::<tower::timeout::error::Elapsed>() {
        Problem::timed_out()
    } else {
        Problem::internal(error)
    }
}

fn panicked(panic: Box<dyn Any + Send>) -> Response {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    Problem::internal(text.unwrap_or("a panic")).into_response()
}
