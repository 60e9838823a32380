//! Fits and studies alike: submitted, waited for, found, canceled and answered.

use crate::http::extract::{JsonMemory, idempotency_key, preference_applied, preferred_wait};
use crate::http::respond::Problem;
use crate::http::state::{App, AppState};
use crate::job::{IdempotencyKey, JobKind, JobRecord, JobRequest, ResultFile};
use axum::Json;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use std::time::Duration;
use uuid::Uuid;

/// The submission of a job: its kind, and what the headers of the request ask for.
pub(super) struct Submission {
    kind: JobKind,
    key: Option<IdempotencyKey>,
    /// Time that the client prefers to wait for the end.
    wait: Option<Duration>,
}

/// A job that was submitted.
pub(super) struct Waited {
    /// Its record.
    pub(super) record: JobRecord,
    /// The wait that was granted, where the client preferred one and there was one.
    pub(super) wait: Option<Duration>,
}

impl Submission {
    /// Reads the headers of a request whose body has this digest.
    pub(super) fn new(
        state: &AppState,
        kind: JobKind,
        headers: &HeaderMap,
        digest: [u8; 32],
    ) -> Result<Self, Problem> {
        Ok(Self {
            kind,
            key: idempotency_key(headers, digest)?,
            wait: preferred_wait(headers, state.limits().wait_s),
        })
    }

    /// Puts the job on the queue, and returns its record: after the wait that the client prefers.
    ///
    /// A repeated request returns the job of the first; `prepare` checks a new one, which holds
    /// `memory` until it is kept. Once it is, nothing is an error: the client would submit it
    /// again.
    pub(super) async fn submit(
        &self,
        state: &AppState,
        memory: JsonMemory,
        prepare: impl FnOnce(&App) -> Result<JobRequest, Problem> + Send + 'static,
    ) -> Result<Waited, Problem> {
        let (kind, key) = (self.kind, self.key.clone());
        let submit = move |app: &App| {
            let _memory = memory;
            if let Some(key) = &key
                && let Some(same) = app.queue.submitted(kind, key)?
            {
                return Ok::<_, Problem>(same);
            }
            let failed_reads = app.catalogue().failed_reads();
            let request = match prepare(app) {
                // What the request refers to may be there all the same.
                Err(_) if app.catalogue().failed_reads() != failed_reads => {
                    return Err(Problem::store_unavailable());
                }
                prepared => prepared?,
            };
            Ok(app.queue.submit(&request, key.as_ref())?)
        };
        let record = state.run_compute(submit).await??;
        if let Some(wait) = self.wait.filter(|_| !record.status.is_final())
            && let Ok(Some(record)) = wait_for_end(state, &record, wait).await
        {
            let wait = Some(wait);
            return Ok(Waited { record, wait });
        }
        Ok(Waited { record, wait: None })
    }
}

/// Returns the job once it has ended, or as it is after `wait`. `None` where too many wait already:
/// the wait is a preference only.
async fn wait_for_end(
    state: &AppState,
    record: &JobRecord,
    wait: Duration,
) -> Result<Option<JobRecord>, Problem> {
    let (kind, id) = (record.kind, record.id);
    let Some(_permit) = state.stream_permit() else {
        return Ok(None);
    };
    let events = state
        .run_blocking(move |app| app.queue.events(kind, id, None))
        .await??;
    if let Some(mut events) = events {
        let end = async { while events.next().await.is_some_and(|event| !event.is_last()) {} };
        // Either way the record says what has become of it.
        let _ = tokio::time::timeout(wait, end).await;
    }
    let record = state.run_blocking(move |app| find(app, kind, id)).await??;
    Ok(Some(record))
}

/// Finds the job of this kind.
pub(super) fn find(app: &App, kind: JobKind, id: Uuid) -> Result<JobRecord, Problem> {
    app.queue.job(kind, id)?.ok_or_else(|| unknown(kind, id))
}

/// Asks the job of this kind to stop, and returns its record after that.
pub(super) fn cancel(app: &App, kind: JobKind, id: Uuid) -> Result<JobRecord, Problem> {
    app.queue.cancel(kind, id)?.ok_or_else(|| unknown(kind, id))
}

/// Answers 200 with a job that has ended, 202 with one that has not; `body` is the job as clients
/// see it.
pub(super) fn respond(
    record: &JobRecord,
    body: &impl Serialize,
    wait: Option<Duration>,
) -> Response {
    let status = if record.status.is_final() {
        StatusCode::OK
    } else {
        StatusCode::ACCEPTED
    };
    let location = job_path(record.kind, record.id);
    let mut response = (status, [(header::LOCATION, location)], Json(body)).into_response();
    if let Some(wait) = wait {
        response
            .headers_mut()
            .insert("Preference-Applied", preference_applied(wait));
    }
    response
}

/// Returns the path of a job.
pub(super) fn job_path(kind: JobKind, id: Uuid) -> String {
    match kind {
        JobKind::Fit => format!("/v1/fits/{id}"),
        JobKind::Study => format!("/v1/studies/{id}"),
    }
}

/// Returns the problem of an id that no job of this kind has.
pub(super) fn unknown(kind: JobKind, id: Uuid) -> Problem {
    Problem::unknown_id(kind.as_str(), id)
}

/// Returns a file that a job left.
pub(super) fn result_file(
    app: &App,
    kind: JobKind,
    id: Uuid,
    file: ResultFile,
) -> Result<Vec<u8>, Problem> {
    let record = find(app, kind, id)?;
    match app.queue.file(&record, file)? {
        Some(bytes) => Ok(bytes),
        None if record.status.is_final() => Err(Problem::no_result(&record)),
        None => Err(Problem::not_ended(&record)),
    }
}

/// Returns the request of a job, complete in itself.
pub(super) fn request(app: &App, kind: JobKind, id: Uuid) -> Result<Vec<u8>, Problem> {
    app.queue
        .request(kind, id)?
        .ok_or_else(|| unknown(kind, id))
}
