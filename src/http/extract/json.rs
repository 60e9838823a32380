//! JSON bodies, checked against their schemas.

use super::body::{content_type, read_body};
use crate::config::Limits;
use crate::fit::{self, Garment, ReadError, RequestSchema};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::AvatarRequest;
use crate::scene::Fabric;
use crate::study::{self, StudyRequest};
use axum::extract::{FromRequest, Request};
use axum::http::HeaderMap;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::sync::LazyLock;

/// Most bytes of a small body.
const SMALL_BYTES: usize = 64 << 10;

/// A type that clients send as JSON.
pub(in crate::http) trait JsonBody: DeserializeOwned + Send + 'static {
    /// Reads a value, telling all faults of its shape at once.
    fn read(bytes: &[u8]) -> Result<Self, ReadError>;

    /// Returns the most bytes that it may have.
    fn max_bytes(_: &Limits) -> usize {
        SMALL_BYTES
    }
}

impl JsonBody for Garment {
    fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        fit::read_garment(bytes)
    }

    fn max_bytes(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

impl JsonBody for StudyRequest {
    fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        study::read_study(bytes)
    }

    fn max_bytes(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

impl JsonBody for AvatarRequest {
    fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        // Made of the type alone, once.
        static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<AvatarRequest>);
        SCHEMA.read(bytes)
    }
}

impl JsonBody for Fabric {
    fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        // Made of the type alone, once.
        static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<Fabric>);
        SCHEMA.read(bytes)
    }
}

/// A JSON body of the right shape.
pub(in crate::http) struct ValidatedJson<T>(pub(in crate::http) T);

impl<T: JsonBody> FromRequest<AppState> for ValidatedJson<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        require_json(request.headers())?;
        let bytes = read_body(request, T::max_bytes(state.limits())).await?;
        let value = state.run_compute(move |_| T::read(&bytes)).await?;
        Ok(Self(value?))
    }
}

/// A JSON body of the right shape, with the SHA-256 of its bytes.
pub(in crate::http) struct JsonWithDigest<T>(pub(in crate::http) T, pub(in crate::http) [u8; 32]);

impl<T: JsonBody> FromRequest<AppState> for JsonWithDigest<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        require_json(request.headers())?;
        let bytes = read_body(request, T::max_bytes(state.limits())).await?;
        let read = move |_: &_| Ok(Self(T::read(&bytes)?, Sha256::digest(&bytes).into()));
        state.run_compute(read).await?
    }
}

/// A JSON body of the right shape, or none at all.
pub(in crate::http) struct OptionalJson<T>(pub(in crate::http) T);

impl<T: JsonBody + Default> FromRequest<AppState> for OptionalJson<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        let json = require_json(request.headers());
        let bytes = read_body(request, T::max_bytes(state.limits())).await?;
        if bytes.is_empty() {
            return Ok(Self(T::default()));
        }
        json?;
        let value = state.run_compute(move |_| T::read(&bytes)).await?;
        Ok(Self(value?))
    }
}

/// Refuses a body whose type is not JSON.
fn require_json(headers: &HeaderMap) -> Result<(), Problem> {
    let essence = content_type(headers);
    if essence == "application/json" || essence.ends_with("+json") {
        Ok(())
    } else {
        Err(Problem::unsupported_type(&essence, "application/json"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_can_be_made() {
        assert!(Garment::read(br#"{"seams": []}"#).is_ok());
        assert!(AvatarRequest::read(b"[]").is_err());
        assert!(Fabric::read(b"[]").is_err());
        assert!(StudyRequest::read(br#"{"garment": {"seams": []}}"#).is_ok());
    }
}
