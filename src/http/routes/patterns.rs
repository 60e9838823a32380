//! `/v1/patterns`: DXF files and `GarmentCode` specifications in, patterns and drawings out.

use crate::export::drawing_svg;
use crate::http::extract::{ListQuery, PathId, PatternUpload, ValidatedQuery};
use crate::http::respond::{Problem, respond_computed};
use crate::http::state::{App, AppState};
use crate::job::{DocumentKind, Stored};
use crate::pattern::{
    self, DrawnDarts, DrawnNotches, GradeTable, ImportOptions, Outlines, Pattern, PatternFormat,
    RotationOrder, TextEncoding, Unfold, Units,
};
use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use uuid::Uuid;

/// Facts about a pattern file that the file itself does not state.
#[derive(Clone, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct ImportQuery {
    /// Unit of the coordinates, overriding what the file says.
    #[param(inline)]
    pub units: Option<Units>,
    /// Encoding of the texts of a DXF, overriding what the file says: a label of the Encoding
    /// Standard (`windows-1251`, `shift_jis`) or a code page (`ANSI_1251`, `cp866`).
    #[param(value_type = Option<String>)]
    pub encoding: Option<TextEncoding>,
    /// Size to import from a graded file; the sample size if absent.
    pub size: Option<String>,
    /// Reading of outlines that lie in others, where layers do not tell: `auto` (by their course)
    /// if absent, `allowance`, `sizes`, `holes`, `lines` or `pieces`.
    #[param(inline)]
    pub outlines: Option<Outlines>,
    /// Reading of notches drawn into an outline, up to 12 mm deep: `marks` if absent, or `cloth`.
    #[param(inline)]
    pub notches: Option<DrawnNotches>,
    /// Reading of darts drawn as lines inside an outline: `cut`, to be sewn, if absent, or `lines`.
    #[param(inline)]
    pub darts: Option<DrawnDarts>,
    /// Folds about which half pieces are unfolded: `all` that the file states if absent, or `none`.
    #[param(inline)]
    pub unfold: Option<Unfold>,
    /// True to refuse a file with a piece that cannot be read or must be mended; else such a piece
    /// is left out or mended, and a warning says so.
    pub strict: bool,
    /// Order of the three angles of a `GarmentCode` panel in its rotation: `xyz` (R = Rx Ry Rz, as
    /// it writes) if absent.
    #[param(inline)]
    pub rotation_order: Option<RotationOrder>,
}

impl ImportQuery {
    /// Returns the options of the import of a file of this name.
    fn import_options(self, name: Option<String>) -> ImportOptions {
        ImportOptions {
            name,
            units: self.units,
            encoding: self.encoding,
            size: self.size,
            outlines: self.outlines.unwrap_or_default(),
            notches: self.notches.unwrap_or_default(),
            darts: self.darts.unwrap_or_default(),
            unfold: self.unfold.unwrap_or_default(),
            strict: self.strict,
            grading: None,
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
    /// Time at which it was stored.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// The dialect of its file.
    pub format: PatternFormat,
    /// Number of its panels.
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

/// A form with a pattern file.
#[derive(ToSchema)]
#[expect(dead_code, reason = "only its description is used")]
pub(super) struct PatternForm {
    /// The DXF or the `GarmentCode` specification.
    #[schema(value_type = String, format = Binary)]
    file: Vec<u8>,
    /// A grade rule table (`.rul`) beside the DXF: `size` may then be any of its sizes.
    #[schema(value_type = Option<String>, format = Binary)]
    grading: Option<Vec<u8>>,
}

/// Read a DXF file or a `GarmentCode` specification and keep its pattern
#[utoipa::path(post, path = "/v1/patterns", tag = "patterns", params(ImportQuery),
    request_body(description = "The bytes of a DXF file, a GarmentCode specification, or a form with one of them as the part `file`, and a grade rule table as `grading`", content(
        (Vec<u8> = "image/vnd.dxf"), (serde_json::Value = "application/json"), (PatternForm = "multipart/form-data"))),
    responses(
        (status = 201, description = "It was read and kept", body = Pattern, headers(("Location", description = "The pattern"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Everything that keeps it from being read", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn create(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<ImportQuery>,
    upload: PatternUpload,
) -> Result<impl IntoResponse, Problem> {
    let PatternUpload { file, grading } = upload;
    let stored = state
        .run_compute(move |app| {
            let table = grading.map(|part| GradeTable::read(&part.bytes, app.limits()));
            let options = ImportOptions {
                grading: table.transpose()?,
                ..query.import_options(file.name)
            };
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
#[utoipa::path(get, path = "/v1/patterns", tag = "patterns", params(ListQuery), responses(
    (status = 200, description = "A part of the list", body = PatternList)))]
pub(super) async fn list(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<ListQuery>,
) -> Result<Json<PatternList>, Problem> {
    let page = query.page()?;
    let page = state
        .run_blocking(move |app| app.catalogue().patterns(&page))
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
pub(super) async fn show(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Json<Pattern>, Problem> {
    Ok(Json(find(&state, id).await?))
}

/// Finds the pattern with this id.
pub(super) async fn find(state: &AppState, id: Uuid) -> Result<Pattern, Problem> {
    let found = state
        .run_blocking(move |app| app.catalogue().find_pattern(id))
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
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let pattern = find(&state, id).await?;
    let make = move |_: &App| Ok(drawing_svg(&pattern));
    respond_computed(&state, &headers, "image/svg+xml", make).await
}

/// Remove a pattern; fits keep their own copy
#[utoipa::path(delete, path = "/v1/patterns/{id}", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 204, description = "It is gone"),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn remove(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<StatusCode, Problem> {
    let removed = state
        .run_blocking(move |app| app.catalogue().remove(DocumentKind::Pattern, id))
        .await??;
    removed
        .then_some(StatusCode::NO_CONTENT)
        .ok_or_else(|| unknown(id))
}

fn unknown(id: Uuid) -> Problem {
    Problem::unknown_id("pattern", id)
}
