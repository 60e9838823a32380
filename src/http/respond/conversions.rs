//! Errors of other modules as problems: the only place that gives them a status.

use super::problem::Problem;
use crate::fault::{Fault, FaultCode, Faults, FitCode, StudyCode};
use crate::fit::ReadError;
use crate::job::{JobFailure, JobKind, QueueError, StoreError};
use axum::extract::multipart::{MultipartError, MultipartRejection};
use axum::extract::rejection::PathRejection;
use axum::http::StatusCode;

impl From<Faults> for Problem {
    fn from(faults: Faults) -> Self {
        Self::invalid(faults)
    }
}

impl From<Fault> for Problem {
    fn from(fault: Fault) -> Self {
        Faults::from(fault).into()
    }
}

impl From<StoreError> for Problem {
    fn from(error: StoreError) -> Self {
        if error.is_passing() {
            tracing::error!(%error, "the store does not answer");
            Self::store_unavailable()
        } else {
            Self::internal(error)
        }
    }
}

impl From<QueueError> for Problem {
    fn from(error: QueueError) -> Self {
        match error {
            QueueError::Full(_) => Self::queue_full(error.to_string()),
            QueueError::KeyReused(kind) => {
                let code = match kind {
                    JobKind::Fit => FaultCode::from(FitCode::KeyReused),
                    JobKind::Study => StudyCode::KeyReused.into(),
                };
                Fault::new(code, "/Idempotency-Key", error.to_string())
                    .fix("send a new key with a new request")
                    .into()
            }
            QueueError::Store(error) => error.into(),
        }
    }
}

/// The failure of a job as the answer that it would have been.
impl From<JobFailure> for Problem {
    fn from(failure: JobFailure) -> Self {
        let failure = failure.public();
        let status = if failure.is_internal() {
            StatusCode::INTERNAL_SERVER_ERROR
        } else {
            StatusCode::UNPROCESSABLE_ENTITY
        };
        let code = failure.code.as_str();
        let job = code.split_once('/').map_or("fit", |(job, _)| job);
        let title = format!("The {job} failed");
        let kind = code.replace(['/', '_'], "-");
        let faults = if failure.errors.is_empty() {
            Fault::new(failure.code, "", failure.detail.clone()).into()
        } else {
            Faults(failure.errors)
        };
        Self::new(status, &kind, &title, failure.detail).with_faults(faults)
    }
}

impl From<ReadError> for Problem {
    fn from(misshapen: ReadError) -> Self {
        match misshapen {
            ReadError::Syntax(fault) => Self::unreadable(fault),
            ReadError::Schema(faults) => faults.into(),
            ReadError::Many(faults) => Self::invalid_uncounted(faults),
        }
    }
}

impl From<PathRejection> for Problem {
    fn from(rejection: PathRejection) -> Self {
        Self::not_found(format!("No such thing: {}.", rejection.body_text()))
    }
}

impl From<MultipartRejection> for Problem {
    fn from(rejection: MultipartRejection) -> Self {
        Self::unreadable_body(rejection.body_text())
    }
}

impl From<MultipartError> for Problem {
    fn from(error: MultipartError) -> Self {
        Self::unreadable_body(error.body_text())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_that_an_older_version_kept_names_no_file() {
        for code in ["fit/storage", "study/storage"] {
            let kept = serde_json::json!({
                "code": code, "detail": "writing /srv/data/blobs/results/x: No space left on device",
            });
            let failure: JobFailure = serde_json::from_value(kept).unwrap();
            let problem = serde_json::to_string(&Problem::from(failure)).unwrap();
            assert!(!problem.contains("/srv"), "{problem}");
        }
    }
}
