//! `/v1/fits`: garments in; fits found, listed and canceled.

use super::fit_asked::FitAsked;
use super::jobs::{self, Submission};
use super::listing::{Asking, Id, JobsAsked};
use super::problem::Problem;
use super::state::App;
use crate::fit;
use crate::job::{JobKind, JobRecord, Status, Work};
use crate::progress::Progress;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use axum::routing::get;
use axum::{Json, Router};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;
use utoipa::ToSchema;
use uuid::Uuid;

pub(super) fn router() -> Router<App> {
    Router::new()
        .route("/v1/fits", get(list).post(create))
        .route("/v1/fits/{id}", get(show).delete(cancel))
}

/// One run: a garment sewn and draped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct Fit {
    /// Its id.
    pub id: Uuid,
    /// What has become of it.
    pub status: Status,
    /// When it was submitted.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// When the present attempt began.
    #[schema(value_type = Option<String>, format = DateTime)]
    pub started_at: Option<Timestamp>,
    /// When it came to its end.
    #[schema(value_type = Option<String>, format = DateTime)]
    pub finished_at: Option<Timestamp>,
    /// How often it was begun.
    pub attempts: u32,
    /// How far it is.
    pub progress: Progress,
    /// Why it failed. A fit that did not converge has its best mesh and report all the same.
    pub error: Option<Problem>,
    /// Where its parts are.
    pub links: Links,
}

/// Where the parts of a fit are.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(super) struct Links {
    /// Its shape.
    pub mesh: String,
    /// How far to trust it.
    pub report: String,
    /// What happens to it, as it happens.
    pub events: String,
    /// What was asked, complete in itself.
    pub garment: String,
    /// The assembled scene.
    pub scene: String,
    /// `DELETE` this to stop it.
    pub cancel: String,
}

impl From<JobRecord> for Fit {
    fn from(record: JobRecord) -> Self {
        let own = jobs::path(JobKind::Fit, record.id);
        Self {
            id: record.id,
            status: record.status,
            created_at: record.created_at,
            started_at: record.started_at,
            finished_at: record.finished_at,
            attempts: record.attempts,
            progress: record.progress,
            error: record.error.map(Problem::from),
            links: Links {
                mesh: format!("{own}/mesh"),
                report: format!("{own}/report"),
                events: format!("{own}/events"),
                garment: format!("{own}/garment"),
                scene: format!("{own}/scene"),
                cancel: own,
            },
        }
    }
}

/// Fits, newest first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct FitList {
    /// The fits.
    pub fits: Vec<Fit>,
    /// `cursor` of the next page, if there is one.
    pub next_cursor: Option<Uuid>,
}

/// Sew and drape a garment
#[utoipa::path(post, path = "/v1/fits", tag = "fits",
    params(
        ("Idempotency-Key" = Option<String>, Header, description = "The same key and request mean the same fit"),
        ("Prefer" = Option<String>, Header, description = "`wait=N`: answer when it has ended, after N seconds at most")),
    request_body(description = "A garment, or a form of a DXF and a garment without `pattern`", content(
        (fit::Garment = "application/json"), (super::openapi::FitForm = "multipart/form-data"))),
    responses(
        (status = 200, description = "It has ended", body = Fit, headers(("Location", description = "The fit"))),
        (status = 202, description = "It is on the queue", body = Fit, headers(("Location", description = "The fit"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Everything that keeps it from being sewn", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "The queue is full", body = Problem, content_type = "application/problem+json", headers(("Retry-After", description = "Seconds")))))]
pub(super) async fn create(
    State(app): State<App>,
    headers: HeaderMap,
    asked: FitAsked,
) -> Result<Response, Problem> {
    let submission = Submission::of(&app, JobKind::Fit, &headers, asked.digest)?;
    let record = submission.submit(&app, move |app| {
        let prepared = fit::prepare(asked.garment, app.catalogue(), app.limits())?;
        Ok(Work::Fit(Box::new(prepared.garment().clone())))
    });
    Ok(respond(record.await?, submission.wait))
}

fn respond(record: JobRecord, wait: Option<Duration>) -> Response {
    jobs::respond(&record.clone(), &Fit::from(record), wait)
}

/// The fits, newest first
#[utoipa::path(get, path = "/v1/fits", tag = "fits", params(JobsAsked), responses(
    (status = 200, description = "A part of the list", body = FitList)))]
pub(super) async fn list(
    State(app): State<App>,
    Asking(asked): Asking<JobsAsked>,
) -> Result<Json<FitList>, Problem> {
    let page = asked.page()?;
    let page = app
        .blocking(move |app| app.queue.jobs(JobKind::Fit, &page))
        .await??;
    Ok(Json(FitList {
        fits: page.items.into_iter().map(Fit::from).collect(),
        next_cursor: page.next,
    }))
}

/// One fit
#[utoipa::path(get, path = "/v1/fits/{id}", tag = "fits", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The fit", body = Fit),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn show(State(app): State<App>, Id(id): Id) -> Result<Json<Fit>, Problem> {
    let record = app.blocking(move |app| jobs::found(app, JobKind::Fit, id));
    Ok(Json(record.await??.into()))
}

/// Stop a fit; stopping one that has ended changes nothing
#[utoipa::path(delete, path = "/v1/fits/{id}", tag = "fits", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "It has ended", body = Fit),
    (status = 202, description = "It will stop within a second", body = Fit),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn cancel(State(app): State<App>, Id(id): Id) -> Result<Response, Problem> {
    let record = app.blocking(move |app| jobs::canceled(app, JobKind::Fit, id));
    Ok(respond(record.await??, None))
}
