//! The routes of the service, one file a resource. Each path is written once, at its handler.

mod avatars;
mod events;
mod fabrics;
mod fit_results;
mod fits;
mod health;
mod jobs;
mod metrics;
pub(super) mod openapi;
pub(super) mod page;
mod pattern_files;
mod patterns;
mod seams;
mod studies;

use super::state::AppState;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

/// Returns the routes of all resources; they need a token.
pub(super) fn resources() -> OpenApiRouter<AppState> {
    OpenApiRouter::default()
        .routes(routes!(patterns::list, patterns::create))
        .routes(routes!(patterns::show, patterns::remove))
        .routes(routes!(patterns::drawing))
        .routes(routes!(pattern_files::aama))
        .routes(routes!(pattern_files::specification))
        .routes(routes!(seams::check))
        .routes(routes!(seams::suggest))
        .routes(routes!(fabrics::list, fabrics::create))
        .routes(routes!(fabrics::show))
        .routes(routes!(avatars::list, avatars::create))
        .routes(routes!(avatars::show, avatars::remove))
        .routes(routes!(avatars::mesh))
        .routes(routes!(fits::list, fits::create))
        .routes(routes!(fits::show, fits::cancel))
        .routes(routes!(events::fit_events))
        .routes(routes!(fit_results::mesh))
        .routes(routes!(fit_results::mesh_glb))
        .routes(routes!(fit_results::mesh_obj))
        .routes(routes!(fit_results::mesh_ply))
        .routes(routes!(fit_results::mesh_json))
        .routes(routes!(fit_results::picture))
        .routes(routes!(fit_results::measures))
        .routes(routes!(fit_results::report))
        .routes(routes!(fit_results::scene))
        .routes(routes!(fit_results::garment))
        .routes(routes!(studies::list, studies::create))
        .routes(routes!(studies::show, studies::cancel))
        .routes(routes!(studies::plot))
        .routes(routes!(studies::request))
        .routes(routes!(events::study_events))
}

/// Returns the routes of the probes; they need no token.
pub(super) fn probes() -> OpenApiRouter<AppState> {
    OpenApiRouter::default()
        .routes(routes!(health::live))
        .routes(routes!(health::ready))
}

/// Returns the route of the counters; it needs a token.
pub(super) fn metrics() -> OpenApiRouter<AppState> {
    OpenApiRouter::default().routes(routes!(metrics::metrics))
}
