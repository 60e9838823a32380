//! The number of a piece that is cut, as pattern makers write it.

use crate::pattern::Quantity;

/// A larger number is not a count of pieces.
const MOST: u32 = 100;

/// Reads the value of a label: `2`, `1,1`, `1 pair`, `L1 R1`, `2 on fold`.
pub(super) fn from_value(value: &str) -> Option<Quantity> {
    let words = words(value);
    sides(&words)
        .or_else(|| pairs(&words))
        .or_else(|| counts(value))
}

/// Reads a note by itself: it must say that it is about cutting (`Cut 2`, `CUT 1 PAIR`, `x2`, `2x`,
/// `L1 R1`, `1 pair`, `qty 2`), or else a number would be one.
pub(super) fn from_note(note: &str) -> Option<Quantity> {
    let words = words(note);
    let number = |i: usize| words.get(i).and_then(|w| count(w));
    let says = |i: usize, list: &[&str]| words.get(i).is_some_and(|w| list.contains(&w.as_str()));
    if let Some(found) = sides(&words).or_else(|| pairs(&words)) {
        return Some(found);
    }
    let left = match words.len() {
        1 => times(&words[0]),
        2 if says(0, &["x"]) => number(1),
        2 if says(1, &["x", "pcs", "pieces", "times"]) => number(0),
        _ => None,
    };
    let cut = says(0, &["cut", "qty", "quantity", "schneiden"]).then(|| {
        let by = words.get(1).and_then(|w| count(w).or_else(|| times(w)));
        by.or_else(|| says(1, &["x"]).then(|| number(2)).flatten())
    });
    let left = left.or(cut.flatten())?;
    if says(words.len() - 1, &["mirrored", "mirror", "opposite"]) && left.is_multiple_of(2) {
        return Some(Quantity {
            left: left / 2,
            right: left / 2,
        });
    }
    Some(Quantity { left, right: 0 })
}

/// Splits a text into lower-case words and numbers: `L1/R1` is `l`, `1`, `r`, `1`, but `x2` stays
/// whole.
fn words(text: &str) -> Vec<String> {
    let lower = text.to_lowercase();
    let split = lower.split(|c: char| !c.is_alphanumeric());
    split.filter(|w| !w.is_empty()).map(str::to_owned).collect()
}

fn count(word: &str) -> Option<u32> {
    word.parse().ok().filter(|n| *n <= MOST)
}

/// Reads `x2` or `2x`.
fn times(word: &str) -> Option<u32> {
    count(word.strip_prefix('x').or_else(|| word.strip_suffix('x'))?)
}

/// Reads `L1 R1`, `left 1 right 1`, `1 left, 1 right`, after an optional `cut`.
fn sides(words: &[String]) -> Option<Quantity> {
    let words = words.strip_prefix(&["cut".to_owned()]).unwrap_or(words);
    let side = |name: &str| {
        let long = if name == "l" { "left" } else { "right" };
        let tight = words.iter().find_map(|w| count(w.strip_prefix(name)?));
        let at = words.iter().position(|w| w == name || w == long);
        let beside = || at.and_then(|i| words.get(i + 1).and_then(|w| count(w)));
        let before = || at.and_then(|i| count(words.get(i.checked_sub(1)?)?));
        let first = words.first().is_some_and(|w| count(w).is_some());
        tight.or_else(|| if first { before() } else { beside() })
    };
    Some(Quantity {
        left: side("l")?,
        right: side("r")?,
    })
}

/// Reads `1 pair`, `2 pairs`, `cut 1 pair`, `pair`.
fn pairs(words: &[String]) -> Option<Quantity> {
    let words = words.strip_prefix(&["cut".to_owned()]).unwrap_or(words);
    let is_pair = |w: &String| matches!(w.as_str(), "pair" | "pairs" | "pr");
    let n = match words {
        [only] if is_pair(only) => 1,
        [number, pair, ..] if is_pair(pair) => count(number)?,
        [a, pair, ..] if a == "a" && is_pair(pair) => 1,
        _ => return None,
    };
    Some(Quantity { left: n, right: n })
}

/// Reads `2`, `1,1`, `1+1`, `2 on fold`.
fn counts(value: &str) -> Option<Quantity> {
    let mut parts = value.split([',', '+', '/', ';']).map(|part| {
        let digits: String = part
            .trim()
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        count(&digits)
    });
    Some(Quantity {
        left: parts.next()??,
        right: parts.next().flatten().unwrap_or(0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(found: Option<Quantity>) -> Option<(u32, u32)> {
        found.map(|q| (q.left, q.right))
    }

    #[test]
    fn labels_say_how_many_in_many_ways() {
        for (text, wanted) in [
            ("2", (2, 0)),
            ("1,1", (1, 1)),
            ("1 + 1", (1, 1)),
            ("1 pair", (1, 1)),
            ("L1 R2", (1, 2)),
            ("1 on fold", (1, 0)),
        ] {
            assert_eq!(pair(from_value(text)), Some(wanted), "{text}");
        }
        assert_eq!(from_value("many"), None);
    }

    #[test]
    fn notes_say_how_many_only_where_they_are_about_it() {
        for (text, wanted) in [
            ("cut 2", (2, 0)),
            ("CUT 1 PAIR", (1, 1)),
            ("Cut 1 on fold", (1, 0)),
            ("Cut x4", (4, 0)),
            ("cut 2 mirrored", (1, 1)),
            ("x2", (2, 0)),
            ("2 x", (2, 0)),
            ("L1 R1", (1, 1)),
            ("Cut left 1, right 1", (1, 1)),
            ("1 left, 1 right", (1, 1)),
            ("Qty 3", (3, 0)),
        ] {
            assert_eq!(pair(from_note(text)), Some(wanted), "{text}");
        }
        for text in [
            "2",
            "Front 2",
            "Size 38",
            "front left",
            "XL",
            "cut here",
            "L2",
            "",
        ] {
            assert_eq!(from_note(text), None, "{text}");
        }
    }
}
