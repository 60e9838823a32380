//! `/v1/fits/{id}/...`: the results of a fit: mesh, report, scene, and its garment.

use super::jobs;
use crate::export::{self, GarmentMesh};
use crate::fit::{self, ResolvedGarment};
use crate::http::extract::{PathId, PictureQuery, ValidatedQuery, preferred_type};
use crate::http::respond::{Problem, respond_computed, respond_stored};
use crate::http::state::{App, AppState};
use crate::job::{JobKind, ResultFile, StoreError};
use crate::progress::CancelToken;
use crate::solver::{Context, DrapeReport};
use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, header};
use axum::response::Response;
use serde::de::DeserializeOwned;
use uuid::Uuid;

const GLB: &str = "model/gltf-binary";
const OBJ: &str = "model/obj";
const PLY: &str = "model/ply";
const JSON: &str = "application/json";
const PNG: &str = "image/png";

/// The shape, in the format that `Accept` names; GLB if none
#[utoipa::path(get, path = "/v1/fits/{id}/mesh", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content((Vec<u8> = "model/gltf-binary"), (String = "model/obj"), (Vec<u8> = "model/ply"), (GarmentMesh = "application/json"))),
    (status = 206, description = "The part of it in `Range`"),
    (status = 304, description = "It is the one in `If-None-Match`"),
    (status = 404, description = "There is no such fit, or it left none", body = Problem, content_type = "application/problem+json"),
    (status = 406, description = "No such format", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn mesh(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let offered = [GLB, OBJ, PLY, JSON];
    let format = preferred_type(&headers, &offered);
    let format = format.ok_or_else(|| Problem::not_acceptable(&offered.join(", ")))?;
    let mut response = mesh_as(&state, id, format, &headers).await?;
    response
        .headers_mut()
        .insert(header::VARY, HeaderValue::from_static("accept"));
    Ok(response)
}

/// The shape as binary glTF 2.0: one node per panel, UV are pattern coordinates
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.glb", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/gltf-binary", body = Vec<u8>)))]
pub(super) async fn mesh_glb(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&state, id, GLB, &headers).await
}

/// The shape as Wavefront OBJ: one group per panel
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.obj", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/obj", body = String)))]
pub(super) async fn mesh_obj(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&state, id, OBJ, &headers).await
}

/// The shape as binary PLY: one list of vertices, with the maps that were asked for
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.ply", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/ply", body = Vec<u8>)))]
pub(super) async fn mesh_ply(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&state, id, PLY, &headers).await
}

/// The shape as JSON
#[utoipa::path(get, path = "/v1/fits/{id}/mesh.json", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", body = GarmentMesh)))]
pub(super) async fn mesh_json(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    mesh_as(&state, id, JSON, &headers).await
}

async fn mesh_as(
    state: &AppState,
    id: Uuid,
    format: &'static str,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    let make = move |app: &App| {
        let json = jobs::result_file(app, JobKind::Fit, id, ResultFile::Mesh)?;
        convert_mesh(json, format)
    };
    respond_computed(state, headers, format, make).await
}

fn convert_mesh(json: Vec<u8>, format: &str) -> Result<Vec<u8>, Problem> {
    if format == JSON {
        return Ok(json);
    }
    let mesh: GarmentMesh = serde_json::from_slice(&json)
        .map_err(|cause| StoreError::of_data("reading a mesh", cause))?;
    Ok(match format {
        GLB => export::glb(&mesh),
        PLY => export::ply(&mesh),
        _ => export::obj(&mesh).into_bytes(),
    })
}

