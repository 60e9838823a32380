//! `/v1/studies`: error against run time of a garment; studies started, found, listed, canceled and
//! drawn.

use super::jobs::{self, Submission};
use crate::http::extract::{JobListQuery, JsonWithDigest, PathId, ValidatedQuery};
use crate::http::respond::{Problem, respond_computed, respond_stored};
use crate::http::state::{App, AppState};
use crate::job::{JobKind, JobRecord, JobRequest, JobStatus, ResultFile, StoreError};
use crate::progress::Progress;
use crate::study::{self, Study, StudyRequest};
use axum::Json;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use jiff::Timestamp;
use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use uuid::Uuid;

/// One study, and its result.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub(super) struct StudyJob {
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
    /// Reason why it failed. One that was stopped at its limit of CPU time has its report all the
    /// same.
    pub error: Option<Problem>,
    /// Its result: null until it has ended, and left out of lists and events.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Study>)]
    pub report: Option<Value>,
    /// Links to its parts.
    pub links: StudyLinks,
}

/// Links to the parts of a study.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, ToSchema)]
pub(super) struct StudyLinks {
    /// Work against precision, drawn.
    pub plot: String,
    /// Its events, as they happen.
    pub events: String,
    /// The study as requested, complete in itself.
    #[serde(rename = "asked")]
    pub request: String,
    /// `DELETE` this to stop it.
    pub cancel: String,
}

impl From<JobRecord> for StudyJob {
    fn from(record: JobRecord) -> Self {
        let own = jobs::job_path(JobKind::Study, record.id);
        Self {
            id: record.id,
            status: record.status,
            created_at: record.created_at,
            started_at: record.started_at,
            finished_at: record.finished_at,
            attempts: record.attempts,
            progress: record.progress,
            error: record.error.map(Problem::from),
            report: None,
            links: StudyLinks {
                plot: format!("{own}/plot.svg"),
                events: format!("{own}/events"),
                request: format!("{own}/asked"),
                cancel: own,
            },
        }
    }
}

impl StudyJob {
    /// Returns the study with its report, as far as there is one.
    fn with_report(app: &App, record: JobRecord) -> Result<Self, Problem> {
        let report = app.queue.file(&record, ResultFile::Report)?;
        // Passed on as it was kept, so that those that an older version made are whole too.
        let report = report.map(|json| serde_json::from_slice(&json));
        let report = report
            .transpose()
            .map_err(|cause| StoreError::of_data("reading a study", cause))?;
        Ok(Self {
            report: Some(report.unwrap_or_default()),
            ..record.into()
        })
    }
}

/// Studies, newest first, without their reports.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub(super) struct StudyList {
    /// The studies.
    pub studies: Vec<StudyJob>,
    /// `cursor` of the next page, if there is one.
    pub next_cursor: Option<Uuid>,
}

/// Study a garment: error against run time over methods, steps or tolerances, and meshes
#[utoipa::path(post, path = "/v1/studies", tag = "studies",
    params(
        ("Idempotency-Key" = Option<String>, Header, description = "The same key and request mean the same study"),
        ("Prefer" = Option<String>, Header, description = "`wait=N`: answer when it has ended, after N seconds at most")),
    request_body(content = StudyRequest),
    responses(
        (status = 200, description = "It has ended", body = StudyJob, headers(("Location", description = "The study"))),
        (status = 202, description = "It is on the queue", body = StudyJob, headers(("Location", description = "The study"))),
        (status = 413, description = "Too large", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "Everything that keeps it from being done", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "The queue is full", body = Problem, content_type = "application/problem+json", headers(("Retry-After", description = "Seconds")))))]
pub(super) async fn create(
    State(state): State<AppState>,
    headers: HeaderMap,
    request: JsonWithDigest<StudyRequest>,
) -> Result<Response, Problem> {
    let submission = Submission::new(&state, JobKind::Study, &headers, request.digest)?;
    let (study, memory) = (request.value, request.memory);
    let record = submission.submit(&state, memory, move |app| {
        let resolved = study::resolve(study, app.catalogue(), app.limits())?;
        Ok(JobRequest::Study(Box::new(resolved.request().clone())))
    });
    let jobs::Waited { record, wait } = record.await?;
    let found = record.clone();
    let whole = state.run_blocking(move |app| StudyJob::with_report(app, found));
    // It is kept: after an error the client would submit it once more.
    let whole = whole.await.flatten();
    let study = whole.unwrap_or_else(|_| StudyJob::from(record.clone()));
    Ok(jobs::respond(&record, &study, wait))
}

/// The studies, newest first
#[utoipa::path(get, path = "/v1/studies", tag = "studies", params(JobListQuery), responses(
    (status = 200, description = "A part of the list", body = StudyList)))]
pub(super) async fn list(
    State(state): State<AppState>,
    ValidatedQuery(query): ValidatedQuery<JobListQuery>,
) -> Result<Json<StudyList>, Problem> {
    let page = query.page()?;
    let page = state.run_blocking(move |app| app.queue.jobs(JobKind::Study, &page));
    let page = page.await??;
    Ok(Json(StudyList {
        studies: page.items.into_iter().map(StudyJob::from).collect(),
        next_cursor: page.next,
    }))
}

/// One study, with its report once it has ended
#[utoipa::path(get, path = "/v1/studies/{id}", tag = "studies", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The study", body = StudyJob),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn show(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Json<StudyJob>, Problem> {
    let study = state.run_blocking(move |app| {
        let record = jobs::find(app, JobKind::Study, id)?;
        StudyJob::with_report(app, record)
    });
    Ok(Json(study.await??))
}

/// Stop a study; stopping one that has ended changes nothing
#[utoipa::path(delete, path = "/v1/studies/{id}", tag = "studies", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "It has ended", body = StudyJob),
    (status = 202, description = "It will stop within a second", body = StudyJob),
    (status = 404, description = "There is none", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn cancel(
    State(state): State<AppState>,
    PathId(id): PathId,
) -> Result<Response, Problem> {
    state
        .run_blocking(move |app| {
            let record = jobs::cancel(app, JobKind::Study, id)?;
            let whole = StudyJob::with_report(app, record.clone())?;
            Ok(jobs::respond(&record, &whole, None))
        })
        .await?
}

/// Work against precision: CPU time across, solver error up, both logarithmic
#[utoipa::path(get, path = "/v1/studies/{id}/plot.svg", tag = "studies", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The picture", content_type = "image/svg+xml", body = String),
    (status = 404, description = "There is no such study, or it left no result", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The study has not ended yet", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn plot(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let make = move |app: &App| draw_plot(app, id);
    respond_computed(&state, &headers, "image/svg+xml", make).await
}

fn draw_plot(app: &App, id: Uuid) -> Result<String, Problem> {
    let json = jobs::result_file(app, JobKind::Study, id, ResultFile::Report)?;
    let report: Study = serde_json::from_slice(&json)
        .map_err(|cause| StoreError::of_data("reading a study", cause))?;
    Ok(study::plot_svg(&report))
}

/// Request of a study, complete in itself: posted again, also to an empty service, it gives the
/// same study
#[utoipa::path(get, path = "/v1/studies/{id}/asked", tag = "studies", operation_id = "asked", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The request", body = StudyRequest),
    (status = 404, description = "There is no such study", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn request(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let read = move |app: &App| jobs::request(app, JobKind::Study, id);
    respond_stored(&state, &headers, "application/json", read).await
}
