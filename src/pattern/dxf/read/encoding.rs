//! Bytes to text: by the encoding that the caller states, else as UTF-8 where the bytes are, else
//! by the code page of the header, else by a guess; what is not plain is told.

use super::byte_signs::{
    guess, is_gbk_by_chance, is_mostly_utf8, is_plainly_gbk, is_utf8_by_chance,
};
use super::escapes::unescape;
use super::raw_text::{EncodingStatement, ForeignName, first_foreign_name};
use crate::fault::PatternCode;
use crate::pattern::TextEncoding;
use crate::pattern::dxf::findings::{DxfFindings, excerpt};
use std::borrow::Cow;
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

/// Encodings that are offered in the place of one that was taken, by their labels.
const OTHERS: [&str; 9] = [
    "windows-1251",
    "gbk",
    "shift_jis",
    "big5",
    "euc-kr",
    "windows-1252",
    "windows-1250",
    "windows-1254",
    "ibm866",
];

/// At most this many others are offered.
const OFFERED: usize = 3;

/// Decodes a DXF file; bytes that mean nothing in its encoding become U+FFFD, and escapes the
/// characters that they stand for. `wanted`: the encoding, by the caller.
pub(crate) fn decode<'a>(
    bytes: &'a [u8],
    wanted: Option<TextEncoding>,
    findings: &mut DxfFindings,
) -> Cow<'a, str> {
    let text = match (wanted, bytes.strip_prefix(b"\xef\xbb\xbf")) {
        (Some(wanted), stripped) => wanted.decode(stripped.unwrap_or(bytes)),
        (None, Some(stripped)) => String::from_utf8_lossy(stripped),
        (None, None) => decode_by_contents(bytes, findings),
    };
    unescape(composed(text), findings)
}

/// Returns the text with letters and the accents after them as one character each, as names are
/// compared: Windows-1258 has but some letters with their accents.
fn composed(text: Cow<'_, str>) -> Cow<'_, str> {
    if text.is_ascii() || !text.chars().any(is_combining_mark) {
        return text;
    }
    Cow::Owned(text.nfc().collect())
}

fn decode_by_contents<'a>(bytes: &'a [u8], findings: &mut DxfFindings) -> Cow<'a, str> {
    if bytes.is_ascii() {
        return String::from_utf8_lossy(bytes);
    }
    let choice = EncodingChoice::of(bytes);
    if let Some(name) = first_foreign_name(bytes) {
        choice.tell(name, findings);
    }
    choice.taken.decode(bytes)
}

/// The reason for which an encoding was taken, as far as it must be told.
enum ChoiceReason<'a> {
    /// All that the file says agrees.
    Plain,
    /// The file does not say its encoding.
    NotStated,
    /// The header says a page that is not read, in this line.
    UnknownPage(&'a str, usize),
    /// The bytes speak against what the header says; the encoding that it says.
    Contradicted(TextEncoding),
    /// Bytes mean nothing in the encoding that the header says.
    Damaged,
}

/// The encoding that was taken for a file.
struct EncodingChoice<'a> {
    taken: TextEncoding,
    reason: ChoiceReason<'a>,
}

impl<'a> EncodingChoice<'a> {
    /// Chooses the encoding of bytes that are not ASCII.
    fn of(bytes: &'a [u8]) -> Self {
        let statement = EncodingStatement::of(bytes);
        let page = statement
            .page
            .and_then(|(page, _)| TextEncoding::for_label(page));
        let says_utf8 = statement.is_utf8_by_version || page == Some(TextEncoding::UTF_8);
        let page = page.filter(|page| *page != TextEncoding::UTF_8);
        if let Ok(text) = std::str::from_utf8(bytes) {
            return Self::of_utf8(text, page, says_utf8);
        }
        if says_utf8 && is_mostly_utf8(bytes) {
            return Self::new(TextEncoding::UTF_8, ChoiceReason::Damaged);
        }
        match (page, statement.page) {
            (Some(page), _) if page == TextEncoding::WINDOWS_1252 && is_plainly_gbk(bytes) => {
                Self::new(TextEncoding::GBK, ChoiceReason::Contradicted(page))
            }
            (Some(page), _) if says_utf8 => {
                Self::new(page, ChoiceReason::Contradicted(TextEncoding::UTF_8))
            }
            (Some(page), _) if page.decode_whole(bytes).is_none() => {
                Self::new(page, ChoiceReason::Damaged)
            }
            (Some(page), _) => Self::new(page, ChoiceReason::Plain),
            (None, _) if says_utf8 => {
                let reason = ChoiceReason::Contradicted(TextEncoding::UTF_8);
                Self::new(guess(bytes), reason)
            }
            (None, Some((page, line))) => {
                Self::new(guess(bytes), ChoiceReason::UnknownPage(page, line))
            }
            (None, None) => Self::new(guess(bytes), ChoiceReason::NotStated),
        }
    }

