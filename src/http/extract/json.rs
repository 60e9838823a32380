//! JSON bodies, checked against their schemas.

use super::body::{content_type, read_body};
use crate::config::Limits;
use crate::fit::{self, Garment, ReadError, RequestSchema};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::AvatarRequest;
use crate::json::{AnyPlace, JsonBounds};
use crate::scene::Fabric;
use crate::study::{self, StudyRequest};
use axum::body::Bytes;
use axum::extract::{FromRequest, Request};
use axum::http::HeaderMap;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::sync::LazyLock;
use tokio::sync::OwnedSemaphorePermit;

/// Most bytes of a small body.
const SMALL_BYTES: usize = 64 << 10;

/// A type that clients send as JSON.
pub(in crate::http) trait JsonBody: DeserializeOwned + Send + 'static {
    /// Returns the schema that it is checked against.
    fn schema() -> &'static RequestSchema;

    /// Returns the bounds of its lists and texts.
    fn bounds(limits: &Limits) -> JsonBounds {
        JsonBounds::new(AnyPlace::of_requests(limits), [])
    }

    /// Returns the most bytes that it may have.
    fn max_bytes(_: &Limits) -> usize {
        SMALL_BYTES
    }
}

impl JsonBody for Garment {
    fn schema() -> &'static RequestSchema {
        fit::garment_schema()
    }

    fn bounds(limits: &Limits) -> JsonBounds {
        fit::garment_bounds(limits)
    }

    fn max_bytes(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

impl JsonBody for StudyRequest {
    fn schema() -> &'static RequestSchema {
        study::study_schema()
    }

    fn bounds(limits: &Limits) -> JsonBounds {
        study::study_bounds(limits)
    }

    fn max_bytes(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

impl JsonBody for AvatarRequest {
    fn schema() -> &'static RequestSchema {
        // Made of the type alone, once.
        static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<AvatarRequest>);
        &SCHEMA
    }
}

impl JsonBody for Fabric {
    fn schema() -> &'static RequestSchema {
        // Made of the type alone, once.
        static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<Fabric>);
        &SCHEMA
    }
}

/// The right to the memory that a value takes, given back when it is dropped: with the value.
pub(in crate::http) type JsonMemory = Option<OwnedSemaphorePermit>;

/// A JSON body of the right shape.
pub(in crate::http) struct ValidatedJson<T>(pub(in crate::http) T, pub(in crate::http) JsonMemory);

impl<T: JsonBody> FromRequest<AppState> for ValidatedJson<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        require_json(request.headers())?;
        let bytes = read_body(state, request, T::max_bytes(state.limits())).await?;
        let (value, memory) = read_json(state, bytes).await?;
        Ok(Self(value, memory))
    }
}

/// A JSON body of the right shape, with the SHA-256 of its bytes.
pub(in crate::http) struct JsonWithDigest<T> {
    /// The value.
    pub(in crate::http) value: T,
    /// SHA-256 of the body.
    pub(in crate::http) digest: [u8; 32],
    /// The right to the memory of the value.
    pub(in crate::http) memory: JsonMemory,
}

impl<T: JsonBody> FromRequest<AppState> for JsonWithDigest<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        require_json(request.headers())?;
        let bytes = read_body(state, request, T::max_bytes(state.limits())).await?;
        let text = bytes.clone();
        let (value, memory) = read_json(state, bytes).await?;
        let digest = state.run_compute(move |_| Sha256::digest(&text).into());
        Ok(Self {
            value,
            digest: digest.await?,
            memory,
        })
    }
}

/// A JSON body of the right shape, or none at all.
pub(in crate::http) struct OptionalJson<T>(pub(in crate::http) T);

impl<T: JsonBody + Default> FromRequest<AppState> for OptionalJson<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        let json = require_json(request.headers());
        let bytes = read_body(state, request, T::max_bytes(state.limits())).await?;
        if bytes.is_empty() {
            return Ok(Self(T::default()));
        }
        json?;
        let (value, _) = read_json(state, bytes).await?;
        Ok(Self(value))
    }
}

/// Reads JSON: measured first, and once the memory that it takes is free.
async fn read_json<T: JsonBody>(
    state: &AppState,
    bytes: Bytes,
) -> Result<(T, JsonMemory), Problem> {
    let text = bytes.clone();
    let measured = state.run_compute(move |app| measure_json::<T>(&text, app.limits()));
    let memory = state.json_memory(measured.await??).await;
    let read = state.run_compute(move |_| Ok::<_, ReadError>((T::schema().read(&bytes)?, memory)));
    Ok(read.await??)
}

/// Returns the memory that reading a value takes \[bytes\].
pub(super) fn measure_json<T: JsonBody>(bytes: &[u8], limits: &Limits) -> Result<usize, ReadError> {
    RequestSchema::measure(bytes, &T::bounds(limits))
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
    use axum::body::Body;
    use std::time::Duration;
    use tokio::time::timeout;

    #[test]
    fn the_memory_of_a_value_is_held_until_it_is_given_back() {
        let folder = tempfile::tempdir().unwrap();
        let limits = Limits::default();
        let state = AppState::of_test(folder.path(), limits.clone());
        let all = || state.json_memory(limits.json_memory_bytes);
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_time()
            .build();
        runtime.unwrap().block_on(async {
            let request = Request::builder().header("content-type", "application/json");
            let request = request.body(Body::from(r#"{"seams": []}"#)).unwrap();
            let read = JsonWithDigest::<Garment>::from_request(request, &state).await;
            let Ok(JsonWithDigest { memory, .. }) = read else {
                panic!("it is a garment");
            };
            let short = Duration::from_millis(100);
            assert!(timeout(short, all()).await.is_err(), "a part is held");
            drop(memory);
            assert!(all().await.is_some());
        });
    }

    #[test]
    fn every_shape_can_be_made() {
        fn read<T: JsonBody>(text: &str) -> Result<T, ReadError> {
            T::schema().read(text.as_bytes())
        }
        assert!(read::<Garment>(r#"{"seams": []}"#).is_ok());
        assert!(read::<AvatarRequest>("[]").is_err());
        assert!(read::<Fabric>("[]").is_err());
        assert!(read::<StudyRequest>(r#"{"garment": {"seams": []}}"#).is_ok());
    }
}
