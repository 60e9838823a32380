//! Problems as RFC 9457 `application/problem+json`: each kind with its status, title and sentence.

use crate::fault::{Fault, Faults, RequestCode};
use crate::job::JobRecord;
use crate::json::MOST_LISTED;
use axum::Json;
use axum::http::{HeaderName, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use std::fmt::Display;
use utoipa::ToSchema;

/// Time after which to try again while the queue is full: about that of one fit \[s\].
const RETRY_FULL_S: u64 = 10;
/// Time after which to try again while too many requests are worked on \[s\].
const RETRY_OVERLOADED_S: u64 = 1;
/// Time after which to try again while the store fails or too many clients follow jobs \[s\].
const RETRY_LATER_S: u64 = 5;

/// The body of every answer that is not a success.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Problem {
    /// URN of the kind of problem.
    #[serde(rename = "type")]
    pub kind: String,
    /// Name of the kind.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// Sentence for a person on what happened this time.
    pub detail: String,
    /// Faults of the request, all at once; the first 100 if there are more.
    pub errors: Vec<Fault>,
    /// Number of the faults of the request; absent where counting stopped.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub errors_total: Option<u32>,
    /// Header of the answer; boxed, as it is seldom there.
    #[serde(skip)]
    header: Option<Box<(HeaderName, String)>>,
}

impl Problem {
    /// Creates a problem without faults.
    pub(super) fn new(
        status: StatusCode,
        kind: &str,
        title: &str,
        detail: impl Into<String>,
    ) -> Self {
        Self {
            kind: format!("urn:seamster:problem:{kind}"),
            title: title.to_owned(),
            status: status.as_u16(),
            detail: detail.into(),
            errors: vec![],
            errors_total: Some(0),
            header: None,
        }
    }

    /// Adds a header to the answer.
    fn with_header(mut self, name: HeaderName, value: impl Into<String>) -> Self {
        self.header = Some(Box::new((name, value.into())));
        self
    }

    /// Adds the faults of the request.
    pub(super) fn with_faults(mut self, faults: impl Into<Faults>) -> Self {
        self.errors = faults.into().0;
        self.errors_total = u32::try_from(self.errors.len()).ok();
        self.errors.truncate(MOST_LISTED);
        self
    }

    /// Returns the problem of a request with faults.
    pub(super) fn invalid(faults: Faults) -> Self {
        let detail = match faults.0.as_slice() {
            [one] => one.detail.clone(),
            many if many.len() > MOST_LISTED => format!(
                "The request has {} faults; `errors` lists the first {MOST_LISTED}.",
                many.len()
            ),
            many => format!(
                "The request has {} faults; `errors` lists them all.",
                many.len()
            ),
        };
        Self::new(
            StatusCode::UNPROCESSABLE_ENTITY,
            "invalid",
            "Invalid request",
            detail,
        )
        .with_faults(faults)
    }

    /// Returns the problem of a request with faults whose search ended before its end.
    pub(in crate::http) fn invalid_uncounted(faults: Faults) -> Self {
        let detail = "The request has many faults; `errors` lists the first.";
        Self {
            detail: detail.to_owned(),
            errors_total: None,
            ..Self::invalid(faults)
        }
    }

    /// Returns the problem of a request that cannot be read.
    pub(in crate::http) fn unreadable(faults: impl Into<Faults>) -> Self {
        let detail = "The request could not be read; `errors` says where.";
        Self::new(
            StatusCode::BAD_REQUEST,
            "unreadable",
            "Unreadable request",
            detail,
        )
        .with_faults(faults)
    }

    /// Returns the problem of a body that breaks off, or of a form that cannot be read.
    pub(in crate::http) fn unreadable_body(reason: impl Display) -> Self {
        Self::unreadable(Fault::new(RequestCode::Body, "", reason.to_string()))
    }

