//! `/v1/avatars`: bodies to drape on.

use crate::export;
use crate::fault::{AvatarCode, Warning};
use crate::http::extract::{
    AvatarUpload, BodyQuery, BodyUpload, ListQuery, PathId, ValidatedQuery,
};
use crate::http::respond::{Problem, respond_computed};
use crate::http::state::{App, AppState};
use crate::job::{AvatarRecord, AvatarRequest, BodyFile, Stored};
use crate::scene::{Avatar, BodySource, DressForm, import_body};
use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use utoipa::ToSchema;
use uuid::Uuid;

/// A stored avatar.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct AvatarItem {
    /// Its id.
    pub id: Uuid,
    /// Name for a person.
    pub name: Option<String>,
    /// Time at which it was stored.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// The measurements it was made from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<DressForm>,
    /// The file that it was read from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<BodyFile>,
    /// Named points of the body \[m\]; not in lists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub landmarks: Option<BTreeMap<String, [f64; 3]>>,
    /// Girths taken on a body from a file \[m\], named as the measurements of a form; not in lists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub girths: Option<BTreeMap<String, f64>>,
}

impl AvatarItem {
    fn from_record(stored: Stored<AvatarRecord>) -> Self {
        Self {
            id: stored.id,
            name: stored.value.name,
            created_at: stored.created_at,
            form: stored.value.form,
            file: stored.value.file,
            landmarks: None,
            girths: None,
        }
    }

    fn with_landmarks(mut self, avatar: &Avatar) -> Self {
        let points = avatar.landmarks.iter();
        let points = points.map(|(name, at)| (name.clone(), [at.x, at.y, at.z]));
        self.landmarks = Some(points.collect());
        self.girths = self.file.is_some().then(|| avatar.girths());
        self
    }
}

/// Avatars, newest first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct AvatarList {
    /// The avatars.
    pub avatars: Vec<AvatarItem>,
    /// `cursor` of the next page, if there is one.
    pub next_cursor: Option<Uuid>,
}

/// A form with the file of a body.
#[derive(ToSchema)]
#[expect(dead_code, reason = "only its description is used")]
pub(super) struct BodyFileForm {
    /// The OBJ, GLB or PLY.
    #[schema(value_type = String, format = Binary)]
    file: Vec<u8>,
    /// Landmarks by name, in the coordinates of the file; those that are not given are found.
    landmarks: Option<BTreeMap<String, [f64; 3]>>,
}

/// Make a dress form from measurements, or read the file of a body, and keep it
#[utoipa::path(post, path = "/v1/avatars", tag = "avatars", params(BodyQuery),
    request_body(description = "Measurements, or the bytes of an OBJ, a binary glTF 2.0 or a PLY, alone or as the part `file` of a form with the part `landmarks`", content(
        (AvatarRequest = "application/json"), (Vec<u8> = "model/obj"), (Vec<u8> = "model/gltf-binary"), (Vec<u8> = "model/ply"), (BodyFileForm = "multipart/form-data"))),
    responses(
        (status = 201, description = "It is kept", body = AvatarItem, headers(("Location", description = "The avatar"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 415, description = "Of a type that is not read", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Every measurement that no person has, or what keeps the file from being a body", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn create(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<BodyQuery>,
    upload: AvatarUpload,
) -> Result<impl IntoResponse, Problem> {
    let item = state.run_compute(move |app| match upload {
        AvatarUpload::Form(form) => keep_form(app, form),
        AvatarUpload::Body(body) => keep_body(app, body, query),
    });
    let item = item.await??;
    let location = format!("/v1/avatars/{}", item.id);
    Ok((
        StatusCode::CREATED,
        [(header::LOCATION, location)],
        Json(item),
    ))
}

fn keep_form(app: &App, form: AvatarRequest) -> Result<AvatarItem, Problem> {
    let avatar = app.catalogue().bodies().build(&BodySource::Form(form.form));
    let avatar = avatar.map_err(|faults| faults.under("/form"))?;
    let stored = app.catalogue().add_form(form)?;
    Ok(AvatarItem::from_record(stored).with_landmarks(&avatar))
}

fn keep_body(app: &App, upload: BodyUpload, query: BodyQuery) -> Result<AvatarItem, Problem> {
    let options = query.options(upload.landmarks);
    let mut import = import_body(&upload.file.bytes, &options, app.limits())?;
    let source = BodySource::Own(Arc::new(import.body.clone()));
    let avatar = app.catalogue().bodies().build(&source)?;
    if avatar.crosses_itself() {
        let detail = "the surface crosses itself; cloth is kept off its outside, and walls inside do not count";
        import
            .warnings
            .push(Warning::new(AvatarCode::Crossing, "", detail));
    }
    let stored = app.catalogue().add_body(upload.file.name, &import)?;
    Ok(AvatarItem::from_record(stored).with_landmarks(&avatar))
}

/// The avatars that are kept, newest first
#[utoipa::path(get, path = "/v1/avatars", tag = "avatars", params(ListQuery), responses(
    (status = 200, description = "A part of the list", body = AvatarList)))]
pub(super) async fn list(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<ListQuery>,
) -> Result<Json<AvatarList>, Problem> {
    let page = query.page()?;
    let page = state
        .run_blocking(move |app| app.catalogue().avatars(&page))
        .await??;
    Ok(Json(AvatarList {
        avatars: page
            .items
            .into_iter()
            .map(AvatarItem::from_record)
            .collect(),
        next_cursor: page.next,
    }))
}

/// One avatar
#[utoipa::path(get, path = "/v1/avatars/{id}", tag = "avatars", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The avatar", body = AvatarItem),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn show(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Json<AvatarItem>, Problem> {
    let (stored, avatar) = find_and_build(&state, id).await?;
    Ok(Json(
        AvatarItem::from_record(stored).with_landmarks(&avatar),
    ))
}

/// Remove an avatar; fits keep their own copy
#[utoipa::path(delete, path = "/v1/avatars/{id}", tag = "avatars", params(("id" = Uuid, Path)), responses(
    (status = 204, description = "It is gone"),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn remove(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<StatusCode, Problem> {
    let removed = state
        .run_blocking(move |app| app.catalogue().remove_avatar(id))
        .await??;
    removed
        .then_some(StatusCode::NO_CONTENT)
        .ok_or_else(|| unknown(id))
}

/// The body as binary glTF 2.0
#[utoipa::path(get, path = "/v1/avatars/{id}/mesh", tag = "avatars", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The mesh", content_type = "model/gltf-binary", body = Vec<u8>),
    (status = 404, description = "There is no such avatar", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn mesh(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (_, avatar) = find_and_build(&state, id).await?;
    let make = move |_: &App| Ok(export::avatar_glb(&avatar.surface));
    respond_computed(&state, &headers, "model/gltf-binary", make).await
}

/// Finds a stored avatar and makes its body.
async fn find_and_build(
    state: &AppState,
    id: Uuid,
) -> Result<(Stored<AvatarRecord>, Arc<Avatar>), Problem> {
    let found = state
        .run_blocking(move |app| app.catalogue().find_avatar(id))
        .await??;
    let stored = found.ok_or_else(|| unknown(id))?;
    let record = stored.value.clone();
    let avatar = state.run_compute(move |app| {
        let source = app.catalogue().source(&record)?;
        let avatar = app.catalogue().bodies().build(&source);
        avatar.map_err(Problem::internal)
    });
    Ok((stored, avatar.await??))
}

fn unknown(id: Uuid) -> Problem {
    Problem::unknown_id("avatar", id)
}
