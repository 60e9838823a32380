//! `Range`: the part of a representation that a client requests (RFC 9110, 14).

use std::ops::Range;

/// The part of a representation that a `Range` header requests.
#[derive(Debug, PartialEq)]
pub(super) enum RequestedRange {
    /// The whole: no range, one that is not understood, or several at once.
    Whole,
    /// These bytes.
    Part(Range<usize>),
    /// No byte of the representation.
    Unsatisfiable,
}

impl RequestedRange {
    /// Reads `bytes=first-last`, `bytes=first-` or `bytes=-count` for a representation of `total`
    /// bytes.
    ///
    /// The type of the `headers` crate does not tell a range that cannot be satisfied from one that
    /// is not understood.
    pub(super) fn parse(header: &str, total: usize) -> Self {
        let Some((first, last)) = header
            .strip_prefix("bytes=")
            .and_then(|range| range.trim().split_once('-'))
        else {
            return Self::Whole;
        };
        match (first.parse::<usize>(), last.parse::<usize>()) {
            (Err(_), Ok(count)) if first.is_empty() => {
                Self::within(total.saturating_sub(count)..total)
            }
            (Ok(first), Err(_)) if last.is_empty() => Self::within(first..total),
            (Ok(first), Ok(last)) if first <= last => {
                Self::within(first..last.saturating_add(1).min(total))
            }
            _ => Self::Whole,
        }
    }

    fn within(range: Range<usize>) -> Self {
        if range.is_empty() {
            Self::Unsatisfiable
        } else {
            Self::Part(range)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_the_standard_has_them() {
        assert_eq!(
            RequestedRange::parse("bytes=0-4", 10),
            RequestedRange::Part(0..5)
        );
        assert_eq!(
            RequestedRange::parse("bytes=4-", 10),
            RequestedRange::Part(4..10)
        );
        assert_eq!(
            RequestedRange::parse("bytes=-3", 10),
            RequestedRange::Part(7..10)
        );
        assert_eq!(
            RequestedRange::parse("bytes=-30", 10),
            RequestedRange::Part(0..10)
        );
        assert_eq!(
            RequestedRange::parse("bytes=8-99", 10),
            RequestedRange::Part(8..10)
        );
        assert_eq!(
            RequestedRange::parse("bytes=0-18446744073709551615", 10),
            RequestedRange::Part(0..10)
        );
    }

    #[test]
    fn ranges_outside_cannot_be_satisfied() {
        for range in ["bytes=10-", "bytes=10-20", "bytes=-0"] {
            assert_eq!(
                RequestedRange::parse(range, 10),
                RequestedRange::Unsatisfiable,
                "{range}"
            );
        }
        assert_eq!(
            RequestedRange::parse("bytes=0-", 0),
            RequestedRange::Unsatisfiable
        );
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
            assert_eq!(
                RequestedRange::parse(range, 10),
                RequestedRange::Whole,
                "{range}"
            );
        }
    }
}
