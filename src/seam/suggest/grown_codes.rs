//! Codes of several parts grown together: a kind or a place of the garment, then front or back,
//! then left or right, as `SKF`, `BDB`, `CUFL`.

use super::labels::PanelKind;
use super::vocabulary::{Entry, Meaning};

/// Longest code of several parts, in letters.
const MAX_CODE: usize = 6;
/// Longest code, in letters, that may have grown together with what stands before it.
const MAX_GROWN: usize = 4;

/// Codes of front and back that are not a letter and another one.
const WHOLE: [&str; 2] = ["fr", "bk"];
/// Endings of a code that say front or back.
const DEPTHS: [(&str, Meaning); 4] = [
    ("f", Meaning::Front),
    ("fr", Meaning::Front),
    ("b", Meaning::Back),
    ("bk", Meaning::Back),
];
/// Endings of a code that say left or right.
const SIDES: [(&str, Meaning); 7] = [
    ("l", Meaning::Left),
    ("lh", Meaning::Left),
    ("lt", Meaning::Left),
    ("r", Meaning::Right),
    ("rh", Meaning::Right),
    ("rt", Meaning::Right),
    ("rgt", Meaning::Right),
];

/// Returns the meanings of a word that is a beginning and a place; nothing where it is not.
///
/// Codes of two letters are not taken apart: `SKFR` is the front of a skirt, and `SFR` the front of
/// a style S, neither the right one of `SF`.
pub(super) fn parts(beginnings: &[Entry], word: &str) -> Vec<Meaning> {
    if word.chars().count() > MAX_CODE {
        return vec![];
    }
    let last = WHOLE.into_iter().find(|code| word.ends_with(code));
    let place = |start: &String| {
        let rest = word.strip_prefix(start.as_str())?;
        let is_whole = |part: &str| last.is_none_or(|code| part.ends_with(code));
        places(rest).filter(|_| is_whole(rest) || is_whole(start))
    };
    let begins = |entry: &Entry| -> Option<Vec<Meaning>> {
        let places = entry.words.iter().find_map(place)?;
        Some([vec![entry.means], places].concat())
    };
    beginnings.iter().filter_map(begins).flatten().collect()
}

/// Returns the places that letters say: front or back, left or right, or both; nothing where they
/// say anything else.
fn places(letters: &str) -> Option<Vec<Meaning>> {
    let of = |table: &[(&str, Meaning)], text: &str| {
        let mut all = table.iter();
        all.find(|(ending, _)| *ending == text).map(|found| found.1)
    };
    if letters.is_empty() {
        return Some(vec![]);
    }
    let one = of(&DEPTHS, letters).or_else(|| of(&SIDES, letters));
    if let Some(one) = one {
        return Some(vec![one]);
    }
    DEPTHS.iter().find_map(|(ending, depth)| {
        let side = of(&SIDES, letters.strip_prefix(ending)?)?;
        Some(vec![*depth, side])
    })
}

/// Returns the meaning of a code grown together with a name before it: `RACERBK` after `RACE`.
pub(super) fn ending(word: &str) -> Option<Meaning> {
    let ends = |code: &str| word.chars().count() <= MAX_GROWN && word.ends_with(code);
    match () {
        () if ends("fr") => Some(Meaning::Front),
        () if ends("bk") => Some(Meaning::Back),
        () if ends("co") => Some(Meaning::KindIfOnly(PanelKind::Collar)),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_after_the_letter_of_a_style_is_no_right_side() {
        let sides = [Entry {
            words: ["sf", "sb"].map(str::to_owned).to_vec(),
            means: Meaning::KindIfOnly(PanelKind::Side),
        }];
        assert_eq!(parts(&sides, "sfr"), []);
        let skirt = [Entry {
            words: vec!["sk".to_owned()],
            means: Meaning::Kind(PanelKind::Skirt),
        }];
        assert_eq!(parts(&skirt, "skfr"), [skirt[0].means, Meaning::Front]);
        assert_eq!(ending("sfr"), Some(Meaning::Front));
        assert_eq!(parts(&sides, "sfl"), [sides[0].means, Meaning::Left]);
    }
}
