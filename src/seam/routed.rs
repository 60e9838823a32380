//! A seam whose runs are known, before it is known whether it can be sewn.

use super::Stretch;
use super::marks::{self, MatchedMarks, Measured};
use super::matching;
use super::parity::Link;
use super::runs::Leg;
use crate::pattern::Pattern;
use std::collections::BTreeSet;

/// How steeply a side must go up or down the drawing for its ends to count as upper and lower: rise over length, 30 degrees.
const STEEP: f64 = 0.5;

/// A seam whose runs are known.
#[derive(Clone, Debug)]
pub(super) struct Routed {
    /// Its position in the request.
    pub index: usize,
    /// The runs of side A and of side B.
    pub sides: [Vec<Leg>; 2],
}

impl Routed {
    /// The same with side B gone from its end to its start.
    pub(super) fn reversed(&self) -> Self {
        let [a, b] = &self.sides;
        Self {
            index: self.index,
            sides: [a.clone(), b.iter().rev().map(Leg::reversed).collect()],
        }
    }

    /// Length of each side \[m\].
    pub(super) fn lengths(&self, pattern: &Pattern) -> [f64; 2] {
        self.measured(pattern)
            .map(|side| side.iter().map(|(_, length)| length).sum())
    }

    fn measured(&self, pattern: &Pattern) -> [Measured; 2] {
        self.sides.each_ref().map(|legs| {
            let stretches = legs.iter().flat_map(|leg| &leg.stretches);
            stretches.map(|s| (*s, s.length(pattern))).collect()
        })
    }

    /// Which notches meet.
    pub(super) fn marks(&self, pattern: &Pattern) -> Vec<MatchedMarks> {
        marks::matched(pattern, &self.measured(pattern))
    }

    /// Which stretches meet: by arc length between each two notches that do.
    pub(super) fn matched(&self, pattern: &Pattern) -> Vec<[Stretch; 2]> {
        let sides = self.measured(pattern);
        let marks = marks::matched(pattern, &sides);
        let pieces = [
            marks::cut(&sides[0], marks.iter().map(|pair| pair.a.at_m)),
            marks::cut(&sides[1], marks.iter().map(|pair| pair.b.at_m)),
        ];
        match pieces {
            [Some(a), Some(b)] => a
                .iter()
                .zip(&b)
                .flat_map(|(a, b)| matching::matched(a, b))
                .collect(),
            _ => matching::matched(&sides[0], &sides[1]),
        }
    }

    /// Whether the ends that meet are both the upper or both the lower one of their side as drawn;
    /// nothing where a side is not steep or goes over several panels.
    pub(super) fn heights_agree(&self, pattern: &Pattern) -> Option<bool> {
        let [a, b] = self.sides.each_ref().map(|legs| rise(legs, pattern));
        Some((a? > 0.0) == (b? > 0.0))
    }
}

/// Rise over length of a steep side.
fn rise(legs: &[Leg], pattern: &Pattern) -> Option<f64> {
    let stretches: Vec<_> = legs.iter().flat_map(|leg| &leg.stretches).collect();
    let (first, last) = (stretches.first()?, stretches.last()?);
    if stretches.iter().any(|s| s.panel != first.panel) {
        return None;
    }
    let length: f64 = stretches.iter().map(|s| s.length(pattern)).sum();
    let rise = (last.ends(pattern)[1][1] - first.ends(pattern)[0][1]) / length;
    (rise.abs() >= STEEP).then_some(rise)
}

/// What matched stretches say of faces: in a two-sided surface two panels with the same side of the cloth out go in
/// opposite directions along their seam, as the drawings of both have it. An internal line has cloth on both sides
/// and says nothing.
pub(super) fn links(pattern: &Pattern, matched: &[[Stretch; 2]]) -> Vec<Link> {
    let link = |[a, b]: &[Stretch; 2]| {
        let ways = [a, b].map(|stretch| stretch.has_cloth_on_right(pattern));
        Some(Link {
            ends: [a.panel.min(b.panel), a.panel.max(b.panel)],
            same: ways[0]? != ways[1]?,
        })
    };
    let links: BTreeSet<Link> = matched.iter().filter_map(link).collect();
    links.into_iter().collect()
}
