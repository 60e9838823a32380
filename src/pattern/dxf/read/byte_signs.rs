//! Signs by which bytes tell of their encoding.

use crate::pattern::TextEncoding;

/// Returns GBK where every pair of high bytes is a common Chinese character, else Windows-1252.
pub(super) fn guess(bytes: &[u8]) -> TextEncoding {
    if looks_like_gbk(bytes) {
        TextEncoding::GBK
    } else {
        TextEncoding::WINDOWS_1252
    }
}

/// Returns true if at least as many characters beyond ASCII are UTF-8 as bytes are not.
pub(super) fn is_mostly_utf8(bytes: &[u8]) -> bool {
    let (mut right, mut wrong) = (0_usize, 0_usize);
    for chunk in bytes.utf8_chunks() {
        right += chunk.valid().chars().filter(|c| !c.is_ascii()).count();
        wrong += usize::from(!chunk.invalid().is_empty());
    }
    right >= wrong
}

/// Returns true if text that is valid UTF-8 must be of the page that its header says all the same:
/// pairs of bytes of East Asian pages can be UTF-8, of letters that the page does not have.
pub(super) fn is_utf8_by_chance(text: &str, page: TextEncoding) -> bool {
    let mut letters = text.chars().filter(|c| !c.is_ascii());
    page.is_wide()
        && letters.all(|c| ('\u{100}'..'\u{800}').contains(&c) && !page.has(c))
        && page.decode_whole(text.as_bytes()).is_some()
}

/// Returns true if text that is valid UTF-8 must be GBK all the same: some pairs of GBK bytes make
/// up the African and phonetic letters of U+0180..=U+02AF, and a name with nothing but those among
/// its letters beyond ASCII is none.
pub(super) fn is_gbk_by_chance(text: &str) -> bool {
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

/// Returns true if bytes look like GBK and hold two such characters beside each other: in
/// Windows-1252 four signs or capitals, which no word has. Many programs state that of any file.
pub(super) fn is_plainly_gbk(bytes: &[u8]) -> bool {
    let mut runs = bytes.split(u8::is_ascii);
    looks_like_gbk(bytes) && runs.any(|run| run.len() >= 4)
}
