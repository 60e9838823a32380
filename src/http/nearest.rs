//! The known name that a misspelt one was most likely meant as.

/// The nearest of `known` to `name`, if it is near enough to be worth saying: a third of its letters at most.
pub(super) fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let name: Vec<char> = name.to_lowercase().chars().take(64).collect();
    known
        .iter()
        .map(|candidate| (distance(&name, candidate), *candidate))
        .filter(|(far, candidate)| far * 3 <= candidate.chars().count().max(3))
        .min_by_key(|(far, _)| *far)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein distance: letters to insert, delete or replace.
fn distance(a: &[char], b: &str) -> usize {
    let mut row: Vec<usize> = (0..=a.len()).collect();
    for (i, letter) in b.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for j in 0..a.len() {
            let replaced = diagonal + usize::from(a[j] != letter);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[a.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_is_recognised() {
        assert_eq!(
            nearest("edge_lenght_m", &["step_s", "edge_length_m"]),
            Some("edge_length_m")
        );
        assert_eq!(nearest("Match", &["match", "stage"]), Some("match"));
    }

    #[test]
    fn a_different_word_is_not_guessed_at() {
        assert_eq!(nearest("colour", &["panel", "from", "to"]), None);
    }

    #[test]
    fn distance_counts_edits() {
        let kitten: Vec<char> = "kitten".chars().collect();
        assert_eq!(distance(&kitten, "sitting"), 3);
        assert_eq!(distance(&[], "abc"), 3);
    }
}
