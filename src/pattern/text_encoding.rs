//! Encodings of the texts of a file, by the names that files and people give them.

use encoding_rs::{
    BIG5, EUC_JP, EUC_KR, Encoding, GB18030, GBK, IBM866, KOI8_R, KOI8_U, MACINTOSH, SHIFT_JIS,
    UTF_8, WINDOWS_874, WINDOWS_1250, WINDOWS_1251, WINDOWS_1252, WINDOWS_1253, WINDOWS_1254,
    WINDOWS_1255, WINDOWS_1256, WINDOWS_1257, WINDOWS_1258, X_MAC_CYRILLIC,
};
use oem_cp::code_table::DECODING_TABLE_CP_MAP;
use serde::Deserialize;
use std::borrow::Cow;

/// Words before the number of a code page: `ANSI_1251`, `cp866`, `DOS850`, `windows-1251`.
const PAGE_WORDS: [&str; 9] = [
    "ansi", "cp", "codepage", "dos", "ibm", "ms", "oem", "windows", "",
];

/// Encodings whose characters take two bytes or more.
const WIDE: [&Encoding; 6] = [BIG5, EUC_JP, EUC_KR, GB18030, GBK, SHIFT_JIS];

/// The encoding of the texts of a file. All of them write ASCII as such.
///
/// It is read from a label of the Encoding Standard (`windows-1251`, `shift_jis`, `gbk`, `utf-8`)
/// or a code page of DOS or Windows (`ANSI_1251`, `cp866`, `DOS850`), in any case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct TextEncoding(Table);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Table {
    /// An encoding of the Encoding Standard.
    Standard(&'static Encoding),
    /// A code page of DOS that the standard does not have.
    Dos(u16),
}

/// A label that names no encoding.
#[derive(Debug, thiserror::Error)]
#[error(
    "unknown encoding {0:?}: give a label of the Encoding Standard (windows-1251, shift_jis, gbk, \
     utf-8) or a code page (ANSI_1251, cp866, DOS850)"
)]
pub struct UnknownEncoding(String);

impl TryFrom<String> for TextEncoding {
    type Error = UnknownEncoding;

    fn try_from(label: String) -> Result<Self, UnknownEncoding> {
        let short = || label.chars().take(40).collect();
        Self::for_label(&label).ok_or_else(|| UnknownEncoding(short()))
    }
}

impl TextEncoding {
    /// UTF-8.
    pub(crate) const UTF_8: Self = Self(Table::Standard(UTF_8));
    /// Windows-1252, of Western Europe.
    pub(crate) const WINDOWS_1252: Self = Self(Table::Standard(WINDOWS_1252));
    /// GBK, of China.
    pub(crate) const GBK: Self = Self(Table::Standard(GBK));

    /// Returns the encoding that a label names.
    pub fn for_label(label: &str) -> Option<Self> {
        let label = label.trim().to_ascii_lowercase();
        let tight = label.replace(['-', '_', ' '], "");
        if let Some(page) = by_page(&tight) {
            return Some(page);
        }
        let found = Encoding::for_label(label.as_bytes())
            .or_else(|| Encoding::for_label(label.replace('_', "-").as_bytes()))
            .or_else(|| by_other_name(&tight))
            .filter(|encoding| encoding.is_ascii_compatible())?;
        Some(Self(Table::Standard(found)))
    }

    /// Returns the encoding of a code page of DOS or Windows.
    pub(crate) fn for_code_page(page: u16) -> Option<Self> {
        let standard = match page {
            866 => IBM866,
            874 => WINDOWS_874,
            932 => SHIFT_JIS,
            936 => GBK,
            949 => EUC_KR,
            950 => BIG5,
            1250 => WINDOWS_1250,
            1251 => WINDOWS_1251,
            1252 => WINDOWS_1252,
            1253 => WINDOWS_1253,
            1254 => WINDOWS_1254,
            1255 => WINDOWS_1255,
            1256 => WINDOWS_1256,
            1257 => WINDOWS_1257,
            1258 => WINDOWS_1258,
            10000 => MACINTOSH,
            10007 => X_MAC_CYRILLIC,
            20866 => KOI8_R,
            20932 | 51932 => EUC_JP,
            21866 => KOI8_U,
            51949 => EUC_KR,
            54936 => GB18030,
            65001 => UTF_8,
            _ => {
                let is_known = DECODING_TABLE_CP_MAP.contains_key(&page);
                return is_known.then_some(Self(Table::Dos(page)));
            }
        };
        Some(Self(Table::Standard(standard)))
    }

