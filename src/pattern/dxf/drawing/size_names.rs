//! Names of sizes: numbers, and letters from XXS to 10XL.

/// The largest number that is a size: the height of a tall child \[cm\].
const LARGEST: u32 = 200;

/// Returns the place of a size among others of its kind; `None` for what is no name of a size.
/// Letters come before numbers.
pub(crate) fn size_order(name: &str) -> Option<(bool, i64)> {
    let upper = name.trim().to_uppercase();
    let word = upper.strip_prefix("SIZE").unwrap_or(&upper).trim();
    let number = word.parse::<u32>().ok().filter(|n| *n <= LARGEST);
    number
        .map(|n| (true, i64::from(n)))
        .or_else(|| letters(word).map(|place| (false, place)))
}

/// Returns the steps from medium of a size by letters, as `XS`, `XXL` or `3XL`.
fn letters(word: &str) -> Option<i64> {
    let start = word.trim_end_matches(['S', 'M', 'L']);
    let end = &word[start.len()..];
    let digits = start.trim_end_matches('X');
    let marks = start.len() - digits.len();
    let times = match digits.parse::<usize>() {
        Ok(count) if marks == 1 && count <= 10 => count,
        Err(_) if digits.is_empty() && marks <= 6 => marks,
        _ => return None,
    };
    let steps = i64::try_from(times).ok()?;
    match end {
        "S" => Some(-1 - steps),
        "M" if times == 0 => Some(0),
        "L" => Some(1 + steps),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_in_order_and_words_are_none() {
        let places: Vec<_> = ["2XS", "XS", "s", "M", "L", "XL", "XXL", "3XL"]
            .map(|name| size_order(name).expect("a size"))
            .to_vec();
        assert!(
            places.windows(2).all(|pair| pair[0] < pair[1]),
            "{places:?}"
        );
        assert_eq!(size_order("Size 38"), Some((true, 38)));
        for word in ["", "0.5", "CUT", "X", "XM", "SM", "2024", "-4", "LL"] {
            assert_eq!(size_order(word), None, "{word}");
        }
    }
}
