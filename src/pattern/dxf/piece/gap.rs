//! Gaps between the lines of an outline.

use crate::pattern::Point2;
use crate::pattern::point::distance;

/// Gaps up to this are closed with a warning: a slip of the drawing hand that no cutter would
/// notice. Half a millimeter, and what is rounded to it \[m\].
pub(super) const REPAIRED: f64 = 5.05e-4;

/// At most this many gaps of an outline are told one by one.
const TOLD: usize = 12;

/// A gap between two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// The ends \[m\].
    pub(super) ends: [Point2; 2],
}

impl Gap {
    /// Returns its width \[m\].
    pub(super) fn size(&self) -> f64 {
        distance(self.ends[0], self.ends[1])
    }

    /// Returns its size and place; the ends of a small one are one place.
    fn described(&self) -> String {
        let [a, b] = self.ends.map(placed);
        let size = 1000.0 * self.size();
        if self.size() <= REPAIRED {
            format!("{size:.3} mm at {a} m")
        } else {
            format!("{size:.2} mm between {a} m and {b} m")
        }
    }
}

/// Returns the coordinates of a point to a tenth of a millimeter.
fn placed(p: Point2) -> String {
    // To add 0 makes 0 of -0.
    let [x, y] = p.map(|c| (1e4 * c).round() / 1e4 + 0.0);
    format!("({x:.4}, {y:.4})")
}

/// Returns a sentence on gaps of `whose` that were closed; `None` if there are none.
pub(super) fn closed_in_words(gaps: &[Gap], whose: &str) -> Option<String> {
    let (head, verb) = match gaps.len() {
        0 => return None,
        1 => ("a gap".to_owned(), "was"),
        count => (format!("{count} gaps"), "were"),
    };
    Some(format!("{head} in {whose} {verb} closed: {}", listed(gaps)))
}

/// Returns gaps with their sizes and places, as a list in words; more than a dozen are counted.
pub(super) fn listed(gaps: &[Gap]) -> String {
    let told: Vec<String> = gaps.iter().take(TOLD).map(Gap::described).collect();
    let more = gaps.len().saturating_sub(TOLD);
    if more > 0 {
        return format!("{}; and {more} more", told.join("; "));
    }
    told.join("; ")
}
