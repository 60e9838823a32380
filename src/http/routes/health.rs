//! Probes: the process lives, the process can serve.

use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::Json;
use axum::extract::State;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Health of the service.
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

/// Liveness: the process answers
#[utoipa::path(get, path = "/health/live", tag = "service", security(()), responses(
    (status = 200, description = "It does", body = Health)
))]
pub(super) async fn live() -> Json<Health> {
    Health::ok()
}

/// Readiness: a moment ago something could be written to and read from the folder of the data
#[utoipa::path(get, path = "/health/ready", tag = "service", security(()), responses(
    (status = 200, description = "It can", body = Health),
    (status = 503, description = "It cannot now", body = Problem, content_type = "application/problem+json")
))]
pub(super) async fn ready(State(state): State<AppState>) -> Result<Json<Health>, Problem> {
    let probed = state.clone();
    let probe = async move { probe(&probed).await };
    if state.readiness.is_ready(probe).await {
        Ok(Health::ok())
    } else {
        Err(Problem::store_unavailable())
    }
}

/// Returns true if the store can be used, and logs why not.
async fn probe(state: &AppState) -> bool {
    match state.run_unbounded(|app| app.queue.probe()).await {
        Ok(Ok(())) => true,
        Ok(Err(error)) => {
            tracing::error!(%error, "not ready");
            false
        }
        Err(_) => false,
    }
}
