//! The service: routes, guards, problems as RFC 9457, events, `OpenAPI` and the page.
//!
//! One file a resource, each with its `router()`. Handlers extract, check, call the domain and wrap; all that a client sends is
//! checked in the extractors (`body`, `fit_asked`, `listing`), so that a handler can only receive a valid value.

mod answer;
mod avatars;
mod body;
mod events;
mod fabrics;
mod fit_asked;
mod fits;
mod forms;
mod guard;
mod health;
mod jobs;
mod listing;
mod metrics;
mod observe;
mod openapi;
mod page;
mod patterns;
mod prefer;
mod problem;
mod results;
mod seams;
mod state;
mod studies;

pub use openapi::openapi_json;
pub use problem::Problem;

use crate::config::Config;
use crate::job::Queue;
use axum::error_handling::HandleErrorLayer;
use axum::http::{Method, Uri};
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::{BoxError, Router};
use state::App;
use std::any::Any;
use std::io;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tower::ServiceBuilder;
use tower::limit::GlobalConcurrencyLimitLayer;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::request_id::{MakeRequestUuid, PropagateRequestIdLayer, SetRequestIdLayer};

/// Requests worked on at the same time; further ones are turned away at once.
const CONCURRENT: usize = 512;
/// How long a request may take beside the wait that it asks for: an upload over a slow line.
const REQUEST: Duration = Duration::from_secs(60);

/// Serves until `shutdown`, then lets requests end.
///
/// # Errors
/// If the address cannot be listened on.
pub async fn serve(
    config: &Config,
    queue: Arc<Queue>,
    shutdown: impl Future<Output = ()> + Send + 'static,
) -> io::Result<()> {
    let listener = TcpListener::bind(config.listen).await?;
    tracing::info!("listening on http://{}", listener.local_addr()?);
    let router = router(config, Arc::clone(&queue));
    let shutdown = async move {
        shutdown.await;
        queue.close();
    };
    axum::serve(listener, router)
        .with_graceful_shutdown(shutdown)
        .await
}

/// All routes with their guards.
pub fn router(config: &Config, queue: Arc<Queue>) -> Router {
    let app = App::new(config, queue);
    let guarded = calls().route_layer(from_fn_with_state(app.clone(), guard::token));
    let bounded = guarded
        .merge(page::docs())
        .merge(openapi::router())
        .fallback(page::file)
        .method_not_allowed_fallback(method_not_allowed)
        .layer(
            ServiceBuilder::new()
                .layer(HandleErrorLayer::new(overloaded))
                .load_shed()
                .layer(GlobalConcurrencyLimitLayer::new(CONCURRENT))
                .timeout(REQUEST + Duration::from_secs_f64(app.limits().wait_s)),
        );
    let outside = ServiceBuilder::new()
        .layer(SetRequestIdLayer::x_request_id(MakeRequestUuid))
        .layer(PropagateRequestIdLayer::x_request_id())
        .layer(from_fn_with_state(app.clone(), observe::observe))
        .layer(CatchPanicLayer::custom(panicked))
        .layer(from_fn_with_state(app.clone(), guard::same_site));
    // Probes are answered even where requests are turned away.
    bounded
        .merge(health::router())
        .layer(outside)
        .with_state(app)
}

/// The calls that need a token.
fn calls() -> Router<App> {
    patterns::router()
        .merge(seams::router())
        .merge(fabrics::router())
        .merge(avatars::router())
        .merge(fits::router())
        .merge(studies::router())
        .merge(events::router())
        .merge(results::router())
        .merge(metrics::router())
}

async fn method_not_allowed(method: Method, uri: Uri) -> Problem {
    Problem::method_not_allowed(method.as_str(), uri.path())
}

async fn overloaded(error: BoxError) -> Problem {
    if error.is::<tower::timeout::error::Elapsed>() {
        Problem::timed_out()
    } else {
        Problem::unavailable("The service has as many requests as it can work on.", 1)
    }
}

fn panicked(panic: Box<dyn Any + Send>) -> Response {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    Problem::internal(text.unwrap_or("a panic")).into_response()
}
