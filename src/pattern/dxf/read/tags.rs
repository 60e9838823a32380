//! The tag pass: text to tags (a group code and a value, two lines), within the limits on lines.

use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::excerpt;

/// A group code with its value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DxfTag<'a> {
    /// Meaning of the value.
    pub(crate) code: i32,
    /// The value, without blanks at its ends.
    pub(crate) value: &'a str,
    /// Line of the group code, counted from 1.
    pub(crate) line: usize,
}

impl DxfTag<'_> {
    /// Returns true if this tag is `code 0` with the given keyword, in any case.
    pub(crate) fn opens(&self, keyword: &str) -> bool {
        self.code == 0 && self.value.eq_ignore_ascii_case(keyword)
    }
}

/// The tags of a file, without its comments (code 999).
pub(crate) struct DxfTags<'a> {
    /// All tags in file order.
    pub(crate) tags: Vec<DxfTag<'a>>,
    /// Line of a group code that stands at the end without a value.
    pub(crate) dangling: Option<usize>,
}

/// Splits `text` into tags.
///
/// # Errors
/// A line longer than `limits.dxf_line_bytes`, a NUL character, or a group code that is not a whole
/// number in -5..=1071.
pub(crate) fn read<'a>(text: &'a str, limits: &Limits) -> Result<DxfTags<'a>, Fault> {
    let mut tags = Vec::with_capacity(text.len() / 16);
    let mut lines = NumberedLines {
        rest: text,
        number: 0,
    };
    let mut dangling = None;
    while let Some((line, code)) = lines.next() {
        check_line(line, code, limits)?;
        let Some((value_line, value)) = lines.next() else {
            dangling = (!code.trim().is_empty()).then_some(line);
            break;
        };
        check_line(value_line, value, limits)?;
        if tags.is_empty() && !matches!(code.trim(), "0" | "999") {
            return Err(super::file_type::not_dxf(
                &format!(
                    "a DXF begins with 0 and SECTION, here stands {:?}",
                    excerpt(code)
                ),
                "upload a DXF file",
            ));
        }
        let code = group_code(line, code)?;
        if code != 999 {
            tags.push(DxfTag {
                code,
                value: value.trim(),
                line,
            });
        }
    }
    Ok(DxfTags { tags, dangling })
}

fn check_line(line: usize, text: &str, limits: &Limits) -> Result<(), Fault> {
    if text.len() > limits.dxf_line_bytes {
        return Err(Fault::new(
            PatternCode::LineTooLong,
            format!("line {line}"),
            format!(
                "the line has {} bytes; at most {} are read",
                text.len(),
                limits.dxf_line_bytes
            ),
        )
        .fix("shorten the text in the CAD program"));
    }
    if text.contains('\0') {
        return Err(Fault::new(
            PatternCode::NulByte,
            format!("line {line}"),
            "the line holds a NUL byte, which no text DXF has",
        )
        .fix("export the file again; it was damaged on its way or is binary"));
    }
    Ok(())
}

fn group_code(line: usize, text: &str) -> Result<i32, Fault> {
    match text.trim().parse::<i32>() {
        Ok(code) if (-5..=1071).contains(&code) => Ok(code),
        _ => Err(Fault::new(
            PatternCode::GroupCode,
            format!("line {line}"),
            format!(
                "{:?} stands where a group code (a whole number up to 1071) must",
                excerpt(text)
            ),
        )
        .fix("export the file again; a line is missing or damaged before this one")),
    }
}

/// Lines ended by LF, CR LF or CR, numbered from 1.
struct NumberedLines<'a> {
    rest: &'a str,
    number: usize,
}

impl<'a> Iterator for NumberedLines<'a> {
    type Item = (usize, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        self.number += 1;
        let end = self.rest.find(['\n', '\r']).unwrap_or(self.rest.len());
        let line = &self.rest[..end];
        let after = &self.rest[end..];
        let skipped = if after.starts_with("\r\n") {
            2
        } else {
            after.len().min(1)
        };
        self.rest = &after[skipped..];
        Some((self.number, line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends_give_the_same_tags() {
        let limits = Limits::default();
        for text in [
            "0\nSECTION\n2\nENTITIES\n",
            "0\r\nSECTION\r\n2\r\nENTITIES",
            "0\rSECTION\r2\rENTITIES",
        ] {
            let found = read(text, &limits).expect("valid tags");
            let pairs: Vec<_> = found
                .tags
                .iter()
                .map(|t| (t.code, t.value, t.line))
                .collect();
            assert_eq!(pairs, [(0, "SECTION", 1), (2, "ENTITIES", 3)]);
        }
    }

    #[test]
    fn bad_group_code_names_its_line() {
        let fault = read("0\nSECTION\nxx\n1\n", &Limits::default())
            .err()
            .expect("refused");
        assert_eq!(fault.pointer, "line 3");
    }

    #[test]
    fn long_line_is_refused() {
        let text = format!("0\nSECTION\n1\n{}\n", "a".repeat(70_000));
        let fault = read(&text, &Limits::default()).err().expect("refused");
        assert_eq!(
            (fault.code.as_str(), fault.pointer.as_str()),
            ("pattern/line_too_long", "line 4")
        );
    }
}
