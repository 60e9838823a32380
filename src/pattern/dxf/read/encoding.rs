//! Bytes to text: UTF-8, GBK or Windows-1252, since DXF before 2007 does not reliably say which.

use encoding_rs::{Encoding, GBK, UTF_8, WINDOWS_1252};
use std::borrow::Cow;

/// Decodes a DXF file; bytes that mean nothing in its encoding become U+FFFD, and `\U+XXXX` the
/// character that it stands for.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    unescape(decode_bytes(bytes))
}

fn decode_bytes(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) if !is_gbk_by_chance(text) => Cow::Borrowed(text),
        _ => Cow::Owned(
            encoding_of(bytes)
                .decode_without_bom_handling(bytes)
                .0
                .into_owned(),
        ),
    }
}

/// Replaces `\U+XXXX`, by which files write the characters that their code page lacks.
fn unescape(text: Cow<'_, str>) -> Cow<'_, str> {
    const ESCAPE: &str = "\\U+";
    if !text.contains(ESCAPE) {
        return text;
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = &*text;
    while let Some(at) = rest.find(ESCAPE) {
        out.push_str(&rest[..at]);
        let (c, length) = escaped(&rest[at..]).unwrap_or(('\\', 1));
        out.push(c);
        rest = &rest[at + length..];
    }
    out.push_str(rest);
    Cow::Owned(out)
}

/// Returns the character of the escape that a text begins with, and the length of the escape; two
/// where the character takes a pair of UTF-16 surrogates. Control characters, which would break a
/// line, are not read.
fn escaped(text: &str) -> Option<(char, usize)> {
    let unit = |from: usize| {
        let digits = text.get(from..from + 7)?.strip_prefix("\\U+")?;
        let is_hex = digits.bytes().all(|b| b.is_ascii_hexdigit());
        u16::from_str_radix(digits, 16).ok().filter(|_| is_hex)
    };
    let first = unit(0)?;
    let found = match char::from_u32(first.into()) {
        Some(c) => (c, 7),
        None => (char::decode_utf16([first, unit(7)?]).next()?.ok()?, 14),
    };
    Some(found).filter(|(c, _)| !c.is_control())
}

/// Returns the encoding of bytes that are not UTF-8: what the header says, else GBK where every
/// pair of high bytes is a common Chinese character, else Windows-1252.
fn encoding_of(bytes: &[u8]) -> &'static Encoding {
    let head = &bytes[..bytes.len().min(20_000)];
    if header_value(head, b"$ACADVER").is_some_and(|v| v >= b"AC1021".as_slice()) {
        return UTF_8;
    }
    match header_value(head, b"$DWGCODEPAGE").map(<[u8]>::to_ascii_uppercase) {
        Some(page) if page.ends_with(b"936") || page.starts_with(b"GB") => return GBK,
        Some(page) if page.ends_with(b"UTF-8") || page.ends_with(b"UTF8") => return UTF_8,
        _ => {}
    }
    if looks_like_gbk(bytes) {
        GBK
    } else {
        WINDOWS_1252
    }
}

/// Returns the value two lines after a header variable's name.
fn header_value<'a>(head: &'a [u8], name: &[u8]) -> Option<&'a [u8]> {
    let mut lines = head.split(|b| *b == b'\n').map(<[u8]>::trim_ascii);
    lines.find(|line| *line == name)?;
    lines.nth(1)
}

/// Returns true if text that is valid UTF-8 must be GBK all the same: some pairs of GBK bytes make
/// up the African and phonetic letters of U+0180..=U+02AF, and a name with nothing but those among
/// its letters beyond ASCII is none.
fn is_gbk_by_chance(text: &str) -> bool {
    let mut letters = text.chars().filter(|c| !c.is_ascii()).peekable();
    letters.peek().is_some()
        && letters.all(|c| ('\u{180}'..='\u{2af}').contains(&c))
        && looks_like_gbk(text.as_bytes())
}

/// Returns true if all high bytes come in pairs whose first byte opens a row of the 3755 common
/// characters of GB 2312 (0xB0..=0xD7). In Windows-1252 those bytes are signs and capitals, which
/// hardly ever come only in pairs.
fn looks_like_gbk(bytes: &[u8]) -> bool {
    let mut common = 0_usize;
    let mut other = 0_usize;
    let mut rest = bytes;
    while let Some(at) = rest.iter().position(|b| !b.is_ascii()) {
        let Some(&[lead, trail]) = rest.get(at..at + 2) else {
            return false;
        };
        if trail < 0x40 {
            return false;
        }
        if (0xb0..=0xd7).contains(&lead) && trail >= 0xa1 {
            common += 1;
        } else {
            other += 1;
        }
        rest = &rest[at + 2..];
    }
    common > 3 * other
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_each_encoding_are_read() {
        let (gbk, ..) = GBK.encode("前片 后片 袖");
        assert_eq!(decode(&gbk), "前片 后片 袖");
        assert_eq!(decode("Größe É".as_bytes()), "Größe É");
        let (latin, ..) = WINDOWS_1252.encode("Größe très été");
        assert_eq!(decode(&latin), "Größe très été");
    }

    #[test]
    fn gbk_that_is_valid_utf8_by_chance_is_read_as_gbk() {
        let (gbk, ..) = GBK.encode("前片");
        assert!(std::str::from_utf8(&gbk).is_ok());
        assert_eq!(decode(&gbk), "前片");
    }

    #[test]
    fn escaped_characters_are_read() {
        assert_eq!(decode(b"\\U+524D\\U+7247 \\U+00e9"), "前片 é");
        assert_eq!(decode(b"\\U+D83D\\U+DC57."), "\u{1f457}.");
        for plain in ["C:\\U+12", "\\U+000A", "\\U+D83D.", "\\U+0x1F", "\\\\U"] {
            assert_eq!(decode(plain.as_bytes()), plain);
        }
    }

    #[test]
    fn byte_order_mark_is_skipped() {
        assert_eq!(decode(b"\xef\xbb\xbf0"), "0");
    }
}
