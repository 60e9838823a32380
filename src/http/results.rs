//! `/v1/fits/{id}/...`: what a fit leaves: mesh, report, scene, and the garment it was asked as.

use super::answer::Answer;
use super::jobs;
use super::listing::Id;
use super::prefer;
use super::problem::Problem;
use super::state::{App, Shared};
use crate::export::{self, GarmentMesh};
use crate::fit;
use crate::job::{JobKind, ResultFile, StoreError};
use crate::progress::CancelToken;
use crate::solver::Context;
use axum::Router;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, header};
use axum::response::Response;
use axum::routing::get;
use uuid::Uuid;

const GLB: &str = "model/gltf-binary";
const OBJ: &str = "model/obj";
const JSON: &str = "application/json";

pub(super) fn router() -> Router<App> {
    Router::new()
        .route("/v1/fits/{id}/mesh", get(mesh))
        .route("/v1/fits/{id}/mesh.glb", get(mesh_glb))
        .route("/v1/fits/{id}/mesh.obj", get(mesh_obj))
        .route("/v1/fits/{id}/mesh.json", get(mesh_json))
        .route("/v1/fits/{id}/report", get(report))
        .route("/v1/fits/{id}/scene", get(scene))
        .route("/v1/fits/{id}/garment", get(garment))
}

/// The shape, in the format that `Accept` names; GLB if none
#[utoipa::path(get, path = "/v1/fits/{id}/mesh", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content((Vec<u8> = "model/gltf-binary"), (String = "model/obj"), (GarmentMesh = "application/json"))),
    (status = 206, description = "The part of it in `Range`"),
    (status = 304, description = "It is the one in `If-None-Match`"),
    (status = 404, description = "There is no such fit, or it left none", body = Problem, content_type = "application/problem+json"),
    (status = 406, description = "No such format", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn mesh(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let offered = [GLB, OBJ, JSON];
    let format = prefer::accepted(&headers, &offered);
    let format = format.ok_or_else(|| Problem::not_acceptable(&offered.join(", ")))?;
    let mut response = mesh_as(&app, id, format, &headers).await?;
    response
        .headers_mut()
        .insert(header::VARY, HeaderValue::from_static("accept"));
    Ok(response)
}

/// The shape as binary glTF 2.0: one node per panel, UV are pattern coordinates
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.glb", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/gltf-binary", body = Vec<u8>)))]
pub(super) async fn mesh_glb(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&app, id, GLB, &headers).await
}

/// The shape as Wavefront OBJ: one group per panel
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.obj", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/obj", body = String)))]
pub(super) async fn mesh_obj(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&app, id, OBJ, &headers).await
}

/// The shape as JSON
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.json", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", body = GarmentMesh)))]
pub(super) async fn mesh_json(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&app, id, JSON, &headers).await
}

async fn mesh_as(
    app: &App,
    id: Uuid,
    format: &'static str,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    let answer = app
        .heavy(move |app| {
            let json = jobs::file(app, JobKind::Fit, id, ResultFile::Mesh)?;
            Ok::<_, Problem>(Answer::new(in_format(json, format)?, format))
        })
        .await??;
    answer.to(headers)
}

fn in_format(json: Vec<u8>, format: &str) -> Result<Vec<u8>, Problem> {
    if format == JSON {
        return Ok(json);
    }
    let mesh: GarmentMesh =
        serde_json::from_slice(&json).map_err(|cause| StoreError::new("reading a mesh", cause))?;
    Ok(if format == GLB {
        export::glb(&mesh)
    } else {
        export::obj(&mesh).into_bytes()
    })
}

/// How far to trust the shape
#[utoipa::path(get, path = "/v1/fits/{id}/report", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The report", body = crate::solver::Report),
    (status = 404, description = "There is no such fit, or it left none", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn report(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let json = app
        .blocking(move |app| jobs::file(app, JobKind::Fit, id, ResultFile::Report))
        .await??;
    Answer::new(json, JSON).to(&headers)
}

/// The assembled scene in neutral JSON, for other simulators; made when it is asked for, whatever has become of the fit
#[utoipa::path(get, path = "/v1/fits/{id}/scene", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The scene", body = Object),
    (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "What keeps it from being assembled", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn scene(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let asked = WhileAsked(CancelToken::new());
    let cancel = asked.0.clone();
    let json = app.heavy(move |app| assembled(app, id, &cancel)).await??;
    Answer::new(json, JSON).to(&headers)
}

/// Stops the work for a call when the call is given up: meshing may take longer than a client waits.
struct WhileAsked(CancelToken);

impl Drop for WhileAsked {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// The scene of a stored garment, as the worker assembles it.
fn assembled(app: &Shared, id: Uuid, cancel: &CancelToken) -> Result<Vec<u8>, Problem> {
    let garment = jobs::asked(app, JobKind::Fit, id)?;
    let garment = serde_json::from_slice(&garment)
        .map_err(|cause| StoreError::new("reading a garment", cause))?;
    let prepared = fit::prepare(garment, app.catalogue(), app.limits())?;
    let context = Context {
        cpu_s: &|| 0.0,
        cancel,
        progress: &mut |_| {},
        limits: app.limits(),
    };
    Ok(fit::scene_json(&prepared, &context)?)
}

/// The saved garment file, complete in itself
#[utoipa::path(get, path = "/v1/fits/{id}/garment", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The garment", body = crate::fit::Garment),
    (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn garment(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let json = app.blocking(move |app| jobs::asked(app, JobKind::Fit, id));
    Answer::new(json.await??, JSON).to(&headers)
}
