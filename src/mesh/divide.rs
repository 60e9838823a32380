//! How many parts each stretch of outline is divided into, so that both sides of every seam get as many.

use super::geometry;
use crate::fault::Fault;
use crate::pattern::{Panel, Pattern};
use crate::seam::{Seam, Stretch, division_count};
use std::ops::Range;

/// Fractions of an edge closer than this are the same place: far above rounding, far below a stitch.
const SAME: f64 = 1e-9;

/// Most places where seams may break one edge. More come only from seams that chase each other round a ring of edges.
const MOST_BREAKS: usize = 1_000;

/// How one edge is divided: evenly between each two breaks.
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
    fn spans(&self, stretch: &Stretch) -> Range<usize> {
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

    /// Adds a break unless it is there; says whether it was added.
    fn insert(&mut self, fraction: f64) -> bool {
        let place = self.breaks.partition_point(|&b| b < fraction - SAME);
        let there = self.breaks.get(place).is_none_or(|b| b - fraction <= SAME);
        if !there {
            self.breaks.insert(place, fraction);
        }
        !there
    }
}

/// How every edge of every panel is divided.
pub(super) struct Divisions {
    /// By panel, by edge of its outline.
    pub(super) panels: Vec<Vec<Division>>,
}

impl Divisions {
    /// Breaks edges where stretches end, carries the breaks across seams, then counts parts.
    pub(super) fn new(pattern: &Pattern, seams: &[Seam], edge_length: f64) -> Result<Self, Fault> {
        let panels = pattern.panels.iter().map(whole_edges).collect();
        let mut divisions = Self { panels };
        divisions.set_breaks(pattern, seams)?;
        divisions.set_counts(seams, edge_length);
        Ok(divisions)
    }

    pub(super) fn of(&self, stretch: &Stretch) -> &Division {
        &self.panels[stretch.panel][stretch.edge]
    }

    fn insert(&mut self, stretch: &Stretch, fraction: f64) -> bool {
        self.panels[stretch.panel][stretch.edge].insert(fraction)
    }

    fn set_breaks(&mut self, pattern: &Pattern, seams: &[Seam]) -> Result<(), Fault> {
        for stretch in pairs(seams).flatten() {
            self.insert(stretch, stretch.from);
            self.insert(stretch, stretch.to);
        }
        let mut changed = true;
        while changed {
            changed = false;
            for [a, b] in pairs(seams) {
                changed |= self.carry(a, b);
                changed |= self.carry(b, a);
                if self.of(a).breaks.len().max(self.of(b).breaks.len()) > MOST_BREAKS {
                    return Err(endless(&pattern.panels[a.panel]));
                }
            }
        }
        Ok(())
    }

    /// Carries the breaks inside one stretch to the one it meets.
    fn carry(&mut self, from: &Stretch, to: &Stretch) -> bool {
        let division = self.of(from);
        let spans = division.spans(from);
        let inner = division.breaks[spans.start + 1..spans.end.max(spans.start + 1)].to_vec();
        inner.into_iter().fold(false, |changed, fraction| {
            let share = (fraction - from.from) / (from.to - from.from);
            self.insert(to, to.from + share * (to.to - to.from)) || changed
        })
    }

    /// Gives all spans that meet, directly or through others, the largest count that any of them wants.
    fn set_counts(&mut self, seams: &[Seam], edge_length: f64) {
        let numbers = Numbers::new(&self.panels);
        let mut classes = Classes::new(numbers.count);
        for pair in pairs(seams) {
            let [a, b] = pair.each_ref().map(|stretch| {
                let spans = self.of(stretch).spans(stretch);
                let first = numbers.of(stretch);
                let mut spans: Vec<_> = spans.map(|span| first + span).collect();
                if stretch.from > stretch.to {
                    spans.reverse();
                }
                spans
            });
            for (a, b) in a.into_iter().zip(b) {
                classes.join(a, b);
            }
        }
        let mut wanted = vec![1; numbers.count];
        for (span, want) in self.wanted(edge_length).enumerate() {
            let class = classes.find(span);
            wanted[class] = want.max(wanted[class]);
        }
        let mut span = 0..numbers.count;
        for division in self.panels.iter_mut().flatten() {
            let next = span.by_ref().take(division.breaks.len() - 1);
            division.counts = next.map(|span| wanted[classes.find(span)]).collect();
        }
    }

    /// What each span would be divided into by itself, in order of their numbers.
    fn wanted(&self, edge_length: f64) -> impl Iterator<Item = usize> + '_ {
        self.panels.iter().flat_map(move |panel| {
            let spans: usize = panel.iter().map(|d| d.breaks.len() - 1).sum();
            panel.iter().flat_map(move |division| {
                division.breaks.windows(2).map(move |ends| {
                    let length = (ends[1] - ends[0]) * division.length;
                    division_count(length, length, edge_length).max(least_parts(spans))
                })
            })
        })
    }
}

/// Fewest parts of each of so many spans that make up a ring: a polygon has three sides.
pub(super) fn least_parts(spans: usize) -> usize {
    3_usize.div_ceil(spans.max(1))
}

fn whole_edges(panel: &Panel) -> Vec<Division> {
    let whole = |points: &[_]| Division::whole(geometry::length(points), 1);
    panel.edges.iter().map(|e| whole(&e.points)).collect()
}

fn pairs(seams: &[Seam]) -> impl Iterator<Item = &[Stretch; 2]> {
    seams.iter().flat_map(|seam| &seam.matched)
}

fn endless(panel: &Panel) -> Fault {
    Fault::new(
        "mesh/endless_breaks",
        format!("/panels/{}", panel.id),
        format!("seams at panel \"{}\" share stretches in a way that divides them without end", panel.name),
    )
    .fix("sew each stretch of outline to one other, or let layered seams begin and end at the same places")
}

/// Numbers all spans of all edges.
struct Numbers {
    first: Vec<Vec<usize>>,
    count: usize,
}

impl Numbers {
    fn new(panels: &[Vec<Division>]) -> Self {
        let mut count = 0;
        let mut next = |division: &Division| {
            let first = count;
            count += division.breaks.len() - 1;
            first
        };
        let first = panels.iter().map(|p| p.iter().map(&mut next).collect());
        let first = first.collect();
        Self { first, count }
    }

    fn of(&self, stretch: &Stretch) -> usize {
        self.first[stretch.panel][stretch.edge]
    }
}

/// Union-find.
struct Classes(Vec<usize>);

impl Classes {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn find(&mut self, mut item: usize) -> usize {
        while self.0[item] != item {
            self.0[item] = self.0[self.0[item]];
            item = self.0[item];
        }
        item
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b)] = a.min(b);
    }
}