    /// Returns the problem of a request that names its host twice (RFC 9112, 3.2).
    pub(in crate::http) fn two_hosts() -> Self {
        let detail = "The request has two `Host` headers.";
        Self::unreadable(Fault::new(RequestCode::Host, "", detail))
    }

    /// Returns the problem of a request without a token of this service.
    pub(in crate::http) fn unauthorized() -> Self {
        let detail = "This call needs the header `Authorization: Bearer <token>` with a token of this service.";
        Self::new(
            StatusCode::UNAUTHORIZED,
            "unauthorized",
            "Token needed",
            detail,
        )
        .with_header(header::WWW_AUTHENTICATE, "Bearer realm=\"seamster\"")
    }

    /// Returns the problem of a writing request from a page of another site.
    pub(in crate::http) fn foreign_origin(origin: &str) -> Self {
        let detail = format!(
            "Calls that write are refused from pages of other origins; this is {origin:?}."
        );
        Self::new(
            StatusCode::FORBIDDEN,
            "foreign-origin",
            "Foreign origin",
            detail,
        )
    }

    /// Returns the problem of a thing that does not exist.
    pub(super) fn not_found(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, "not-found", "Not found", detail)
    }

    /// Returns the problem of an id that no resource of this kind has.
    pub(in crate::http) fn unknown_id(kind: &str, id: impl Display) -> Self {
        Self::not_found(format!("There is no {kind} {id}."))
    }

    /// Returns the problem of a path at which there is nothing.
    pub(in crate::http) fn unknown_path(path: &str) -> Self {
        Self::not_found(format!(
            "There is no {path}. /openapi.json lists the calls, /docs shows them, the page is at /."
        ))
    }

    /// Returns the problem of a job that ended without the requested result.
    pub(in crate::http) fn no_result(job: &JobRecord) -> Self {
        let (kind, id, status) = (job.kind.as_str(), job.id, job.status.as_str());
        Self::not_found(format!("The {kind} {id} {status} and left no result."))
    }

    /// Returns the problem of a method that a path does not have.
    pub(in crate::http) fn method_not_allowed(method: &str, path: &str) -> Self {
        let detail = format!("{path} has no {method}; see /openapi.json for what there is.");
        Self::new(
            StatusCode::METHOD_NOT_ALLOWED,
            "method-not-allowed",
            "Method not allowed",
            detail,
        )
    }

    /// Returns the problem of a client that accepts none of the offered types.
    pub(in crate::http) fn not_acceptable(offered: &str) -> Self {
        let detail = format!("None of the types in `Accept` is offered; there are {offered}.");
        Self::new(
            StatusCode::NOT_ACCEPTABLE,
            "not-acceptable",
            "Not acceptable",
            detail,
        )
    }

    /// Returns the problem of a body that comes too slowly.
    pub(in crate::http) fn too_slow() -> Self {
        let detail = "The body came too slowly; send it again over a faster line.";
        Self::new(StatusCode::REQUEST_TIMEOUT, "timeout", "Timed out", detail)
            .with_header(header::CONNECTION, "close")
    }

    /// Returns the problem of a request that took too long.
    pub(in crate::http) fn timed_out() -> Self {
        let detail = "The request took longer than this service allows.";
        Self::new(StatusCode::REQUEST_TIMEOUT, "timeout", "Timed out", detail)
    }

    /// Returns the problem of a result that is requested before the job has ended.
    pub(in crate::http) fn not_ended(job: &JobRecord) -> Self {
        let (kind, id, status) = (job.kind.as_str(), job.id, job.status.as_str());
        let detail = format!("The {kind} {id} is {status}; its events tell when it has ended.");
        Self::new(StatusCode::CONFLICT, "conflict", "Conflict", detail)
    }

    /// Returns the problem of a body above its limit.
    pub(in crate::http) fn body_too_large(limit: usize) -> Self {
        Self::too_large(format!(
            "The body is larger than the {limit} bytes allowed here."
        ))
    }

    /// Returns the problem of a file above its limit.
    pub(in crate::http) fn file_too_large(limit: usize) -> Self {
        Self::too_large(format!("The file is larger than {limit} bytes."))
    }

    fn too_large(detail: impl Into<String>) -> Self {
        Self::new(
            StatusCode::PAYLOAD_TOO_LARGE,
            "too-large",
            "Too large",
            detail,
        )
    }

    /// Returns the problem of a body of a type that the call does not read.
    pub(in crate::http) fn unsupported_type(got: &str, wanted: &str) -> Self {
        let detail = format!("The body is {got:?}; this call reads {wanted}.");
        Self::new(
            StatusCode::UNSUPPORTED_MEDIA_TYPE,
            "unsupported-type",
            "Unsupported media type",
            detail,
        )
    }

    /// Returns the problem of a range outside of a representation.
    pub(in crate::http) fn range_not_satisfiable(length: usize) -> Self {
        let detail = format!("The range lies outside of the {length} bytes there are.");
        Self::new(
            StatusCode::RANGE_NOT_SATISFIABLE,
            "range",
            "Range not satisfiable",
            detail,
        )
        .with_header(header::CONTENT_RANGE, format!("bytes */{length}"))
    }

    /// Returns the problem of a host name that is not of this service.
    pub(in crate::http) fn misdirected(host: &str) -> Self {
        let detail = format!("This service does not answer for the host {host:?}.");
        Self::new(
            StatusCode::MISDIRECTED_REQUEST,
            "misdirected",
            "Misdirected request",
            detail,
        )
    }

    /// Returns the problem of a service that has as many requests as it can work on.
    pub(in crate::http) fn overloaded() -> Self {
        let detail = "The service has as many requests as it can work on.";
        Self::unavailable(detail, RETRY_OVERLOADED_S)
    }

    /// Returns the problem of a service that holds as many bytes of bodies and answers as it may.
    pub(in crate::http) fn too_many_bytes() -> Self {
        let detail = "The service sends and receives as much at once as it may.";
        Self::unavailable(detail, RETRY_LATER_S)
    }

    /// Returns the problem of a service that has as many followers of jobs as it can serve.
    pub(in crate::http) fn too_many_streams() -> Self {
        let detail = "Too many clients follow fits and studies already.";
        Self::unavailable(detail, RETRY_LATER_S)
    }

    /// Returns the problem of a service whose store does not answer.
    pub(in crate::http) fn store_unavailable() -> Self {
        Self::unavailable("The store does not answer.", RETRY_LATER_S)
    }

    /// Returns the problem of a full queue.
    pub(super) fn queue_full(detail: String) -> Self {
        Self::unavailable(detail, RETRY_FULL_S)
    }

    fn unavailable(detail: impl Into<String>, retry_after_s: u64) -> Self {
        Self::new(
            StatusCode::SERVICE_UNAVAILABLE,
            "unavailable",
            "Not now",
            detail,
        )
        .with_header(header::RETRY_AFTER, retry_after_s.to_string())
    }

    /// Returns the problem of a failure of the service; `cause` goes to the log only.
    pub(in crate::http) fn internal(cause: impl Display) -> Self {
        tracing::error!(%cause, "internal error");
        let detail = "The service failed; its log says why, under this answer's X-Request-Id.";
        Self::new(
            StatusCode::INTERNAL_SERVER_ERROR,
            "internal",
            "Internal error",
            detail,
        )
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let status = StatusCode::from_u16(self.status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        let header = self.header.clone();
        let mut response = (status, Json(self)).into_response();
        let map = response.headers_mut();
        map.insert(
            header::CONTENT_TYPE,
            HeaderValue::from_static("application/problem+json"),
        );
        map.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
        if let Some((name, value)) = header.map(|header| *header)
            && let Ok(value) = HeaderValue::from_str(&value)
        {
            map.insert(name, value);
        }
        response
    }
}
