//! `/v1/fits`: garments in; fits found, listed and canceled.

use super::jobs::{self, Submission};
use crate::fit;
use crate::http::extract::{FitRequest, JobListQuery, PathId, ValidatedQuery};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::{JobKind, JobRecord, JobRequest, JobStatus};
use crate::progress::Progress;
use axum::Json;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use jiff::Timestamp;
use serde::{Deserialize, Serialize};
use std::time::Duration;
use utoipa::ToSchema;
use uuid::Uuid;

/// One run: a garment sewn and draped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub(super) struct Fit {
    /// Its id.
    pub id: Uuid,
    /// Its status.
    pub status: JobStatus,
    /// Time of its submission.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: Timestamp,
    /// Begin of the present attempt.
    #[schema(value_type = Option<String>, format = DateTime)]
    pub started_at: Option<Timestamp>,
    /// Time of its end.
    #[schema(value_type = Option<String>, format = DateTime)]
    pub finished_at: Option<Timestamp>,
    /// Number of attempts begun.
    pub attempts: u32,
    /// Its progress.
    pub progress: Progress,
    /// Reason why it failed. A fit that did not converge or is not good has its mesh and
    /// report all the same.
    pub error: Option<Problem>,
    /// Links to its parts.
    pub links: FitLinks,
}

/// Links to the parts of a fit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[schema(as = Links)]
pub(super) struct FitLinks {
    /// Its shape.
    pub mesh: String,
    /// Its report: how far to trust the shape.
    pub report: String,
    /// Its events, as they happen.
    pub events: String,
    /// The garment as requested, complete in itself.
    pub garment: String,
    /// The assembled scene.
    pub scene: String,
    /// `DELETE` this to stop it.
    pub cancel: String,
}

impl From<JobRecord> for Fit {
    fn from(record: JobRecord) -> Self {
        let own = jobs::job_path(JobKind::Fit, record.id);
        Self {
            id: record.id,
            status: record.status,
            created_at: record.created_at,
            started_at: record.started_at,
            finished_at: record.finished_at,
            attempts: record.attempts,
            progress: record.progress,
            error: record.error.map(Problem::from),
            links: FitLinks {
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

/// A form with a pattern file and a garment.
#[derive(ToSchema)]
#[expect(dead_code, reason = "only its description is used")]
pub(super) struct FitForm {
    /// The DXF.
    #[schema(value_type = String, format = Binary)]
    pattern: Vec<u8>,
    /// The garment, without `pattern`.
    garment: fit::Garment,
}

/// Sew and drape a garment
#[utoipa::path(post, path = "/v1/fits", tag = "fits",
    params(
        ("Idempotency-Key" = Option<String>, Header, description = "The same key and request mean the same fit"),
        ("Prefer" = Option<String>, Header, description = "`wait=N`: answer when it has ended, after N seconds at most")),
    request_body(description = "A garment, or a form of a DXF and a garment without `pattern`", content(
        (fit::Garment = "application/json"), (FitForm = "multipart/form-data"))),
    responses(
        (status = 200, description = "It has ended", body = Fit, headers(("Location", description = "The fit"))),
        (status = 202, description = "It is on the queue", body = Fit, headers(("Location", description = "The fit"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Everything that keeps it from being sewn", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "The queue is full", body = Problem, content_type = "application/problem+json", headers(("Retry-After", description = "Seconds")))))]
pub(super) async fn create(
    State(state): State<AppState>,
    headers: HeaderMap,
    request: FitRequest,
) -> Result<Response, Problem> {
    let submission = Submission::new(&state, JobKind::Fit, &headers, request.digest)?;
    let (garment, memory) = (request.garment, request.memory);
    let record = submission.submit(&state, memory, move |app| {
        let resolved = fit::resolve(garment, &*app.queue, app.limits())?;
        Ok(JobRequest::Fit(Box::new(resolved.garment().clone())))
    });
    let submitted = record.await?;
    Ok(respond(submitted.record, submitted.wait))
}

fn respond(record: JobRecord, wait: Option<Duration>) -> Response {
    jobs::respond(&record.clone(), &Fit::from(record), wait)
}

/// The fits, newest first
#[utoipa::path(get, path = "/v1/fits", tag = "fits", params(JobListQuery), responses(
    (status = 200, description = "A part of the list", body = FitList)))]
pub(super) async fn list(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<JobListQuery>,
) -> Result<Json<FitList>, Problem> {
    let page = query.page()?;
    let page = state
        .run_blocking(move |app| app.queue.jobs(JobKind::Fit, &page))
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
pub(super) async fn show(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Json<Fit>, Problem> {
    let record = state.run_blocking(move |app| jobs::find(app, JobKind::Fit, id));
    Ok(Json(record.await??.into()))
}

/// Stop a fit; stopping one that has ended changes nothing
#[utoipa::path(delete, path = "/v1/fits/{id}", tag = "fits", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "It has ended", body = Fit),
    (status = 202, description = "It will stop within a second", body = Fit),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn cancel(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Response, Problem> {
    let record = state.run_blocking(move |app| jobs::cancel(app, JobKind::Fit, id));
    Ok(respond(record.await??, None))
}
