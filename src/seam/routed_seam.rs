//! A seam whose runs are known, before it is known whether it can be sewn.

use super::Stretch;
use super::marks::{self, MatchedMarks, MeasuredStretches};
use super::matching;
use super::parity::FaceRelation;
use super::run_resolver::RoutedRun;
use crate::pattern::Pattern;
use std::collections::BTreeSet;

/// Least rise over length of a side whose ends count as upper and lower in the drawing: 30 degrees.
const MIN_STEEPNESS: f64 = 0.5;

/// A seam whose runs are known.
#[derive(Clone, Debug)]
pub(super) struct RoutedSeam {
    /// Its position in the request.
    pub index: usize,
    /// The runs of side A and of side B.
    pub sides: [Vec<RoutedRun>; 2],
}

impl RoutedSeam {
    /// Returns the seam with side B gone from its end to its start.
    pub(super) fn reversed(&self) -> Self {
        let [a, b] = &self.sides;
        Self {
            index: self.index,
            sides: [a.clone(), b.iter().rev().map(RoutedRun::reversed).collect()],
        }
    }

    /// Length of each side \[m\].
    pub(super) fn lengths(&self, pattern: &Pattern) -> [f64; 2] {
        self.measured(pattern)
            .map(|side| side.iter().map(|(_, length)| length).sum())
    }

    fn measured(&self, pattern: &Pattern) -> [MeasuredStretches; 2] {
        self.sides.each_ref().map(|runs| {
            let stretches = runs.iter().flat_map(|run| &run.stretches);
            stretches.map(|s| (*s, s.length(pattern))).collect()
        })
    }

    /// Returns the notches that meet.
    pub(super) fn marks(&self, pattern: &Pattern) -> Vec<MatchedMarks> {
        marks::match_marks(pattern, &self.measured(pattern))
    }

    /// Returns the stretches that meet: by arc length between each two notches that do.
    pub(super) fn matched(&self, pattern: &Pattern) -> Vec<[Stretch; 2]> {
        let sides = self.measured(pattern);
        let marks = marks::match_marks(pattern, &sides);
        let pieces = [
            marks::split_at(&sides[0], marks.iter().map(|pair| pair.a.at_m)),
            marks::split_at(&sides[1], marks.iter().map(|pair| pair.b.at_m)),
        ];
        match pieces {
            [Some(a), Some(b)] => a
                .iter()
                .zip(&b)
                .flat_map(|(a, b)| matching::match_stretches(a, b))
                .collect(),
            _ => matching::match_stretches(&sides[0], &sides[1]),
        }
    }

    /// Returns true if the ends that meet are both the upper or both the lower one of their side as
    /// drawn; nothing where a side is not steep or goes over several panels.
    pub(super) fn heights_agree(&self, pattern: &Pattern) -> Option<bool> {
        let [a, b] = self.sides.each_ref().map(|runs| rise(runs, pattern));
        Some((a? > 0.0) == (b? > 0.0))
    }
}

/// Returns the rise over length of a steep side.
fn rise(runs: &[RoutedRun], pattern: &Pattern) -> Option<f64> {
    let stretches: Vec<_> = runs.iter().flat_map(|run| &run.stretches).collect();
    let (first, last) = (stretches.first()?, stretches.last()?);
    if stretches.iter().any(|s| s.panel != first.panel) {
        return None;
    }
    let length: f64 = stretches.iter().map(|s| s.length(pattern)).sum();
    let rise = (last.ends(pattern)[1][1] - first.ends(pattern)[0][1]) / length;
    (rise.abs() >= MIN_STEEPNESS).then_some(rise)
}

/// Returns the face relations of matched stretches: in a two-sided surface two panels with the same
/// side of the cloth out go in opposite directions along their seam, as the drawings of both have
/// it. An internal line has cloth on both sides and says nothing.
pub(super) fn face_relations(pattern: &Pattern, matched: &[[Stretch; 2]]) -> Vec<FaceRelation> {
    let link = |[a, b]: &[Stretch; 2]| {
        let ways = [a, b].map(|stretch| stretch.has_cloth_on_right(pattern));
        Some(FaceRelation {
            ends: [a.panel.min(b.panel), a.panel.max(b.panel)],
            same: ways[0]? != ways[1]?,
        })
    };
    let relations: BTreeSet<FaceRelation> = matched.iter().filter_map(link).collect();
    relations.into_iter().collect()
}
