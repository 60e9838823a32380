//! What fits and studies have in common: how they are submitted, waited for, found and answered.

use super::prefer;
use super::problem::Problem;
use super::state::{App, Shared};
use crate::job::{IdempotencyKey, JobKind, JobRecord, ResultFile, Work};
use axum::Json;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use std::time::Duration;
use uuid::Uuid;

/// What a client asks for, and what its headers say beside it.
pub(super) struct Submission {
    kind: JobKind,
    key: Option<IdempotencyKey>,
    /// How long it prefers to wait for the end.
    pub(super) wait: Option<Duration>,
}

impl Submission {
    /// A submission of what has this digest.
    pub(super) fn of(
        app: &App,
        kind: JobKind,
        headers: &HeaderMap,
        digest: [u8; 32],
    ) -> Result<Self, Problem> {
        Ok(Self {
            kind,
            key: prefer::idempotency_key(headers, digest)?,
            wait: prefer::wait(headers, app.limits().wait_s),
        })
    }

    /// The job that it is from now on: the one of before where the request is repeated, else `work`, checked, on the queue. Where
    /// the client prefers to wait, as it is then.
    pub(super) async fn submit(
        &self,
        app: &App,
        work: impl FnOnce(&Shared) -> Result<Work, Problem> + Send + 'static,
    ) -> Result<JobRecord, Problem> {
        let (kind, key) = (self.kind, self.key.clone());
        let submit = move |app: &Shared| {
            if let Some(key) = &key
                && let Some(same) = app.queue.submitted(kind, key)?
            {
                return Ok::<_, Problem>(same);
            }
            Ok(app.queue.submit(&work(app)?, key.as_ref())?)
        };
        let record = app.heavy(submit).await??;
        match self.wait {
            Some(wait) if !record.status.is_final() => settled(app, record, wait).await,
            _ => Ok(record),
        }
    }
}

/// The job once it has ended, or as it is after `wait`. Where too many wait already, as it is now: to wait is only preferred.
async fn settled(app: &App, record: JobRecord, wait: Duration) -> Result<JobRecord, Problem> {
    let (kind, id) = (record.kind, record.id);
    let Some(_place) = app.follower() else {
        return Ok(record);
    };
    let events = app
        .blocking(move |app| app.queue.events(kind, id, None))
        .await??;
    if let Some(mut events) = events {
        let end = async { while events.next().await.is_some_and(|event| !event.is_last()) {} };
        // Either way the record says what has become of it.
        let _ = tokio::time::timeout(wait, end).await;
    }
    app.blocking(move |app| found(app, kind, id)).await?
}

/// The job of this kind.
pub(super) fn found(app: &Shared, kind: JobKind, id: Uuid) -> Result<JobRecord, Problem> {
    app.queue.job(kind, id)?.ok_or_else(|| unknown(kind, id))
}

/// The job of this kind, asked to stop.
pub(super) fn canceled(app: &Shared, kind: JobKind, id: Uuid) -> Result<JobRecord, Problem> {
    app.queue.cancel(kind, id)?.ok_or_else(|| unknown(kind, id))
}

/// 200 with a job that has ended, 202 with one that has not; `body` is the job as clients see it.
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
    let location = path(record.kind, record.id);
    let mut response = (status, [(header::LOCATION, location)], Json(body)).into_response();
    if let Some(wait) = wait {
        response
            .headers_mut()
            .insert("Preference-Applied", prefer::applied(wait));
    }
    response
}

/// Where a job is.
pub(super) fn path(kind: JobKind, id: Uuid) -> String {
    match kind {
        JobKind::Fit => format!("/v1/fits/{id}"),
        JobKind::Study => format!("/v1/studies/{id}"),
    }
}

/// There is no such job.
pub(super) fn unknown(kind: JobKind, id: Uuid) -> Problem {
    Problem::not_found(format!("There is no {} {id}.", kind.as_str()))
}

/// A file that a job left.
pub(super) fn file(
    app: &Shared,
    kind: JobKind,
    id: Uuid,
    file: ResultFile,
) -> Result<Vec<u8>, Problem> {
    let record = found(app, kind, id)?;
    let (word, status) = (kind.as_str(), record.status.as_str());
    match app.queue.file(&record, file)? {
        Some(bytes) => Ok(bytes),
        None if record.status.is_final() => Err(Problem::not_found(format!(
            "The {word} {id} {status} and left no result."
        ))),
        None => Err(Problem::conflict(format!(
            "The {word} {id} is {status}; its events tell when it has ended."
        ))),
    }
}

/// What a job was asked as, complete in itself.
pub(super) fn asked(app: &Shared, kind: JobKind, id: Uuid) -> Result<Vec<u8>, Problem> {
    app.queue.asked(kind, id)?.ok_or_else(|| unknown(kind, id))
}