    /// Chooses for bytes that are UTF-8, be it by chance.
    fn of_utf8(text: &str, page: Option<TextEncoding>, says_utf8: bool) -> Self {
        if says_utf8 {
            return Self::new(TextEncoding::UTF_8, ChoiceReason::Plain);
        }
        match page {
            Some(page) if is_utf8_by_chance(text, page) => Self::new(page, ChoiceReason::Plain),
            _ if is_gbk_by_chance(text) => match page {
                Some(page) if page != TextEncoding::GBK => {
                    Self::new(TextEncoding::GBK, ChoiceReason::Contradicted(page))
                }
                Some(_) => Self::new(TextEncoding::GBK, ChoiceReason::Plain),
                None => Self::new(TextEncoding::GBK, ChoiceReason::NotStated),
            },
            Some(page) => Self::new(TextEncoding::UTF_8, ChoiceReason::Contradicted(page)),
            None => Self::new(TextEncoding::UTF_8, ChoiceReason::Plain),
        }
    }

    fn new(taken: TextEncoding, reason: ChoiceReason<'a>) -> Self {
        Self { taken, reason }
    }

    /// Warns of a choice that is not plain, with the encodings that could be meant.
    fn tell(&self, name: ForeignName<'_>, findings: &mut DxfFindings) {
        let (code, line, why) = match &self.reason {
            ChoiceReason::Plain => return,
            ChoiceReason::NotStated => (
                PatternCode::EncodingAssumed,
                name.line,
                "the file does not say the code page of its names".to_owned(),
            ),
            ChoiceReason::UnknownPage(page, line) => (
                PatternCode::EncodingUnknown,
                *line,
                format!("$DWGCODEPAGE is {:?}, which is not read", excerpt(page)),
            ),
            ChoiceReason::Contradicted(stated) => (
                PatternCode::EncodingConflict,
                name.line,
                format!(
                    "the header says {}, and the names are not written so",
                    stated.name()
                ),
            ),
            ChoiceReason::Damaged => (
                PatternCode::EncodingConflict,
                name.line,
                format!(
                    "some bytes of the file mean nothing in {}",
                    self.taken.name()
                ),
            ),
        };
        let stated = match self.reason {
            ChoiceReason::Contradicted(stated) => Some(stated),
            _ => None,
        };
        let detail = format!(
            "{why}; {} was taken, {:?} in line {} ({})",
            self.taken.name(),
            excerpt(&self.taken.decode(name.bytes)),
            name.line,
            self.offer(stated, name.bytes)
        );
        findings.warn(code, line, detail);
    }

    /// Returns the encodings in which a name could be meant, `stated` first, with what they would
    /// make of it.
    fn offer(&self, stated: Option<TextEncoding>, name: &[u8]) -> String {
        let others = OTHERS
            .iter()
            .filter_map(|label| TextEncoding::for_label(label));
        let others = others.filter(|other| Some(*other) != stated);
        let mut offers = Vec::new();
        for other in stated.into_iter().chain(others) {
            let read = match other.decode_whole(name) {
                _ if Some(other) == stated => other.decode(name),
                Some(read) if is_of_words(&read) => read,
                _ => continue,
            };
            let is_new = other != self.taken && read != self.taken.decode(name);
            if offers.len() < OFFERED && is_new {
                let (label, read) = (other.name(), excerpt(&read));
                offers.push(format!("encoding={label} would make it {read:?}"));
            }
        }
        if offers.is_empty() {
            offers.push("encoding= overrides".to_owned());
        }
        offers.join(", ")
    }
}

/// Returns true if a text may be a name: letters, digits and signs of ASCII.
fn is_of_words(text: &str) -> bool {
    let is_of_word = |c: char| c.is_alphanumeric() || c.is_ascii() && !c.is_control();
    text.chars().all(is_of_word)
}

#[cfg(test)]
mod tests {
    use super::*;
    use encoding_rs::{EUC_KR, GBK, SHIFT_JIS, WINDOWS_1251, WINDOWS_1252, WINDOWS_1258};

    /// Returns the text of a block named `name`, and the codes of the warnings.
    fn read(header: &str, name: &[u8], wanted: Option<&str>) -> (String, Vec<String>) {
        let head = "0\nSECTION\n2\nHEADER\n".to_owned() + header;
        let mut file = (head + "0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\n").into_bytes();
        file.extend(name);
        let mut findings = DxfFindings::default();
        let wanted = wanted.and_then(TextEncoding::for_label);
        let text = decode(&file, wanted, &mut findings).into_owned();
        let codes = findings.warnings.into_iter().map(|w| w.code.to_string());
        let name = text.lines().last().expect("a name").to_owned();
        (name, codes.collect())
    }

