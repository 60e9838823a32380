//! `/v1/patterns`: DXF files and `GarmentCode` specifications in, patterns and drawings out.

use super::answer::Answer;
use super::body::Upload;
use super::listing::{Asking, Id, ListAsked};
use super::problem::Problem;
use super::state::App;
use crate::export::drawing_svg;
use crate::job::{DocumentKind, Stored};
use crate::pattern::{self, Format, ImportOptions, Pattern, RotationOrder, Units};
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use uuid::Uuid;

pub(super) fn router() -> Router<App> {
    Router::new()
        .route("/v1/patterns", get(list).post(create))
        .route("/v1/patterns/{id}", get(show).delete(remove))
        .route("/v1/patterns/{id}/drawing.svg", get(drawing))
}

/// What a caller may say about a file that the file does not.
#[derive(Clone, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct ImportAsked {
    /// Unit of the coordinates, overriding what the file says.
    #[param(inline)]
    pub units: Option<Units>,
    /// Size to import from a graded file; the sample size if absent.
    pub size: Option<String>,
    /// How the three angles of a `GarmentCode` panel make up its rotation: `xyz` (R = Rx Ry Rz, as it writes) if absent.
    #[param(inline)]
    pub rotation_order: Option<RotationOrder>,
}

impl ImportAsked {
    /// With the name of the file.
    pub(super) fn of_file(self, name: Option<String>) -> ImportOptions {
        ImportOptions {
            name,
            units: self.units,
            size: self.size,
            rotation_order: self.rotation_order.unwrap_or_default(),
        }
    }
}

/// A pattern in a list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct PatternItem {
    /// Its id.
    pub id: Uuid,
    /// Its name.
    pub name: String,
    /// When it was stored.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// The dialect of its file.
    pub format: Format,
    /// How many panels it has.
    pub panel_count: usize,
}

impl From<Stored<Pattern>> for PatternItem {
    fn from(stored: Stored<Pattern>) -> Self {
        Self {
            id: stored.id,
            name: stored.value.name,
            created_at: stored.created_at,
            format: stored.value.source.format,
            panel_count: stored.value.panels.len(),
        }
    }
}

/// Patterns, newest first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct PatternList {
    /// The patterns.
    pub patterns: Vec<PatternItem>,
    /// `cursor` of the next page, if there is one.
    pub next_cursor: Option<Uuid>,
}

/// Read a DXF file or a `GarmentCode` specification and keep its pattern
#[utoipa::path(post, path = "/v1/patterns", tag = "patterns", params(ImportAsked),
    request_body(description = "The bytes of a DXF file, a GarmentCode specification, or a form with one of them as the part `file`", content(
        (Vec<u8> = "image/vnd.dxf"), (serde_json::Value = "application/json"), (super::openapi::PatternForm = "multipart/form-data"))),
    responses(
        (status = 201, description = "It was read and kept", body = Pattern, headers(("Location", description = "The pattern"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Everything that keeps it from being read", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn create(
    State(app): State<App>,
    Asking(asked): Asking<ImportAsked>,
    file: Upload,
) -> Result<impl IntoResponse, Problem> {
    let stored = app
        .heavy(move |app| {
            let options = asked.of_file(file.name);
            let pattern = pattern::import(&file.bytes, &options, app.limits())?;
            Ok::<_, Problem>(app.catalogue().add_pattern(pattern)?)
        })
        .await??;
    let location = format!("/v1/patterns/{}", stored.id);
    Ok((
        StatusCode::CREATED,
        [(header::LOCATION, location)],
        Json(stored.value),
    ))
}

/// The patterns that are kept, newest first
#[utoipa::path(get, path = "/v1/patterns", tag = "patterns", params(ListAsked), responses(
    (status = 200, description = "A part of the list", body = PatternList)))]
pub(super) async fn list(
    State(app): State<App>,
    Asking(asked): Asking<ListAsked>,
) -> Result<Json<PatternList>, Problem> {
    let page = asked.page()?;
    let page = app
        .blocking(move |app| app.catalogue().patterns(&page))
        .await??;
    Ok(Json(PatternList {
        patterns: page.items.into_iter().map(PatternItem::from).collect(),
        next_cursor: page.next,
    }))
}

/// One pattern
#[utoipa::path(get, path = "/v1/patterns/{id}", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The pattern", body = Pattern),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn show(State(app): State<App>, Id(id): Id) -> Result<Json<Pattern>, Problem> {
    Ok(Json(find(&app, id).await?))
}

/// The pattern with this id.
pub(super) async fn find(app: &App, id: Uuid) -> Result<Pattern, Problem> {
    let found = app
        .blocking(move |app| app.catalogue().find_pattern(id))
        .await??;
    let stored = found.ok_or_else(|| unknown(id))?;
    Ok(stored.value)
}

/// The pattern drawn in true proportion, with the numbers of corners and edges that seams name
#[utoipa::path(get, path = "/v1/patterns/{id}/drawing.svg", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The drawing, its view box in millimetres", content_type = "image/svg+xml", body = String),
    (status = 304, description = "It is the one in `If-None-Match`"),
    (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn drawing(
    State(app): State<App>,
    Id(id): Id,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let pattern = find(&app, id).await?;
    let svg = app.heavy(move |_| drawing_svg(&pattern)).await?;
    Answer::new(svg, "image/svg+xml").to(&headers)
}

/// Remove a pattern; fits keep their own copy
#[utoipa::path(delete, path = "/v1/patterns/{id}", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 204, description = "It is gone"),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn remove(State(app): State<App>, Id(id): Id) -> Result<StatusCode, Problem> {
    let removed = app
        .blocking(move |app| app.catalogue().remove(DocumentKind::Pattern, id))
        .await??;
    removed
        .then_some(StatusCode::NO_CONTENT)
        .ok_or_else(|| unknown(id))
}

fn unknown(id: Uuid) -> Problem {
    Problem::not_found(format!("There is no pattern {id}."))
}
