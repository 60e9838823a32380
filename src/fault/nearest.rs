//! The name nearest to a misspelled one.

/// Characters of the longest name that is compared: the work grows with the square of the length.
const MAX_CHARS: usize = 64;

/// Returns the candidate with the smallest edit distance to `name`, if that is at most a third of
/// the characters of `name`, rounded up. Case does not count.
pub(crate) fn nearest<'a>(
    name: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let name = name.to_lowercase();
    let length = name.chars().count();
    if length > MAX_CHARS {
        return None;
    }
    candidates
        .filter(|candidate| candidate.chars().count() <= MAX_CHARS)
        .map(|candidate| {
            let distance = strsim::levenshtein(&name, &candidate.to_lowercase());
            (distance, candidate)
        })
        .filter(|(distance, _)| *distance <= length.div_ceil(3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn nearest_name_is_found_only_when_it_is_near() {
        let names = ["front", "back", "waistband"];
        let nearest_name = |name| nearest(name, names.iter().copied());
        assert_eq!(nearest_name("fornt"), Some("front"));
        assert_eq!(nearest_name("BACK"), Some("back"));
        assert_eq!(nearest_name("waist-band"), Some("waistband"));
        assert_eq!(
            nearest("edge_lenght_m", ["step_s", "edge_length_m"].into_iter()),
            Some("edge_length_m")
        );
        assert_eq!(nearest_name("sleeve"), None);
        assert_eq!(nearest_name("colour"), None);
        assert_eq!(nearest_name(""), None);
        assert_eq!(nearest_name(&"f".repeat(10_000)), None);
    }
}