    fn page(page: &str) -> String {
        format!("9\n$DWGCODEPAGE\n3\n{page}\n")
    }

    const ASSUMED: &str = "pattern/encoding_assumed";
    const UNKNOWN: &str = "pattern/encoding_unknown";
    const CONFLICT: &str = "pattern/encoding_conflict";

    #[test]
    fn names_in_stated_encodings_are_read() {
        for (encoding, label, name) in [
            (WINDOWS_1251, "ANSI_1251", "СПИНКА"),
            (SHIFT_JIS, "ansi_932", "後身頃 表"),
            (SHIFT_JIS, "ansi_932", "ﾏｴ"),
            (GBK, "ANSI_936", "前片"),
            (EUC_KR, "ANSI_949", "타"),
            (WINDOWS_1252, "ANSI_1252", "CRÉÉE"),
        ] {
            let (bytes, _, lost) = encoding.encode(name);
            assert!(!lost);
            assert_eq!(read(&page(label), &bytes, None), (name.to_owned(), vec![]));
        }
    }

    #[test]
    fn utf8_is_read_whatever_the_header_says_and_told() {
        for (header, codes) in [(page("ANSI_1251"), vec![CONFLICT]), (page("UTF-8"), vec![])] {
            let (name, told) = read(&header, "СПИНКА".as_bytes(), None);
            assert_eq!(
                (name.as_str(), told),
                ("СПИНКА", codes.iter().map(|c| (*c).into()).collect())
            );
        }
        assert_eq!(
            read("", "Größe É".as_bytes(), None),
            ("Größe É".into(), vec![])
        );
    }

    #[test]
    fn pages_that_are_guessed_or_unknown_are_told() {
        let (gbk, ..) = GBK.encode("前片 后片 袖");
        assert_eq!(
            read("", &gbk, None),
            ("前片 后片 袖".into(), vec![ASSUMED.into()])
        );
        let (latin, ..) = WINDOWS_1252.encode("Größe très été");
        assert_eq!(
            read("", &latin, None),
            ("Größe très été".into(), vec![ASSUMED.into()])
        );
        let told = read(&page("johab"), &latin, None);
        assert_eq!(told, ("Größe très été".into(), vec![UNKNOWN.into()]));
        let told = read(&page("ANSI_1252"), &gbk, None);
        assert_eq!(told, ("前片 后片 袖".into(), vec![CONFLICT.into()]));
        let (bytes, ..) = SHIFT_JIS.encode("前身頃");
        let (name, told) = read(&page("ANSI_1252"), &bytes, None);
        assert_eq!(
            (name.as_str(), told),
            ("‘O\u{90}g\u{8d}\u{a0}", vec![CONFLICT.into()])
        );
        assert_eq!(
            read(&page("ANSI_1252"), &gbk, Some("gbk")).1,
            Vec::<String>::new()
        );
    }

    #[test]
    fn gbk_that_is_valid_utf8_by_chance_is_read_as_gbk() {
        let (gbk, ..) = GBK.encode("前片");
        assert!(std::str::from_utf8(&gbk).is_ok());
        assert_eq!(read("", &gbk, None).0, "前片");
    }

    #[test]
    fn damaged_utf8_stays_utf8_and_a_page_in_a_late_file_is_read() {
        let late = "9\n$ACADVER\n1\nAC1021\n".to_owned();
        let (name, told) = read(&late, b"\xc3\xa9t\xc3\xa9 \xe9", None);
        assert_eq!(
            (name.as_str(), told),
            ("été \u{fffd}", vec![CONFLICT.to_owned()])
        );
        let (bytes, ..) = WINDOWS_1251.encode("ПЕРЕД");
        let told = read(&(late + &page("ANSI_1251")), &bytes, None);
        assert_eq!(told, ("ПЕРЕД".into(), vec![CONFLICT.into()]));
    }

    #[test]
    fn accents_are_joined_to_their_letters() {
        let (bytes, ..) = WINDOWS_1258.encode("TRƯƠ\u{301}C");
        assert_eq!(read(&page("ANSI_1258"), &bytes, None).0, "TRƯỚC");
    }

    #[test]
    fn byte_order_mark_is_skipped() {
        let mut findings = DxfFindings::default();
        assert_eq!(decode(b"\xef\xbb\xbf0", None, &mut findings), "0");
    }
}
