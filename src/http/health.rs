//! Probes: whether the process lives, whether it can serve.

use super::problem::Problem;
use super::state::App;
use crate::job::JobKind;
use axum::extract::State;
use axum::routing::get;
use axum::{Json, Router};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

pub(super) fn router() -> Router<App> {
    Router::new()
        .route("/health/live", get(live))
        .route("/health/ready", get(ready))
}

/// How the service is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(super) struct Health {
    /// `ok`.
    pub status: String,
    /// Version of the program.
    pub version: String,
}

impl Health {
    fn ok() -> Json<Self> {
        Json(Self {
            status: "ok".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        })
    }
}

/// Whether the process lives
#[utoipa::path(get, path = "/health/live", tag = "service", security(()), responses(
    (status = 200, description = "It does", body = Health)
))]
pub(super) async fn live() -> Json<Health> {
    Health::ok()
}

/// Whether the service can be sent requests: its store answers
#[utoipa::path(get, path = "/health/ready", tag = "service", security(()), responses(
    (status = 200, description = "It can", body = Health),
    (status = 503, description = "It cannot now", body = Problem, content_type = "application/problem+json")
))]
pub(super) async fn ready(State(app): State<App>) -> Result<Json<Health>, Problem> {
    let counts = app.blocking(|app| app.queue.counts(JobKind::Fit)).await?;
    counts.map_err(|error| {
        tracing::error!(%error, "the store does not answer");
        Problem::unavailable("The store does not answer.", 5)
    })?;
    Ok(Health::ok())
}
