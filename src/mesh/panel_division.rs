//! Division of the edges of one panel into parts of equal length between breaks.

use super::slots::Slots;
use crate::pattern::Panel;
use crate::pattern::point::Point2;
use crate::pattern::polyline;
use crate::seam::{Stretch, Track};
use std::ops::Range;

/// Fractions of an edge closer than this are the same place: far above rounding, far below a
/// stitch.
const SAME: f64 = 1e-9;
/// The division of one edge: evenly between each two breaks.
#[derive(Clone, Debug)]
pub(super) struct Division {
    /// Fractions of the edge's arc length that must be vertices, from 0 to 1, rising.
    pub(super) breaks: Vec<f64>,
    /// Parts between each break and the next.
    pub(super) counts: Vec<usize>,
    /// Arc length of the edge \[m\].
    pub(super) length: f64,
}

impl Division {
    /// Divided once.
    pub(super) fn whole(length: f64, count: usize) -> Self {
        Self {
            breaks: vec![0.0, 1.0],
            counts: vec![count],
            length,
        }
    }

    /// Parts of the whole edge.
    pub(super) fn count(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Fractions of the arc length at which each part begins.
    pub(super) fn starts(&self) -> impl Iterator<Item = f64> + '_ {
        self.breaks
            .windows(2)
            .zip(&self.counts)
            .flat_map(|(ends, &count)| {
                #[expect(clippy::cast_precision_loss, reason = "counts are bounded by Limits")]
                (0..count).map(move |i| ends[0] + (ends[1] - ends[0]) * i as f64 / count as f64)
            })
    }

    /// Position of a fraction among the breaks; the nearest one.
    fn find(&self, fraction: f64) -> usize {
        let next = self.breaks.partition_point(|&b| b < fraction - SAME);
        next.min(self.breaks.len() - 1)
    }

    /// The spans between breaks that a stretch covers, in rising order.
    pub(super) fn spans(&self, stretch: &Stretch) -> Range<usize> {
        let (from, to) = (self.find(stretch.from), self.find(stretch.to));
        from.min(to)..from.max(to)
    }

    /// The number of the part at whose beginning each point of a stretch lies, along its way.
    pub(super) fn parts(&self, stretch: &Stretch) -> Vec<usize> {
        let spans = self.spans(stretch);
        let first: usize = self.counts[..spans.start].iter().sum();
        let last = first + self.counts[spans].iter().sum::<usize>();
        if stretch.from <= stretch.to {
            (first..=last).collect()
        } else {
            (first..=last).rev().collect()
        }
    }

    /// The number of the part that begins at a break.
    pub(super) fn part_at(&self, fraction: f64) -> usize {
        self.counts[..self.find(fraction)].iter().sum()
    }

    /// The break nearest to a fraction if it is within this arc length \[m\], else the fraction.
    pub(super) fn near_break(&self, fraction: f64, within: f64) -> f64 {
        let distance = |b: &f64| (b - fraction).abs() * self.length;
        let nearest = self.breaks.iter().copied();
        let nearest = nearest.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest
            .filter(|b| distance(b) <= within)
            .unwrap_or(fraction)
    }

    /// Adds a break unless it is there; returns true if it was added.
    pub(super) fn insert(&mut self, fraction: f64) -> bool {
        let place = self.breaks.partition_point(|&b| b < fraction - SAME);
        let there = self.breaks.get(place).is_none_or(|b| b - fraction <= SAME);
        if !there {
            self.breaks.insert(place, fraction);
        }
        !there
    }
}

/// The divisions of the edges of one panel.
pub(super) struct PanelDivision {
    /// The edges, numbered.
    pub(super) slots: Slots,
    /// By number of the edge.
    pub(super) divisions: Vec<Division>,
    /// Ends of internal lines that lie on other edges.
    pub(super) joints: Vec<LineJoint>,
    tracks: Vec<(Track, usize)>,
}

impl PanelDivision {
    /// An undivided panel, with its internal lines `lines`.
    pub(super) fn new(panel: &Panel, lines: Vec<usize>) -> Self {
        let slots = Slots::new(panel, lines);
        let tracks: Vec<_> = slots.all().collect();
        let whole = |&(track, edge): &(Track, usize)| {
            Division::whole(polyline::length(track.points(panel, edge)), 1)
        };
        Self {
            divisions: tracks.iter().map(whole).collect(),
            slots,
            joints: vec![],
            tracks,
        }
    }

    /// The polyline of an edge by its number.
    pub(super) fn points<'a>(&self, panel: &'a Panel, slot: usize) -> &'a [Point2] {
        let (track, edge) = self.tracks[slot];
        track.points(panel, edge)
    }

    /// Returns true if an edge, by its number, belongs to a ring.
    pub(super) fn is_closed(&self, panel: &Panel, slot: usize) -> bool {
        self.tracks[slot].0.is_closed(panel)
    }

    /// The fewest parts of each span of each edge, so that every ring is a polygon.
    pub(super) fn least_parts(&self, panel: &Panel) -> Vec<usize> {
        let spans = |divisions: &[Division]| divisions.iter().map(|d| d.breaks.len() - 1).sum();
        let mut least = vec![1; self.divisions.len()];
        for ring in &self.slots.rings {
            let count = least_parts(spans(&self.divisions[ring.clone()]));
            least[ring.clone()].fill(count);
        }
        for (line, count) in least.iter_mut().enumerate().skip(self.slots.first_line()) {
            if self.is_closed(panel, line) {
                *count = least_parts(spans(&self.divisions[line..=line]));
            }
        }
        least
    }
}

/// The end of an internal line that lies on another edge. Both are numbers of edges in
/// [`super::slots::Slots`].
#[derive(Clone, Copy, Debug)]
pub(super) struct LineJoint {
    /// The line.
    pub(super) line: usize,
    /// True if it is the line's last point, not its first.
    pub(super) last: bool,
    /// The edge that it lies on.
    pub(super) on: usize,
    /// Fraction of that edge's arc length.
    pub(super) at: f64,
}

/// Fewest parts of each of so many spans that make up a ring: a polygon has three sides.
fn least_parts(spans: usize) -> usize {
    3_usize.div_ceil(spans.max(1))
}
