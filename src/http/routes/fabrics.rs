//! `/v1/fabrics`: the library, and fabrics of one's own.

use crate::fault::{FabricCode, Fault, Faults};
use crate::http::extract::ValidatedJson;
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::scene::Fabric;
use axum::Json;
use axum::extract::{Path, State};
use axum::http::{StatusCode, header};
use axum::response::IntoResponse;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A fabric with the id that garments name it by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct FabricItem {
    /// Its id.
    pub id: String,
    /// Its coefficients.
    #[serde(flatten)]
    pub fabric: Fabric,
}

/// All fabrics.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct FabricList {
    /// Those shipped and those stored, by id.
    pub fabrics: Vec<FabricItem>,
}

/// All fabrics: those shipped and those stored
#[utoipa::path(get, path = "/v1/fabrics", tag = "fabrics", responses(
    (status = 200, description = "The fabrics", body = FabricList)))]
pub(super) async fn list(State(state): State<AppState>) -> Result<Json<FabricList>, Problem> {
    let fabrics = state
        .run_blocking(|app| app.catalogue().fabrics())
        .await??;
    let items = fabrics.into_iter();
    let fabrics = items
        .map(|(id, fabric)| FabricItem { id, fabric })
        .collect();
    Ok(Json(FabricList { fabrics }))
}

/// Keep a fabric of one's own
#[utoipa::path(post, path = "/v1/fabrics", tag = "fabrics", request_body = Fabric, responses(
    (status = 201, description = "It is kept", body = FabricItem, headers(("Location", description = "The fabric"))),
    (status = 422, description = "Every figure that no cloth has", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn create(
    State(state): State<AppState>,
    ValidatedJson(fabric, _): ValidatedJson<Fabric>,
) -> Result<impl IntoResponse, Problem> {
    check(&fabric, state.limits().name_chars)?;
    let stored = state
        .run_blocking(move |app| app.catalogue().add_fabric(fabric))
        .await??;
    let location = format!("/v1/fabrics/{}", stored.id);
    let item = FabricItem {
        id: stored.id.to_string(),
        fabric: stored.value,
    };
    Ok((
        StatusCode::CREATED,
        [(header::LOCATION, location)],
        Json(item),
    ))
}

/// One fabric
#[utoipa::path(get, path = "/v1/fabrics/{id}", tag = "fabrics", params(("id" = String, Path)), responses(
    (status = 200, description = "The fabric", body = FabricItem),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn show(
    State(state): State<AppState>,
    Path(id): Path<String>,
) -> Result<Json<FabricItem>, Problem> {
    let mut fabrics = state
        .run_blocking(|app| app.catalogue().fabrics())
        .await??;
    let found = fabrics.remove(&id);
    let fabric = found.ok_or_else(|| Problem::unknown_id("fabric", format_args!("{id:?}")))?;
    Ok(Json(FabricItem { id, fabric }))
}

/// Finds every figure that no cloth has, and a name that is too long.
fn check(fabric: &Fabric, name_chars: usize) -> Result<(), Faults> {
    let mut faults = fabric.check("");
    if fabric.name.chars().count() > name_chars {
        let detail = format!("the name is longer than {name_chars} characters");
        faults.push(Fault::new(FabricCode::NameTooLong, "/name", detail));
    }
    Faults(faults).or(())
}
