//! `/v1/fits/{id}/events`, `/v1/studies/{id}/events`: what happens to a job, as it happens.

use super::fits::Fit;
use super::jobs;
use super::listing::{Asking, Id};
use super::problem::Problem;
use super::state::App;
use super::studies::StudyJob;
use crate::fault::Fault;
use crate::job::{Event, EventKind, Events, JobKind};
use axum::Router;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::IntoResponse;
use axum::response::sse::{self, KeepAlive, Sse};
use axum::routing::get;
use serde::Deserialize;
use tokio::sync::{OwnedSemaphorePermit, mpsc};
use tokio_stream::wrappers::ReceiverStream;
use uuid::Uuid;

/// Events that wait for a slow reader; the job's own past is longer.
const AHEAD: usize = 16;

pub(super) fn router() -> Router<App> {
    Router::new()
        .route("/v1/fits/{id}/events", get(fit_events))
        .route("/v1/studies/{id}/events", get(study_events))
}

/// Nothing can be asked of it yet.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventsAsked {}

/// What happens to a fit, as server-sent events
///
/// `progress` carries a `Progress`, `status` a `Fit`; the stream ends after a final status. `Last-Event-ID` resumes.
#[utoipa::path(get, path = "/v1/fits/{id}/events", tag = "fits", operation_id = "events",
    params(("id" = Uuid, Path), ("Last-Event-ID" = Option<u64>, Header, description = "The last event that was read")),
    responses(
        (status = 200, description = "The events", content_type = "text/event-stream", body = String),
        (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "Too many follow already", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn fit_events(
    State(app): State<App>,
    Id(id): Id,
    Asking(EventsAsked {}): Asking<EventsAsked>,
    headers: HeaderMap,
) -> Result<impl IntoResponse, Problem> {
    follow(&app, JobKind::Fit, id, &headers).await
}

/// What happens to a study, as server-sent events
///
/// `progress` carries a `Progress`, `status` a `StudyJob` without its report; the stream ends after a final status.
/// `Last-Event-ID` resumes.
#[utoipa::path(get, path = "/v1/studies/{id}/events", tag = "studies", operation_id = "events",
    params(("id" = Uuid, Path), ("Last-Event-ID" = Option<u64>, Header, description = "The last event that was read")),
    responses(
        (status = 200, description = "The events", content_type = "text/event-stream", body = String),
        (status = 404, description = "There is no such study", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "Too many follow already", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn study_events(
    State(app): State<App>,
    Id(id): Id,
    Asking(EventsAsked {}): Asking<EventsAsked>,
    headers: HeaderMap,
) -> Result<impl IntoResponse, Problem> {
    follow(&app, JobKind::Study, id, &headers).await
}

async fn follow(
    app: &App,
    kind: JobKind,
    id: Uuid,
    headers: &HeaderMap,
) -> Result<impl IntoResponse + use<>, Problem> {
    let after = last_event_id(headers)?;
    let events = app.blocking(move |app| app.queue.events(kind, id, after));
    let events = events.await??.ok_or_else(|| jobs::unknown(kind, id))?;
    let full = || Problem::unavailable("Too many clients follow fits and studies already.", 5);
    let place = app.follower().ok_or_else(full)?;
    let (sender, receiver) = mpsc::channel(AHEAD);
    tokio::spawn(pass_on(events, sender, place));
    Ok(Sse::new(ReceiverStream::new(receiver)).keep_alive(KeepAlive::default()))
}

/// Sends events until the last one, or until nobody listens.
async fn pass_on(
    mut events: Events,
    sender: mpsc::Sender<Result<sse::Event, axum::Error>>,
    _place: OwnedSemaphorePermit,
) {
    loop {
        let event = tokio::select! {
            event = events.next() => event,
            () = sender.closed() => None,
        };
        let Some(event) = event else { return };
        if sender.send(written(event)).await.is_err() {
            return;
        }
    }
}

fn written(event: Event) -> Result<sse::Event, axum::Error> {
    let wire = sse::Event::default().id(event.id.to_string());
    match event.kind {
        EventKind::Progress(progress) => wire.event("progress").json_data(progress),
        EventKind::Status(record) => {
            let wire = wire.event("status");
            match record.kind {
                JobKind::Fit => wire.json_data(Fit::from(*record)),
                JobKind::Study => wire.json_data(StudyJob::from(*record)),
            }
        }
    }
}

fn last_event_id(headers: &HeaderMap) -> Result<Option<u64>, Fault> {
    let Some(value) = headers.get("Last-Event-ID") else {
        return Ok(None);
    };
    let id = value.to_str().ok().and_then(|id| id.trim().parse().ok());
    let wrong = || {
        Fault::new(
            "request/event_id",
            "/Last-Event-ID",
            "event ids are whole numbers",
        )
    };
    id.map(Some).ok_or_else(wrong)
}
