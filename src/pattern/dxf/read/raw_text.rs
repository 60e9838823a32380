//! A DXF before it is decoded: what its header says of its encoding, and the first name that is not
//! ASCII.

/// The header is looked for in this many bytes.
const HEAD: usize = 20_000;

/// The digits of the release from which on files are UTF-8, as `$ACADVER` has it (2007).
const UTF_8_SINCE: &[u8] = b"1021";

/// Statements of a header about the encoding of its file.
#[derive(Default)]
pub(super) struct EncodingStatement<'a> {
    /// True if the release of the format is one whose files are UTF-8.
    pub(super) is_utf8_by_version: bool,
    /// `$DWGCODEPAGE` with its line, unless it is empty or says nothing.
    pub(super) page: Option<(&'a str, usize)>,
}

impl<'a> EncodingStatement<'a> {
    /// Returns the statements of a file.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let head = &bytes[..bytes.len().min(HEAD)];
        let version = header_value(head, b"$ACADVER");
        let page = header_value(head, b"$DWGCODEPAGE").and_then(|(value, line)| {
            let page = std::str::from_utf8(value).ok()?;
            let says_nothing = ["", "ascii", "undefined"].iter();
            let mut says_nothing = says_nothing.map(|word| page.eq_ignore_ascii_case(word));
            (!says_nothing.any(|same| same)).then_some((page, line))
        });
        Self {
            is_utf8_by_version: version.is_some_and(|(value, _)| is_utf8_version(value)),
            page,
        }
    }
}

/// Returns true for a version whose files are UTF-8: `AC` and four digits, from 1021 on.
fn is_utf8_version(value: &[u8]) -> bool {
    let digits = value.strip_prefix(b"AC").filter(|digits| digits.len() == 4);
    digits.is_some_and(|digits| digits.iter().all(u8::is_ascii_digit) && digits >= UTF_8_SINCE)
}

/// Returns the value two lines after a header variable's name, with its line.
fn header_value<'a>(head: &'a [u8], name: &[u8]) -> Option<(&'a [u8], usize)> {
    let lines = RawLines::new(head).map(<[u8]>::trim_ascii);
    let mut lines = lines.zip(1..);
    lines.find(|(line, _)| line.eq_ignore_ascii_case(name))?;
    lines.nth(1)
}

/// A name or text of a drawing with a byte beyond ASCII.
#[derive(Clone, Copy)]
pub(super) struct ForeignName<'a> {
    /// Its bytes.
    pub(super) bytes: &'a [u8],
    /// Its line.
    pub(super) line: usize,
}

/// Returns the first name or text of the blocks and entities with a byte beyond ASCII.
pub(super) fn first_foreign_name(bytes: &[u8]) -> Option<ForeignName<'_>> {
    let mut lines = RawLines::new(bytes).map(<[u8]>::trim_ascii).zip(1..);
    let mut is_drawing = false;
    let mut is_section = false;
    while let (Some((code, _)), Some((value, line))) = (lines.next(), lines.next()) {
        if is_section && code == b"2" {
            is_drawing = [&b"BLOCKS"[..], b"ENTITIES"].contains(&&*value.to_ascii_uppercase());
        }
        is_section = code == b"0" && value.eq_ignore_ascii_case(b"SECTION");
        let is_name = matches!(code, b"1" | b"2" | b"3" | b"8");
        if is_drawing && is_name && !value.is_ascii() {
            return Some(ForeignName { bytes: value, line });
        }
    }
    None
}

/// Lines ended by LF, CR LF or CR. In no encoding that is read is one of those a part of a
/// character.
struct RawLines<'a> {
    rest: &'a [u8],
}

impl<'a> RawLines<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }
}

impl<'a> Iterator for RawLines<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r'));
        let (line, after) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        let ended = after.strip_prefix(b"\r\n").or_else(|| after.get(1..));
        self.rest = ended.unwrap_or_default();
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn releases_since_2007_are_utf8() {
        for (version, expected) in [("AC1021", true), ("AC1032", true), ("AC1009", false)] {
            assert_eq!(is_utf8_version(version.as_bytes()), expected, "{version}");
        }
        for odd in ["", "AC", "AC2.10", "MC0.0", "ac9999x", "AC10210"] {
            assert!(!is_utf8_version(odd.as_bytes()), "{odd}");
        }
    }

    #[test]
    fn statements_of_the_header_are_found_at_all_line_ends() {
        for end in ["\n", "\r\n", "\r"] {
            let text = "9|$ACADVER|1|AC1021|9|$DWGCODEPAGE|3| ansi_1251 ".replace('|', end);
            let found = EncodingStatement::of(text.as_bytes());
            assert!(found.is_utf8_by_version);
            assert_eq!(found.page, Some(("ansi_1251", 8)));
        }
        assert!(
            EncodingStatement::of(b"9\n$DWGCODEPAGE\n3\nASCII\n")
                .page
                .is_none()
        );
    }

    #[test]
    fn first_name_beyond_ascii_is_one_of_the_drawing() {
        let file =
            "0|SECTION|2|TABLES|2|\u{e9}|0|SECTION|2|ENTITIES|8|1|999|\u{e9}|1|\u{e9}t\u{e9}";
        let file = file.replace('|', "\n");
        let found = first_foreign_name(file.as_bytes()).expect("a name");
        assert_eq!((found.bytes, found.line), ("été".as_bytes(), 16));
    }
}
