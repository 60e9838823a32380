//! The name nearest to a misspelt one.

/// Names longer than this are not compared: the work grows with the square of the length.
const LONGEST: usize = 64;

/// The candidate with the fewest letters to change, if those are about a third of `name` or fewer (two swapped letters count as two). Case does not count.
pub(crate) fn nearest<'a>(
    name: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let name: Vec<char> = name.to_lowercase().chars().collect();
    if name.len() > LONGEST {
        return None;
    }
    let allowed = name.len().div_ceil(3);
    candidates
        .filter(|candidate| candidate.chars().count() <= LONGEST)
        .map(|candidate| {
            let letters: Vec<char> = candidate.to_lowercase().chars().collect();
            (distance(&name, &letters), candidate)
        })
        .filter(|(changes, _)| *changes <= allowed)
        .min_by_key(|(changes, _)| *changes)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein distance: letters to put in, take out or change.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn nearest_name_is_found_only_when_it_is_near() {
        let names = ["front", "back", "waistband"];
        let ask = |name| nearest(name, names.iter().copied());
        assert_eq!(ask("fornt"), Some("front"));
        assert_eq!(ask("BACK"), Some("back"));
        assert_eq!(ask("waist-band"), Some("waistband"));
        assert_eq!(
            nearest("edge_lenght_m", ["step_s", "edge_length_m"].into_iter()),
            Some("edge_length_m")
        );
        assert_eq!(ask("sleeve"), None);
        assert_eq!(ask("colour"), None);
        assert_eq!(ask(""), None);
        assert_eq!(ask(&"f".repeat(10_000)), None);
    }
}
