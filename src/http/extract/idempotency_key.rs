//! `Idempotency-Key`: the key by which a repeated request means the same job.

use super::invalid;
use crate::http::respond::Problem;
use crate::job::IdempotencyKey;
use axum::http::HeaderMap;

/// Most characters of a key.
const MAX_CHARS: usize = 255;

/// Returns the client's `Idempotency-Key` with the digest of its request.
pub(in crate::http) fn idempotency_key(
    headers: &HeaderMap,
    digest: [u8; 32],
) -> Result<Option<IdempotencyKey>, Problem> {
    let Some(value) = headers.get("Idempotency-Key") else {
        return Ok(None);
    };
    match value.to_str().map(str::trim) {
        Ok(key) if (1..=MAX_CHARS).contains(&key.len()) => Ok(Some(IdempotencyKey {
            key: key.to_owned(),
            digest,
        })),
        _ => Err(invalid::idempotency_key(MAX_CHARS).into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    fn headers(value: &'static str) -> HeaderMap {
        let name = "idempotency-key".parse().unwrap();
        HeaderMap::from_iter([(name, HeaderValue::from_static(value))])
    }

    #[test]
    fn an_empty_or_endless_key_is_refused() {
        assert!(idempotency_key(&headers("a"), [0; 32]).is_ok());
        assert!(idempotency_key(&headers(""), [0; 32]).is_err());
        let long: &'static str = "x".repeat(256).leak();
        assert!(idempotency_key(&headers(long), [0; 32]).is_err());
        assert_eq!(idempotency_key(&HeaderMap::new(), [0; 32]).unwrap(), None);
    }
}
