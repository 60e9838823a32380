//! Bytes as an answer: strong `ETag`, `If-None-Match`, `Range` (RFC 9110).

use super::problem::Problem;
use axum::body::{Body, Bytes};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::ops::Range;

/// Bytes with their type, ready to be asked for in part.
#[derive(Clone, Debug)]
pub(super) struct Answer {
    bytes: Bytes,
    content_type: String,
    etag: String,
}

impl Answer {
    /// An answer of these bytes.
    pub(super) fn new(bytes: impl Into<Bytes>, content_type: impl Into<String>) -> Self {
        let bytes = bytes.into();
        let digest = Sha256::digest(&bytes);
        let hex = digest.iter().take(16).fold(String::new(), |mut hex, byte| {
            write!(hex, "{byte:02x}").expect("a string takes all");
            hex
        });
        Self {
            bytes,
            content_type: content_type.into(),
            etag: format!("\"{hex}\""),
        }
    }

    /// All of it, a part, or that it has not changed, as `asked` has it.
    pub(super) fn to(self, asked: &HeaderMap) -> Result<Response, Problem> {
        if matches(asked, header::IF_NONE_MATCH.as_str(), &self.etag) {
            return Ok(self.respond(StatusCode::NOT_MODIFIED, None));
        }
        let is_current = asked
            .get(header::IF_RANGE)
            .is_none_or(|tag| tag.as_bytes() == self.etag.as_bytes());
        let range = asked
            .get(header::RANGE)
            .and_then(|range| range.to_str().ok());
        match range
            .filter(|_| is_current)
            .map(|range| part(range, self.bytes.len()))
        {
            None | Some(Part::Whole) => Ok(self.respond(StatusCode::OK, None)),
            Some(Part::Bytes(range)) => Ok(self.respond(StatusCode::PARTIAL_CONTENT, Some(range))),
            Some(Part::Outside) => Err(Problem::range_not_satisfiable(self.bytes.len())),
        }
    }

    fn respond(self, status: StatusCode, range: Option<Range<usize>>) -> Response {
        let total = self.bytes.len();
        let body = match &range {
            Some(range) => self.bytes.slice(range.clone()),
            None if status == StatusCode::NOT_MODIFIED => Bytes::new(),
            None => self.bytes,
        };
        let mut response = (
            status,
            [
                (header::CONTENT_TYPE, self.content_type),
                (header::ETAG, self.etag),
                (header::ACCEPT_RANGES, "bytes".to_owned()),
                (header::CACHE_CONTROL, "no-cache".to_owned()),
            ],
            Body::from(body),
        )
            .into_response();
        if let Some(range) = range {
            let value = format!("bytes {}-{}/{total}", range.start, range.end - 1);
            let value = value.parse().expect("digits and dashes are a header value");
            response.headers_mut().insert(header::CONTENT_RANGE, value);
        }
        response
    }
}

/// Whether a list of entity tags names `etag`, by the weak comparison that `If-None-Match` asks for.
fn matches(asked: &HeaderMap, name: &str, etag: &str) -> bool {
    asked.get_all(name).iter().any(|list| {
        let tags = list.to_str().unwrap_or_default().split(',');
        tags.map(str::trim)
            .any(|tag| tag == "*" || tag.trim_start_matches("W/") == etag)
    })
}

#[derive(Debug, PartialEq)]
enum Part {
    /// No range that is understood: the whole is the right answer.
    Whole,
    Bytes(Range<usize>),
    Outside,
}

/// Reads `bytes=first-last`, `bytes=first-` or `bytes=-count`; several ranges at once are answered with the whole.
fn part(range: &str, total: usize) -> Part {
    let Some((first, last)) = range
        .strip_prefix("bytes=")
        .and_then(|range| range.trim().split_once('-'))
    else {
        return Part::Whole;
    };
    match (first.parse::<usize>(), last.parse::<usize>()) {
        (Err(_), Ok(count)) if first.is_empty() => within(total.saturating_sub(count)..total),
        (Ok(first), Err(_)) if last.is_empty() => within(first..total),
        (Ok(first), Ok(last)) if first <= last => within(first..last.saturating_add(1).min(total)),
        _ => Part::Whole,
    }
}

fn within(range: Range<usize>) -> Part {
    if range.is_empty() {
        Part::Outside
    } else {
        Part::Bytes(range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_the_standard_has_them() {
        assert_eq!(part("bytes=0-4", 10), Part::Bytes(0..5));
        assert_eq!(part("bytes=4-", 10), Part::Bytes(4..10));
        assert_eq!(part("bytes=-3", 10), Part::Bytes(7..10));
        assert_eq!(part("bytes=-30", 10), Part::Bytes(0..10));
        assert_eq!(part("bytes=8-99", 10), Part::Bytes(8..10));
        assert_eq!(part("bytes=0-18446744073709551615", 10), Part::Bytes(0..10));
    }

    #[test]
    fn ranges_outside_cannot_be_satisfied() {
        for range in ["bytes=10-", "bytes=10-20", "bytes=-0"] {
            assert_eq!(part(range, 10), Part::Outside, "{range}");
        }
        assert_eq!(part("bytes=0-", 0), Part::Outside);
    }

    #[test]
    fn ranges_not_understood_are_ignored() {
        for range in [
            "bytes=0-1,3-4",
            "bytes=5-2",
            "lines=0-1",
            "bytes=a-b",
            "bytes=",
        ] {
            assert_eq!(part(range, 10), Part::Whole, "{range}");
        }
    }

    #[test]
    fn equal_bytes_have_equal_tags() {
        let tag = |text: &'static str| Answer::new(text, "text/plain").etag;
        assert_eq!(tag("a"), tag("a"));
        assert_ne!(tag("a"), tag("b"));
    }
}
