//! Division of all edges into parts, equally many on both sides of every seam.

use super::joint;
use super::panel_division::{Division, PanelDivision};
use super::slots;
use crate::fault::{Fault, MeshCode};
use crate::pattern::{Panel, Pattern};
use crate::seam::{Seam, Stretch, division_count};

/// Most places where seams may break one edge. More come only from seams that chase each other
/// round a ring of edges.
const MOST_BREAKS: usize = 1_000;

/// The divisions of every edge of every panel.
pub(super) struct Divisions {
    /// By panel.
    pub(super) panels: Vec<PanelDivision>,
}

impl Divisions {
    /// Breaks edges at the ends of stretches, carries the breaks across seams, then counts parts.
    pub(super) fn new(pattern: &Pattern, seams: &[Seam], edge_length: f64) -> Result<Self, Fault> {
        let lines = slots::lines_named(seams, pattern.panels.len());
        let panels = pattern.panels.iter().zip(lines);
        let mut divisions = Self {
            panels: panels
                .map(|(panel, lines)| PanelDivision::new(panel, lines))
                .collect(),
        };
        divisions.set_breaks(pattern, seams)?;
        divisions.set_counts(pattern, seams, edge_length);
        Ok(divisions)
    }

    /// The number of the edge that a stretch lies on.
    pub(super) fn slot(&self, stretch: &Stretch) -> usize {
        self.panels[stretch.panel]
            .slots
            .of(stretch.track, stretch.edge)
    }

    pub(super) fn of(&self, stretch: &Stretch) -> &Division {
        &self.panels[stretch.panel].divisions[self.slot(stretch)]
    }

    fn insert(&mut self, stretch: &Stretch, fraction: f64) -> bool {
        let slot = self.slot(stretch);
        self.panels[stretch.panel].divisions[slot].insert(fraction)
    }

    fn set_breaks(&mut self, pattern: &Pattern, seams: &[Seam]) -> Result<(), Fault> {
        for stretch in pairs(seams).flatten() {
            self.insert(stretch, stretch.from);
            self.insert(stretch, stretch.to);
        }
        for (panel, divided) in pattern.panels.iter().zip(&mut self.panels) {
            join_lines(panel, divided);
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

    /// Gives all spans that meet, directly or through others, the largest count that any of them
    /// wants.
    fn set_counts(&mut self, pattern: &Pattern, seams: &[Seam], edge_length: f64) {
        let numbers = SpanNumbering::new(&self.panels);
        let mut classes = DisjointSets::new(numbers.count);
        for pair in pairs(seams) {
            let [a, b] = pair.each_ref().map(|stretch| {
                let spans = self.of(stretch).spans(stretch);
                let first = numbers.first[stretch.panel][self.slot(stretch)];
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
        for (span, want) in self.wanted(pattern, edge_length).into_iter().enumerate() {
            let class = classes.find(span);
            wanted[class] = want.max(wanted[class]);
        }
        let mut span = 0..numbers.count;
        for division in self
            .panels
            .iter_mut()
            .flat_map(|panel| &mut panel.divisions)
        {
            let next = span.by_ref().take(division.breaks.len() - 1);
            division.counts = next.map(|span| wanted[classes.find(span)]).collect();
        }
    }

    /// Returns the part count that each span needs by itself, in order of their numbers.
    fn wanted(&self, pattern: &Pattern, edge_length: f64) -> Vec<usize> {
        let mut wanted = vec![];
        for (panel, divided) in pattern.panels.iter().zip(&self.panels) {
            let least = divided.least_parts(panel);
            for (division, least) in divided.divisions.iter().zip(least) {
                wanted.extend(division.breaks.windows(2).map(|ends| {
                    let length = (ends[1] - ends[0]) * division.length;
                    division_count(length, length, edge_length).max(least)
                }));
            }
        }
        wanted
    }
}

/// Puts a break where the end of a line lies on another edge.
fn join_lines(panel: &Panel, divided: &mut PanelDivision) {
    divided.joints = joint::find(panel, divided);
    for joint in &divided.joints {
        divided.divisions[joint.on].insert(joint.at);
    }
}

fn pairs(seams: &[Seam]) -> impl Iterator<Item = &[Stretch; 2]> {
    seams.iter().flat_map(|seam| &seam.matched)
}

fn endless(panel: &Panel) -> Fault {
    Fault::new(
        MeshCode::EndlessBreaks,
        format!("/panels/{}", panel.id),
        format!("seams at panel \"{}\" share stretches in a way that divides them without end", panel.name),
    )
    .fix("sew each stretch of outline to one other, or let layered seams begin and end at the same places")
}

/// The numbers of all spans of all edges.
struct SpanNumbering {
    /// By panel and number of the edge: its first span.
    first: Vec<Vec<usize>>,
    count: usize,
}

impl SpanNumbering {
    fn new(panels: &[PanelDivision]) -> Self {
        let mut count = 0;
        let mut next = |division: &Division| {
            let first = count;
            count += division.breaks.len() - 1;
            first
        };
        let first = panels
            .iter()
            .map(|panel| panel.divisions.iter().map(&mut next).collect());
        let first = first.collect();
        Self { first, count }
    }
}

/// Disjoint sets of spans (union-find with path halving).
struct DisjointSets(Vec<usize>);

impl DisjointSets {
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
