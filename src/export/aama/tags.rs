//! Tags of an R12 DXF: a group code and a value, each on a line of its own.

use crate::pattern::point::Point2;
use std::fmt::Write;

/// Height of texts \[mm\].
pub(super) const TEXT_HEIGHT: f64 = 6.0;

/// Characters of a text at most: of seven bytes each they are far from the longest line that is
/// read.
const MOST_CHARS: usize = 2_000;

/// A DXF file as it grows. Lengths go in as meters and are written as millimeters.
#[derive(Default)]
pub(super) struct TagWriter(String);

impl TagWriter {
    /// Adds a tag with the first 2000 characters of a text: ASCII, the backslash and other
    /// characters as `\U+XXXX`, `^` as `^ ` (both are how R12 writes them), control characters as
    /// blanks.
    pub(super) fn text(&mut self, code: u32, value: &str) -> &mut Self {
        write!(self.0, "{code:>3}\r\n").expect("a String takes all");
        for c in value.chars().take(MOST_CHARS) {
            match c {
                '^' => self.0.push_str("^ "),
                ' '..='~' if c != '\\' => self.0.push(c),
                _ if c.is_control() => self.0.push(' '),
                _ => {
                    for unit in c.encode_utf16(&mut [0; 2]) {
                        write!(self.0, "\\U+{unit:04X}").expect("a String takes all");
                    }
                }
            }
        }
        self.0.push_str("\r\n");
        self
    }

    /// Adds a tag with a number.
    pub(super) fn number(&mut self, code: u32, value: f64) -> &mut Self {
        let fixed = format!("{value:.7}");
        let trimmed = fixed.trim_end_matches('0').trim_end_matches('.');
        let value = if trimmed == "-0" { "0" } else { trimmed };
        write!(self.0, "{code:>3}\r\n{value}\r\n").expect("a String takes all");
        self
    }

    /// Adds a length.
    pub(super) fn length(&mut self, code: u32, length_m: f64) -> &mut Self {
        self.number(code, 1e3 * length_m)
    }

    /// Adds coordinates, x under `code` and y under `code + 10`.
    pub(super) fn place(&mut self, code: u32, [x, y]: Point2) -> &mut Self {
        self.length(code, x).length(code + 10, y)
    }

    /// Opens an entity on a layer.
    pub(super) fn entity(&mut self, kind: &str, layer: u32) -> &mut Self {
        self.text(0, kind).text(8, &layer.to_string())
    }

    /// Adds a point.
    pub(super) fn point(&mut self, layer: u32, at: Point2) -> &mut Self {
        self.entity("POINT", layer).place(10, at)
    }

    /// Adds a straight line.
    pub(super) fn line(&mut self, layer: u32, [a, b]: [Point2; 2]) {
        self.entity("LINE", layer).place(10, a).place(11, b);
    }

    /// Adds a polyline.
    pub(super) fn polyline(&mut self, layer: u32, points: &[Point2], closed: bool) {
        self.entity("POLYLINE", layer).number(66, 1.0);
        self.number(10, 0.0).number(20, 0.0).number(30, 0.0);
        self.number(70, if closed { 1.0 } else { 0.0 });
        for point in points {
            self.entity("VERTEX", layer).place(10, *point);
        }
        self.entity("SEQEND", layer);
    }

    /// Adds texts, one below the other.
    pub(super) fn lines_of_text(&mut self, lines: &[String], at: Point2) {
        let step = 1.5e-3 * TEXT_HEIGHT;
        for (i, line) in lines.iter().enumerate() {
            let at = [at[0], at[1] - step * i as f64];
            self.entity("TEXT", 1).place(10, at);
            self.number(40, TEXT_HEIGHT).text(1, line);
        }
    }

    /// Adds a section.
    pub(super) fn section(&mut self, name: &str, body: impl FnOnce(&mut Self)) {
        self.text(0, "SECTION").text(2, name);
        body(self);
        self.text(0, "ENDSEC");
    }

    /// Returns the text.
    pub(super) fn into_text(self) -> String {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backslash_is_no_escape_and_long_texts_end() {
        let mut file = TagWriter::default();
        file.text(1, "\\U+0041").text(1, &"袖".repeat(60_000));
        let text = file.into_text();
        assert!(text.starts_with("  1\r\n\\U+005CU+0041\r\n"));
        assert_eq!(text.lines().map(str::len).max(), Some(7 * MOST_CHARS));
    }

    #[test]
    fn texts_are_ascii_and_numbers_are_short() {
        let mut file = TagWriter::default();
        file.text(1, "袖 é^\n").number(10, -0.0).number(20, 1.25);
        file.number(30, 100.0).number(40, -1e-9);
        assert_eq!(
            file.into_text(),
            "  1\r\n\\U+8896 \\U+00E9^  \r\n 10\r\n0\r\n 20\r\n1.25\r\n 30\r\n100\r\n 40\r\n0\r\n"
        );
    }
}
