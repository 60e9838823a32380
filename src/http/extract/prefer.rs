//! `Prefer`: the wait that a client prefers.

use axum::http::{HeaderMap, HeaderValue};
use std::time::Duration;

/// Returns the wait that the client prefers (`Prefer: wait=N`, RFC 7240), at most `max_s` seconds.
pub(in crate::http) fn preferred_wait(headers: &HeaderMap, max_s: f64) -> Option<Duration> {
    let seconds: u32 = headers
        .get_all("Prefer")
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|list| list.split([',', ';']))
        .filter_map(|item| item.split_once('='))
        .find(|(name, _)| name.trim().eq_ignore_ascii_case("wait"))
        .and_then(|(_, seconds)| seconds.trim().trim_matches('"').parse().ok())?;
    Some(Duration::from_secs_f64(f64::from(seconds).min(max_s)))
}

/// Returns the value of `Preference-Applied`.
pub(in crate::http) fn preference_applied(wait: Duration) -> HeaderValue {
    let value = format!("wait={}", wait.as_secs());
    value.parse().expect("a word and digits are a header value")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(value: &'static str) -> HeaderMap {
        HeaderMap::from_iter([("prefer".parse().unwrap(), HeaderValue::from_static(value))])
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
            assert_eq!(preferred_wait(&headers(prefer), 60.0), expected, "{prefer}");
        }
    }
}