    /// Returns a label that names it.
    pub(crate) fn name(self) -> Cow<'static, str> {
        match self.0 {
            Table::Standard(encoding) => encoding.name().to_ascii_lowercase().into(),
            Table::Dos(page) => format!("cp{page}").into(),
        }
    }

    /// Returns true if its characters take two bytes or more.
    pub(crate) fn is_wide(self) -> bool {
        matches!(self.0, Table::Standard(encoding) if WIDE.contains(&encoding))
    }

    /// Returns the text that bytes stand for; those that mean nothing become U+FFFD.
    pub(crate) fn decode(self, bytes: &[u8]) -> Cow<'_, str> {
        match self.0 {
            Table::Standard(encoding) => encoding.decode_without_bom_handling(bytes).0,
            Table::Dos(page) => match DECODING_TABLE_CP_MAP.get(&page) {
                Some(table) => table.decode_string_lossy(bytes).into(),
                None => String::from_utf8_lossy(bytes),
            },
        }
    }

    /// Returns the text that bytes stand for, if all of them mean something: none a control
    /// character beyond ASCII, which tables have in the place of nothing.
    pub(crate) fn decode_whole(self, bytes: &[u8]) -> Option<Cow<'_, str>> {
        let is_nothing =
            |c: char| c == char::REPLACEMENT_CHARACTER || ('\u{80}'..='\u{9f}').contains(&c);
        Some(self.decode(bytes)).filter(|text| !text.contains(is_nothing))
    }

    /// Returns true if it has a character. GB 18030 has all of Unicode: it is asked for those of
    /// GBK, which texts are written in.
    pub(crate) fn has(self, c: char) -> bool {
        let mut utf8 = [0; 4];
        match self.0 {
            Table::Standard(encoding) => {
                let encoding = if encoding == GB18030 { GBK } else { encoding };
                !encoding.encode(c.encode_utf8(&mut utf8)).2
            }
            Table::Dos(_) => (0..=u8::MAX).any(|byte| self.decode(&[byte]).starts_with(c)),
        }
    }
}

/// Returns the encoding of a label that is a number after a word for code pages, without hyphens.
fn by_page(label: &str) -> Option<TextEncoding> {
    let word = label.trim_end_matches(|c: char| c.is_ascii_digit());
    let page = label[word.len()..].parse().ok()?;
    PAGE_WORDS
        .contains(&word)
        .then(|| TextEncoding::for_code_page(page))?
}

/// Returns the encoding of a label that the standard does not have, without hyphens.
fn by_other_name(label: &str) -> Option<&'static Encoding> {
    match label {
        "macroman" => return Some(MACINTOSH),
        "maccyrillic" => return Some(X_MAC_CYRILLIC),
        "eucjp" => return Some(EUC_JP),
        "euckr" => return Some(EUC_KR),
        "koi8r" => return Some(KOI8_R),
        "koi8u" => return Some(KOI8_U),
        _ => {}
    }
    let number = label.strip_prefix("iso").unwrap_or(label);
    let part = number.strip_prefix("8859")?;
    Encoding::for_label(format!("iso-8859-{part}").as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_known_by_all_their_names() {
        for (labels, name) in [
            (
                "ANSI_1251 ansi_1251 windows-1251 cp1251 CP-1251",
                "windows-1251",
            ),
            ("DOS866 ibm866 cp866 866", "ibm866"),
            ("ANSI_932 dos932 Shift_JIS sjis ms932", "shift_jis"),
            ("ANSI_936 GB2312 GBK gb_2312-80", "gbk"),
            ("ansi_949 KSC5601 euc-kr", "euc-kr"),
            ("ANSI_950 BIG5", "big5"),
            ("ANSI_874 dos874", "windows-874"),
            (
                "8859_2 ISO8859-2 iso-8859-2 ISO_8859_2 iso88592",
                "iso-8859-2",
            ),
            ("mac-roman MACINTOSH", "macintosh"),
            ("KOI8 KOI8-R koi8r", "koi8-r"),
            ("UTF-8 utf8 UTF_8 cp65001", "utf-8"),
            ("DOS850 cp850 IBM850 oem850", "cp850"),
            ("dos437", "cp437"),
        ] {
            for label in labels.split(' ') {
                let found = TextEncoding::for_label(label).map(TextEncoding::name);
                assert_eq!(found.as_deref(), Some(name), "{label}");
            }
        }
    }

    #[test]
    fn what_is_no_superset_of_ascii_or_unknown_is_refused() {
        for label in [
            "",
            "ansi",
            "ANSI_1361",
            "johab",
            "utf-16",
            "iso-2022-jp",
            "iso-2022-kr",
            "ansi_1200",
            "ell",
            "cp99999",
            "8859",
        ] {
            assert_eq!(TextEncoding::for_label(label), None, "{label}");
        }
    }

    #[test]
    fn pages_of_dos_are_decoded() {
        let page = TextEncoding::for_code_page(850).expect("a page");
        assert_eq!(page.decode(b"Gr\x94\xe1e"), "Größe");
        assert!(page.has('ß') && !page.has('Ж'));
    }
}
