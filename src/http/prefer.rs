//! What a client says in headers beside its request: `Prefer`, `Idempotency-Key`, `Accept`.

use super::problem::Problem;
use crate::fault::Fault;
use crate::job::IdempotencyKey;
use axum::http::{HeaderMap, HeaderValue, header};
use std::time::Duration;

/// Characters of an `Idempotency-Key` at most.
const KEY_CHARS: usize = 255;

/// How long the client prefers to wait (`Prefer: wait=N`, RFC 7240), `most` seconds at most.
pub(super) fn wait(headers: &HeaderMap, most: f64) -> Option<Duration> {
    let seconds: u32 = headers
        .get_all("Prefer")
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|list| list.split([',', ';']))
        .filter_map(|item| item.split_once('='))
        .find(|(name, _)| name.trim().eq_ignore_ascii_case("wait"))
        .and_then(|(_, seconds)| seconds.trim().trim_matches('"').parse().ok())?;
    Some(Duration::from_secs_f64(f64::from(seconds).min(most)))
}

/// The value of `Preference-Applied`.
pub(super) fn applied(wait: Duration) -> HeaderValue {
    let value = format!("wait={}", wait.as_secs());
    value.parse().expect("a word and digits are a header value")
}

/// The client's `Idempotency-Key` with the digest of its request.
pub(super) fn idempotency_key(
    headers: &HeaderMap,
    digest: [u8; 32],
) -> Result<Option<IdempotencyKey>, Problem> {
    let Some(value) = headers.get("Idempotency-Key") else {
        return Ok(None);
    };
    match value.to_str().map(str::trim) {
        Ok(key) if (1..=KEY_CHARS).contains(&key.len()) => Ok(Some(IdempotencyKey {
            key: key.to_owned(),
            digest,
        })),
        _ => {
            let detail = format!("the key must be of 1 to {KEY_CHARS} visible ASCII characters");
            Err(Fault::new("request/key", "/Idempotency-Key", detail).into())
        }
    }
}

/// Which of `offered` the client wants most (`Accept`, RFC 9110); among equals the first, which is also for those who do not say.
pub(super) fn accepted<'a>(headers: &HeaderMap, offered: &[&'a str]) -> Option<&'a str> {
    let ranges: Vec<&str> = headers
        .get_all(header::ACCEPT)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|list| list.split(','))
        .filter(|range| !range.trim().is_empty())
        .collect();
    if ranges.is_empty() {
        return offered.first().copied();
    }
    let mut best = None;
    for kind in offered {
        let weight = weight(&ranges, kind);
        if weight > 0.0 && best.is_none_or(|(most, _)| weight > most) {
            best = Some((weight, *kind));
        }
    }
    best.map(|(_, kind)| kind)
}

/// The `q` of the most specific range that `kind` falls in, 0 if none.
fn weight(ranges: &[&str], kind: &str) -> f64 {
    let group = kind.split_once('/').map_or(kind, |(group, _)| group);
    let found = ranges.iter().filter_map(|range| {
        let mut parts = range.split(';').map(str::trim);
        let name = parts.next()?.to_ascii_lowercase();
        let specific = match name.as_str() {
            "*/*" => 0,
            name if name == kind => 2,
            name if name.strip_suffix("/*") == Some(group) => 1,
            _ => return None,
        };
        let q = parts.find_map(|part| part.strip_prefix("q="));
        Some((
            specific,
            q.map_or(Some(1.0), |q| q.parse().ok()).unwrap_or(0.0),
        ))
    });
    found
        .max_by_key(|(specific, _)| *specific)
        .map_or(0.0, |(_, q)| q)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [&str; 3] = ["model/gltf-binary", "model/obj", "application/json"];

    fn headers(name: &'static str, value: &'static str) -> HeaderMap {
        HeaderMap::from_iter([(name.parse().unwrap(), HeaderValue::from_static(value))])
    }

    #[test]
    fn the_wanted_type_is_chosen_as_the_standard_has_it() {
        for (accept, chosen) in [
            ("model/obj", Some("model/obj")),
            ("*/*", Some("model/gltf-binary")),
            ("application/*", Some("application/json")),
            ("model/*;q=0.2, application/json", Some("application/json")),
            ("*/*, model/gltf-binary;q=0", Some("model/obj")),
            ("text/html", None),
            ("model/obj;q=0", None),
        ] {
            assert_eq!(
                accepted(&headers("accept", accept), &MESH),
                chosen,
                "{accept}"
            );
        }
        assert_eq!(accepted(&HeaderMap::new(), &MESH), Some(MESH[0]));
    }

    #[test]
    fn a_wait_is_read_and_bounded() {
        for (prefer, seconds) in [
            ("wait=10", Some(10)),
            ("respond-async, wait=7", Some(7)),
            ("WAIT = 5", Some(5)),
            ("wait=4000000000", Some(60)),
            ("wait=soon", None),
            ("return=minimal", None),
        ] {
            let expected = seconds.map(Duration::from_secs);
            assert_eq!(wait(&headers("prefer", prefer), 60.0), expected, "{prefer}");
        }
    }

    #[test]
    fn an_empty_or_endless_key_is_refused() {
        assert!(idempotency_key(&headers("idempotency-key", "a"), [0; 32]).is_ok());
        assert!(idempotency_key(&headers("idempotency-key", ""), [0; 32]).is_err());
        let long: &'static str = "x".repeat(256).leak();
        assert!(idempotency_key(&headers("idempotency-key", long), [0; 32]).is_err());
        assert_eq!(idempotency_key(&HeaderMap::new(), [0; 32]).unwrap(), None);
    }
}
