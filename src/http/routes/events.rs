//! `/v1/fits/{id}/events`, `/v1/studies/{id}/events`: the events of a job, as they happen.

use super::fits::Fit;
use super::jobs;
use super::studies::StudyJob;
use crate::http::extract::{PathId, ValidatedQuery, last_event_id};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::{JobEvent, JobEventKind, JobEvents, JobKind};
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::response::sse::{self, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, mpsc};
use tokio_stream::wrappers::ReceiverStream;
use uuid::Uuid;

/// Number of events that wait for a slow reader; the past that is kept of a job is longer.
const BUFFERED_EVENTS: usize = 16;

/// Time without an event after which a comment is sent: proxies and the patience with clients count
/// it as progress.
const ALIVE_INTERVAL: Duration = Duration::from_secs(15);

/// The query of events: it has no fields yet.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventsQuery {}

/// Events of a fit, as server-sent events
///
/// `progress` carries a `Progress`, `status` a `Fit`; the stream ends after a final status.
/// `Last-Event-ID` resumes.
#[utoipa::path(get, path = "/v1/fits/{id}/events", tag = "fits", operation_id = "events",
    params(("id" = Uuid, Path), ("Last-Event-ID" = Option<u64>, Header, description = "The last event that was read")),
    responses(
        (status = 200, description = "The events", content_type = "text/event-stream", body = String),
        (status = 204, description = "The last event was read before; there will be none"),
        (status = 404, description = "There is no such fit", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "Too many follow already", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn fit_events(
    State(state): State<AppState>,
    PathId(id): PathId,
    ValidatedQuery(EventsQuery {}): ValidatedQuery<EventsQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    follow(&state, JobKind::Fit, id, &headers).await
}

/// Events of a study, as server-sent events
///
/// `progress` carries a `Progress`, `status` a `StudyJob` without its report; the stream ends after
/// a final status. `Last-Event-ID` resumes.
#[utoipa::path(get, path = "/v1/studies/{id}/events", tag = "studies", operation_id = "events",
    params(("id" = Uuid, Path), ("Last-Event-ID" = Option<u64>, Header, description = "The last event that was read")),
    responses(
        (status = 200, description = "The events", content_type = "text/event-stream", body = String),
        (status = 204, description = "The last event was read before; there will be none"),
        (status = 404, description = "There is no such study", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "Too many follow already", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn study_events(
    State(state): State<AppState>,
    PathId(id): PathId,
    ValidatedQuery(EventsQuery {}): ValidatedQuery<EventsQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    follow(&state, JobKind::Study, id, &headers).await
}

async fn follow(
    state: &AppState,
    kind: JobKind,
    id: Uuid,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    let after = last_event_id(headers)?;
    let events = state.run_blocking(move |app| app.queue.events(kind, id, after));
    let events = events.await??.ok_or_else(|| jobs::unknown(kind, id))?;
    if events.is_over() {
        // It tells a client that resumes to do so no more.
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    let permit = state.stream_permit();
    let permit = permit.ok_or_else(Problem::too_many_streams)?;
    let (sender, receiver) = mpsc::channel(BUFFERED_EVENTS);
    tokio::spawn(send_events(events, sender, permit));
    let events = Sse::new(ReceiverStream::new(receiver));
    Ok(events
        .keep_alive(KeepAlive::new().interval(ALIVE_INTERVAL))
        .into_response())
}

/// Sends events until the last one, or until nobody listens.
async fn send_events(
    mut events: JobEvents,
    sender: mpsc::Sender<Result<sse::Event, axum::Error>>,
    _permit: OwnedSemaphorePermit,
) {
    loop {
        let event = tokio::select! {
            event = events.next() => event,
            () = sender.closed() => None,
        };
        let Some(event) = event else { return };
        if sender.send(wire_event(event)).await.is_err() {
            return;
        }
    }
}

fn wire_event(event: JobEvent) -> Result<sse::Event, axum::Error> {
    let wire = sse::Event::default().id(event.id.to_string());
    match event.kind {
        JobEventKind::Progress(progress) => wire.event("progress").json_data(progress),
        JobEventKind::Status(record) => {
            let wire = wire.event("status");
            match record.kind {
                JobKind::Fit => wire.json_data(Fit::from(*record)),
                JobKind::Study => wire.json_data(StudyJob::from(*record)),
            }
        }
    }
}
