//! What goes wrong, as RFC 9457 `application/problem+json`. The only place that knows status codes.

use crate::fault::{Fault, Faults};
use crate::job::{Failure, QueueError, StoreError};
use axum::Json;
use axum::http::{HeaderName, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// When to try again while the queue is full: about the time of one fit \[s\].
const RETRY_FULL_S: u64 = 10;

/// The body of every answer that is not a success.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Problem {
    /// What kind of problem: a URN.
    #[serde(rename = "type")]
    pub kind: String,
    /// The kind in words.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// What happened this time, in a sentence for a person.
    pub detail: String,
    /// Every fault of the request at once.
    pub errors: Vec<Fault>,
    /// A header that belongs to it; boxed, as it is seldom there.
    #[serde(skip)]
    header: Option<Box<(HeaderName, String)>>,
}

impl Problem {
    fn new(status: StatusCode, kind: &str, title: &str, detail: impl Into<String>) -> Self {
        Self {
            kind: format!("urn:seamster:problem:{kind}"),
            title: title.to_owned(),
            status: status.as_u16(),
            detail: detail.into(),
            errors: vec![],
            header: None,
        }
    }

    /// The same problem with a header.
    fn with(mut self, name: HeaderName, value: impl Into<String>) -> Self {
        self.header = Some(Box::new((name, value.into())));
        self
    }

    /// The same problem with its faults.
    fn because(mut self, faults: impl Into<Faults>) -> Self {
        self.errors = faults.into().0;
        self
    }

    /// A request that is not even readable.
    pub(super) fn unreadable(faults: impl Into<Faults>) -> Self {
        let detail = "The request could not be read; `errors` says where.";
        Self::new(
            StatusCode::BAD_REQUEST,
            "unreadable",
            "Unreadable request",
            detail,
        )
        .because(faults)
    }

    /// A token is needed, and none or a wrong one came.
    pub(super) fn unauthorized() -> Self {
        let detail = "This call needs the header `Authorization: Bearer <token>` with a token of this service.";
        Self::new(
            StatusCode::UNAUTHORIZED,
            "unauthorized",
            "Token needed",
            detail,
        )
        .with(header::WWW_AUTHENTICATE, "Bearer realm=\"seamster\"")
    }

    /// A writing call from another site's page.
    pub(super) fn foreign_origin(origin: &str) -> Self {
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

    /// There is no such thing.
    pub(super) fn not_found(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, "not-found", "Not found", detail)
    }

    /// The thing is there, the method is not.
    pub(super) fn method_not_allowed(method: &str, path: &str) -> Self {
        let detail = format!("{path} has no {method}; see /openapi.json for what there is.");
        Self::new(
            StatusCode::METHOD_NOT_ALLOWED,
            "method-not-allowed",
            "Method not allowed",
            detail,
        )
    }

    /// Nothing that the client accepts.
    pub(super) fn not_acceptable(offered: &str) -> Self {
        let detail = format!("None of the types in `Accept` is offered; there are {offered}.");
        Self::new(
            StatusCode::NOT_ACCEPTABLE,
            "not-acceptable",
            "Not acceptable",
            detail,
        )
    }

    /// It took too long.
    pub(super) fn timed_out() -> Self {
        let detail = "The request took longer than this service allows.";
        Self::new(StatusCode::REQUEST_TIMEOUT, "timeout", "Timed out", detail)
    }

    /// What was asked for cannot be given in the state that things are in.
    pub(super) fn conflict(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::CONFLICT, "conflict", "Conflict", detail)
    }

    /// A body above its limit.
    pub(super) fn too_large(detail: impl Into<String>) -> Self {
        Self::new(
            StatusCode::PAYLOAD_TOO_LARGE,
            "too-large",
            "Too large",
            detail,
        )
    }

    /// A body of a type that the call does not read.
    pub(super) fn unsupported_type(got: &str, wanted: &str) -> Self {
        let detail = format!("The body is {got:?}; this call reads {wanted}.");
        Self::new(
            StatusCode::UNSUPPORTED_MEDIA_TYPE,
            "unsupported-type",
            "Unsupported media type",
            detail,
        )
    }

    /// A range outside of what there is.
    pub(super) fn range_not_satisfiable(length: usize) -> Self {
        let detail = format!("The range lies outside of the {length} bytes there are.");
        Self::new(
            StatusCode::RANGE_NOT_SATISFIABLE,
            "range",
            "Range not satisfiable",
            detail,
        )
        .with(header::CONTENT_RANGE, format!("bytes */{length}"))
    }

    /// A host name that is not this service's.
    pub(super) fn misdirected(host: &str) -> Self {
        let detail = format!("This service does not answer for the host {host:?}.");
        Self::new(
            StatusCode::MISDIRECTED_REQUEST,
            "misdirected",
            "Misdirected request",
            detail,
        )
    }

    /// Not now.
    pub(super) fn unavailable(detail: impl Into<String>, retry_after_s: u64) -> Self {
        Self::new(
            StatusCode::SERVICE_UNAVAILABLE,
            "unavailable",
            "Not now",
            detail,
        )
        .with(header::RETRY_AFTER, retry_after_s.to_string())
    }

    /// A fault of the service itself; `cause` goes to the log only.
    pub(super) fn internal(cause: impl std::fmt::Display) -> Self {
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

impl From<Faults> for Problem {
    fn from(faults: Faults) -> Self {
        let detail = match faults.0.as_slice() {
            [one] => one.detail.clone(),
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
        .because(faults)
    }
}

impl From<Fault> for Problem {
    fn from(fault: Fault) -> Self {
        Faults::from(fault).into()
    }
}

impl From<StoreError> for Problem {
    fn from(error: StoreError) -> Self {
        Self::internal(error)
    }
}

impl From<QueueError> for Problem {
    fn from(error: QueueError) -> Self {
        match error {
            QueueError::Full(_) => Self::unavailable(error.to_string(), RETRY_FULL_S),
            QueueError::KeyReused(kind) => {
                let code = format!("{}/key_reused", kind.as_str());
                Fault::new(&code, "/Idempotency-Key", error.to_string())
                    .fix("send a new key with a new request")
                    .into()
            }
            QueueError::Store(error) => error.into(),
        }
    }
}

/// A failed job's reason, as the answer that it would have been.
impl From<Failure> for Problem {
    fn from(failure: Failure) -> Self {
        let (what, why) = failure.code.split_once('/').unwrap_or(("fit", ""));
        let status = match why {
            "panicked" | "storage" | "abandoned" => StatusCode::INTERNAL_SERVER_ERROR,
            _ => StatusCode::UNPROCESSABLE_ENTITY,
        };
        let title = format!("The {what} failed");
        let kind = failure.code.replace(['/', '_'], "-");
        let faults = if failure.errors.is_empty() {
            Fault::new(&failure.code, "", failure.detail.clone()).into()
        } else {
            Faults(failure.errors)
        };
        Self::new(status, &kind, &title, failure.detail).because(faults)
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
