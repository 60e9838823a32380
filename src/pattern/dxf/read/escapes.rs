//! The escapes by which files write the characters that their code page lacks: `\U+XXXX` of
//! Unicode, and `\M+nXXXX` of a code page of East Asia.

use crate::fault::PatternCode;
use crate::pattern::TextEncoding;
use crate::pattern::dxf::findings::DxfFindings;
use std::borrow::Cow;

/// The code pages of `\M+n`, by n; 1361 is Johab.
const PAGES: [(char, u16); 5] = [('1', 932), ('2', 950), ('3', 949), ('4', 1361), ('5', 936)];

/// Replaces the escapes in the text of a file; those of a page that is not read are warned of.
pub(super) fn unescape<'a>(text: Cow<'a, str>, findings: &mut DxfFindings) -> Cow<'a, str> {
    let is_escape = |at: usize| text.as_bytes().get(at + 2) == Some(&b'+');
    if !text.match_indices('\\').any(|(at, _)| is_escape(at)) {
        return text;
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = &*text;
    let mut unread = None;
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let (c, length) = escaped(rest).unwrap_or(('\\', 1));
        if length == 1 && is_of_unread_page(rest) {
            unread.get_or_insert((0, text.len() - rest.len())).0 += 1;
        }
        out.push(c);
        rest = &rest[length..];
    }
    out.push_str(rest);
    if let Some((count, at)) = unread {
        warn_of_unread(&text[..at], count, findings);
    }
    Cow::Owned(out)
}

fn warn_of_unread(before: &str, count: usize, findings: &mut DxfFindings) {
    let line = 1 + before.matches('\n').count();
    let detail = format!(
        "{count} characters are written as \\M+4XXXX, of the code page Johab, which is not read; they \
         stand in the names as written, the first here; write them as \\U+XXXX, or the file as UTF-8"
    );
    findings.warn(PatternCode::EncodingUnknown, line, detail);
}

/// Returns the character of the escape that a text begins with, and the length of the escape.
/// Control characters, which would break a line, are not read.
fn escaped(text: &str) -> Option<(char, usize)> {
    let found = match text.as_bytes().get(1)? {
        b'U' | b'u' => of_unicode(text),
        b'M' | b'm' => of_page(text),
        _ => None,
    };
    found.filter(|(c, _)| !c.is_control())
}

/// Reads `\U+XXXX`; two of them where a character takes a pair of UTF-16 surrogates.
fn of_unicode(text: &str) -> Option<(char, usize)> {
    let unit = |from: usize| {
        let escape = text.get(from..from + 7)?;
        let is_unicode = escape.get(..3)?.eq_ignore_ascii_case("\\U+");
        hex(&escape[3..]).filter(|_| is_unicode)
    };
    let first = unit(0)?;
    match char::from_u32(first.into()) {
        Some(c) => Some((c, 7)),
        None => Some((char::decode_utf16([first, unit(7)?]).next()?.ok()?, 14)),
    }
}

/// Reads `\M+nXXXX`.
fn of_page(text: &str) -> Option<(char, usize)> {
    let encoding = TextEncoding::for_code_page(page(text)?)?;
    let bytes = hex(text.get(4..8)?)?.to_be_bytes();
    let bytes = if bytes[0] == 0 { &bytes[1..] } else { &bytes };
    let decoded = encoding.decode_whole(bytes)?;
    let mut chars = decoded.chars();
    let c = chars.next()?;
    chars.next().is_none().then_some((c, 8))
}

/// Returns the code page of `\M+n`.
fn page(text: &str) -> Option<u16> {
    let is_escape = text.get(..3)?.eq_ignore_ascii_case("\\M+");
    let n = text.get(3..)?.chars().next()?;
    let found = PAGES.iter().find(|(digit, _)| *digit == n);
    found.filter(|_| is_escape).map(|(_, page)| *page)
}

/// Returns true if a text begins with `\M+nXXXX` of a page that is not read.
fn is_of_unread_page(text: &str) -> bool {
    let is_unread = page(text).is_some_and(|page| TextEncoding::for_code_page(page).is_none());
    is_unread && text.get(4..8).and_then(hex).is_some()
}

fn hex(digits: &str) -> Option<u16> {
    let is_hex = digits.bytes().all(|b| b.is_ascii_hexdigit());
    u16::from_str_radix(digits, 16).ok().filter(|_| is_hex)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unescaped(text: &str) -> (String, usize) {
        let mut findings = DxfFindings::default();
        let text = unescape(text.into(), &mut findings).into_owned();
        (text, findings.warnings.len())
    }

    #[test]
    fn characters_of_unicode_are_read() {
        assert_eq!(unescaped("\\U+524D\\U+7247 \\u+00e9").0, "前片 é");
        assert_eq!(unescaped("\\U+D83D\\U+DC57.").0, "\u{1f457}.");
        for plain in [
            "C:\\U+12",
            "\\U+000A",
            "\\U+D83D.",
            "\\U+0x1F",
            "\\\\U",
            "\\",
        ] {
            assert_eq!(unescaped(plain), (plain.to_owned(), 0));
        }
    }

    #[test]
    fn characters_of_code_pages_are_read() {
        let pages = "\\M+1914F\\M+2AB65\\M+3BED5\\M+5C7B0 \\m+1b1";
        assert_eq!(unescaped(pages), ("前前앞前 \\m+1b1".into(), 0));
    }

    #[test]
    fn characters_of_johab_stay_and_are_told() {
        assert_eq!(
            unescaped("\\M+4B1A1 \\M+4B1A1"),
            ("\\M+4B1A1 \\M+4B1A1".into(), 1)
        );
    }
}
