//! The edges of a panel that are divided, in one row: its outline's, its holes', and the internal
//! lines that seams name.

use crate::pattern::Panel;
use crate::seam::{Seam, Track};
use std::collections::BTreeSet;
use std::ops::Range;

/// Numbers of a panel's edges; see the module.
#[derive(Clone, Debug)]
pub(super) struct Slots {
    /// The edges of each ring: the outline, then the holes.
    pub(super) rings: Vec<Range<usize>>,
    /// The internal lines that follow, by index in the panel.
    pub(super) lines: Vec<usize>,
}

impl Slots {
    pub(super) fn new(panel: &Panel, lines: Vec<usize>) -> Self {
        let mut next = 0;
        let counts = panel.holes.iter().map(|hole| hole.edges.len());
        let rings = std::iter::once(panel.edges.len()).chain(counts);
        let rings = rings.map(|count| {
            next += count;
            next - count..next
        });
        Self {
            rings: rings.collect(),
            lines,
        }
    }

    /// The number of an edge; that of an internal line no seam names is the next after all.
    pub(super) fn of(&self, track: Track, edge: usize) -> usize {
        match track {
            Track::Outline => edge,
            Track::Hole(hole) => self.rings[hole + 1].start + edge,
            Track::Line(line) => {
                let place = self.lines.iter().position(|&other| other == line);
                self.first_line() + place.unwrap_or(self.lines.len())
            }
        }
    }

    /// The number of the first internal line.
    pub(super) fn first_line(&self) -> usize {
        self.rings.last().map_or(0, |ring| ring.end)
    }

    /// The track and edge of each number, in order.
    pub(super) fn all(&self) -> impl Iterator<Item = (Track, usize)> + '_ {
        let rings = self.rings.iter().enumerate().flat_map(|(i, ring)| {
            let track = i.checked_sub(1).map_or(Track::Outline, Track::Hole);
            (0..ring.len()).map(move |edge| (track, edge))
        });
        let lines = self.lines.iter().map(|&line| (Track::Line(line), 0));
        rings.chain(lines)
    }
}

/// The internal lines of each of `count` panels that are sides of seams.
pub(super) fn lines_named(seams: &[Seam], count: usize) -> Vec<Vec<usize>> {
    let mut named = vec![BTreeSet::new(); count];
    for stretch in seams.iter().flat_map(|seam| seam.matched.iter().flatten()) {
        if let Track::Line(line) = stretch.track {
            named[stretch.panel].insert(line);
        }
    }
    named
        .into_iter()
        .map(|lines| lines.into_iter().collect())
        .collect()
}
