//! Girths in sentences.

use super::section::Section;

/// Returns the length of a section against the girth of the body \[m\] at a place, in words.
pub(super) fn section_in_words(section: &Section, place: &str, body_m: f64) -> String {
    let cm = |length: f64| length * 100.0;
    let given = 100.0 * (section.stretched_m / section.rest_m - 1.0);
    format!(
        "round the {place} it measures {:.0} cm and the body {:.0} cm, and its cloth gives {given:.0} % ({:.0} cm)",
        cm(section.rest_m),
        cm(body_m),
        cm(section.stretched_m - section.rest_m)
    )
}
