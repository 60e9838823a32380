//! Elements as text: numbers, paths, and long texts cut short.
//!
//! Everything is said by attributes: a style sheet or a `style` would need leave from the content
//! security policy.

use crate::pattern::point::{Point2, distance};

/// Points nearer to the last one drawn than this are left out \[mm\].
const FINE: f64 = 0.05;

/// Writes a number with at most two digits after the point.
pub(super) fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// Writes the path data of a polyline \[mm\].
pub(super) fn path(points: &[Point2], closed: bool) -> String {
    let mut data = String::new();
    let mut last: Option<Point2> = None;
    for (i, p) in points.iter().enumerate() {
        let is_end = i + 1 == points.len() && !closed;
        if last.is_some_and(|last| distance(last, *p) < FINE && !is_end) {
            continue;
        }
        data.push(if last.is_none() { 'M' } else { 'L' });
        data += &format!("{} {}", number(p[0]), number(p[1]));
        last = Some(*p);
    }
    if closed {
        data.push('Z');
    }
    data
}

/// Returns the first `most` characters, with a sign that there are more.
pub(super) fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let mut short: String = text.chars().take(most.saturating_sub(1)).collect();
    short.push('…');
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_zero_has_no_sign() {
        let texts = [-0.001, 0.0, 1.5, 2.0, 100.0, -3.456].map(number);
        assert_eq!(texts, ["0", "0", "1.5", "2", "100", "-3.46"]);
    }

    #[test]
    fn long_texts_end_in_an_ellipsis() {
        assert_eq!(shortened("前片前片", 3), "前片…");
    }

    #[test]
    fn paths_leave_out_points_that_cannot_be_told_apart() {
        let points = [[0.0, 0.0], [0.01, 0.0], [5.0, 0.0], [5.0, 0.01]];
        assert_eq!(path(&points, false), "M0 0L5 0L5 0.01");
        assert_eq!(path(&points[..3], true), "M0 0L5 0Z");
    }
}