/// The garment on its body as PNG, places where it passes through itself or the body marked in red
#[utoipa::path(get, path = "/v1/fits/{id}/picture.png", tag = "results", params(("id" = Uuid, Path), PictureQuery), responses(
    (status = 200, description = "The picture", content_type = "image/png", body = Vec<u8>),
    (status = 404, description = "There is no such fit, or it left no shape", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "A width outside the limits", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn picture(
    State(state): State<AppState>,
    PathId(id): PathId,
    ValidatedQuery(query): ValidatedQuery<PictureQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let make = move |app: &App| draw(app, id, query);
    respond_computed(&state, &headers, PNG, make).await
}

fn draw(app: &App, id: Uuid, query: PictureQuery) -> Result<Vec<u8>, Problem> {
    let mesh: GarmentMesh = read_result(app, id, ResultFile::Mesh)?;
    let report: DrapeReport = read_result(app, id, ResultFile::Report)?;
    let garment = resolved(app, id)?;
    let asked = (query.view, query.width);
    let picture = fit::picture(&garment, (&mesh, &report), asked, app.limits())?;
    Ok(picture.png())
}

/// Reads a stored result of a fit.
fn read_result<T: DeserializeOwned>(app: &App, id: Uuid, file: ResultFile) -> Result<T, Problem> {
    let json = jobs::result_file(app, JobKind::Fit, id, file)?;
    Ok(serde_json::from_slice(&json)
        .map_err(|cause| StoreError::of_data("reading the result of a fit", cause))?)
}

/// Measures of the garment: areas, lengths of seams, girths beside those of the body
#[utoipa::path(get, path = "/v1/fits/{id}/measures", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The measures", body = fit::GarmentMeasures),
    (status = 404, description = "There is no such fit, or it left no shape", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn measures(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let guard = CancelOnDrop(CancelToken::new());
    let cancel = guard.0.clone();
    let make = move |app: &App| {
        let mesh: GarmentMesh = read_result(app, id, ResultFile::Mesh)?;
        let garment = resolved(app, id)?;
        let measures = with_context(app, &cancel, |context| {
            fit::measures(&garment, &mesh, context)
        })?;
        let json = serde_json::to_vec(&measures);
        Ok::<_, Problem>(json.expect("lists of numbers always serialize"))
    };
    respond_computed(&state, &headers, JSON, make).await
}

/// Report of a fit: how far to trust the shape
#[utoipa::path(get, path = "/v1/fits/{id}/report", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The report", body = crate::solver::DrapeReport),
    (status = 404, description = "There is no such fit, or it left none", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The fit has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn report(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let read = move |app: &App| jobs::result_file(app, JobKind::Fit, id, ResultFile::Report);
    respond_stored(&state, &headers, JSON, read).await
}

/// The assembled scene in neutral JSON, for other simulators; made when it is asked for, whatever
/// has become of the fit
#[utoipa::path(get, path = "/v1/fits/{id}/scene", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The scene", body = Object),
    (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "What keeps it from being assembled", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn scene(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let guard = CancelOnDrop(CancelToken::new());
    let cancel = guard.0.clone();
    let make = move |app: &App| assemble_scene(app, id, &cancel);
    respond_computed(&state, &headers, JSON, make).await
}

/// Cancels the work for a request when the request is given up: meshing may take longer than a
/// client waits.
struct CancelOnDrop(CancelToken);

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Assembles the scene of a stored garment as the worker does.
fn assemble_scene(app: &App, id: Uuid, cancel: &CancelToken) -> Result<Vec<u8>, Problem> {
    let garment = resolved(app, id)?;
    let json = with_context(app, cancel, |context| fit::scene_json(&garment, context))?;
    Ok(json)
}

/// Calls `make` with the context of work that is not followed and has no time limit.
fn with_context<T>(app: &App, cancel: &CancelToken, make: impl FnOnce(&Context<'_>) -> T) -> T {
    make(&Context {
        cpu_s: &|| 0.0,
        cancel,
        progress: &mut |_| {},
        limits: app.limits(),
    })
}

/// Reads the stored garment of a fit and resolves it as the worker does.
fn resolved(app: &App, id: Uuid) -> Result<ResolvedGarment, Problem> {
    let garment = jobs::request(app, JobKind::Fit, id)?;
    let garment = serde_json::from_slice(&garment)
        .map_err(|cause| StoreError::of_data("reading a garment", cause))?;
    Ok(fit::resolve(garment, app.catalogue(), app.limits())?)
}

/// The saved garment file, complete in itself
#[utoipa::path(get, path = "/v1/fits/{id}/garment", tag = "results", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The garment", body = crate::fit::Garment),
    (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn garment(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let read = move |app: &App| jobs::request(app, JobKind::Fit, id);
    respond_stored(&state, &headers, JSON, read).await
}
