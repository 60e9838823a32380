//! Notches along the two sides of a seam, and which of them meet.

use super::place::snap_distance;
use super::{Stretch, Track};
use crate::pattern::Pattern;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use utoipa::ToSchema;

/// Largest distance of two marks that meet beyond what ease explains, as a share of the seam:
/// notched by hand.
const SLACK: f64 = 0.02;

/// Marks nearer than this to the one before them on their side mark the same place \[m\]. Double
/// notches lie 6 mm apart.
const DUPLICATE_M: f64 = 3e-3;

/// Panels with more notches than this are drawn by something that means other than to match them.
const MAX_NOTCHES: usize = 500;

/// A mark on one side of a seam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[schema(as = Mark)]
pub struct SeamMark {
    /// Id of the panel; where the mark is the end of a panel, of the one that follows.
    pub panel: String,
    /// Index of the notch; absent where the mark is the end of a panel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub notch: Option<usize>,
    /// Distance along its side, from `from` of A and what that meets \[m\].
    pub at_m: f64,
}

/// Two marks that are sewn onto each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MatchedMarks {
    /// The one on side A.
    pub a: SeamMark,
    /// The one on side B.
    pub b: SeamMark,
}

/// The stretches of a side with their lengths \[m\].
pub(super) type MeasuredStretches = Vec<(Stretch, f64)>;

/// Returns the marks of both sides that meet, in order; none if the sides are not marked alike.
///
/// The notches inside both sides are taken in order where they are equally many, or else the
/// notches with the places at which a side goes on to another panel (a notch on a sleeve cap meets
/// the shoulder seam). They are taken only if each two lie near enough. With an ease of `e`, a
/// place at `s` of the shorter side meets one between `s / (1 + e)` (all ease is after it) and
/// `(s + e) / (1 + e)` (all is before it) of the longer side, as fractions: that is at most
/// `e / (1 + e)` from `s`, and a little is added for how exactly notches are drawn. Marks farther
/// apart than that were not made to meet.
pub(super) fn match_marks(pattern: &Pattern, sides: &[MeasuredStretches; 2]) -> Vec<MatchedMarks> {
    let marks = sides.each_ref().map(|side| marks(pattern, side));
    let lengths = sides
        .each_ref()
        .map(|side| side.iter().map(|(_, length)| length).sum::<f64>());
    let shorter = lengths[0].min(lengths[1]);
    let near = 1.0 - shorter / lengths[0].max(lengths[1]) + SLACK;
    let meet = |[a, b]: [&SeamMark; 2]| (a.at_m / lengths[0] - b.at_m / lengths[1]).abs() <= near;
    let notches = marks.each_ref().map(|side| {
        let notches = side.iter().filter(|mark| mark.notch.is_some());
        notches.cloned().collect::<Vec<_>>()
    });
    for [a, b] in [notches, marks] {
        let has_notch = a.iter().chain(&b).any(|mark| mark.notch.is_some());
        if has_notch && a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| meet([a, b])) {
            let pairs = a.into_iter().zip(b);
            return pairs.map(|(a, b)| MatchedMarks { a, b }).collect();
        }
    }
    vec![]
}

/// Returns the notches and ends of panels inside a side, in order.
fn marks(pattern: &Pattern, side: &MeasuredStretches) -> Vec<SeamMark> {
    let mut marks: Vec<SeamMark> = vec![];
    let mut seen = BTreeSet::new();
    let mut passed = 0.0;
    for (i, (stretch, length)) in side.iter().enumerate() {
        let panel = &pattern.panels[stretch.panel];
        if i > 0 && side[i - 1].0.panel != stretch.panel {
            marks.push(SeamMark {
                panel: panel.id.clone(),
                notch: None,
                at_m: passed,
            });
        }
        let (low, high) = (stretch.from.min(stretch.to), stretch.from.max(stretch.to));
        let is_outline = stretch.track == Track::Outline;
        let notches = panel.notches.iter().take(MAX_NOTCHES + 1);
        let on_edge = notches.filter(|notch| {
            is_outline && notch.edge == stretch.edge && (low..=high).contains(&notch.at)
        });
        if panel.notches.len() <= MAX_NOTCHES {
            for notch in on_edge {
                if seen.insert((stretch.panel, notch.index)) {
                    let share = (notch.at - stretch.from) / (stretch.to - stretch.from);
                    marks.push(SeamMark {
                        panel: panel.id.clone(),
                        notch: Some(notch.index),
                        at_m: passed + share * length,
                    });
                }
            }
        }
        passed += length;
    }
    let inside = DUPLICATE_M..=passed - DUPLICATE_M;
    marks.retain(|mark| inside.contains(&mark.at_m));
    marks.sort_by(|a, b| a.at_m.total_cmp(&b.at_m));
    // The end of a panel is exact; a notch beside it says the same again.
    marks.dedup_by(|later, earlier| {
        let same = later.at_m - earlier.at_m < DUPLICATE_M;
        if same && later.notch.is_none() {
            std::mem::swap(later, earlier);
        }
        same
    });
    marks
}

/// Returns a side cut at these positions \[m\], which rise; nothing if that would leave a part
/// empty. A cut next to the end of a stretch is made there.
pub(super) fn split_at(
    side: &MeasuredStretches,
    at: impl Iterator<Item = f64>,
) -> Option<Vec<MeasuredStretches>> {
    let mut left = side.clone();
    left.reverse();
    let mut passed = 0.0;
    let mut pieces = vec![];
    for position in at {
        let mut piece = vec![];
        while let Some((stretch, length)) = left.pop() {
            let snap = snap_distance(length);
            let here = position - passed;
            if here <= snap {
                left.push((stretch, length));
                break;
            }
            if length - here <= snap {
                passed += length;
                piece.push((stretch, length));
                continue;
            }
            let middle = stretch.from + here / length * (stretch.to - stretch.from);
            piece.push((
                Stretch {
                    to: middle,
                    ..stretch
                },
                here,
            ));
            let rest = Stretch {
                from: middle,
                ..stretch
            };
            left.push((rest, length - here));
            passed = position;
            break;
        }
        pieces.push(piece);
    }
    left.reverse();
    pieces.push(left);
    pieces
        .iter()
        .all(|piece| !piece.is_empty())
        .then_some(pieces)
}
