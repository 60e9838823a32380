//! How many parts each edge is divided into, so that both sides of every seam get as many.

use super::geometry::{self, Point};
use super::joint::{self, Joint};
use super::slots::{self, Slots};
use crate::fault::{Fault, MeshCode};
use crate::pattern::{Panel, Pattern};
use crate::seam::{Seam, Stretch, Track, division_count};
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

/// How the edges of one panel are divided.
pub(super) struct PanelDivision {
    /// Which edges these are.
    pub(super) slots: Slots,
    /// By number of the edge.
    pub(super) divisions: Vec<Division>,
    /// Where ends of internal lines lie on other edges.
    pub(super) joints: Vec<Joint>,
    tracks: Vec<(Track, usize)>,
}

impl PanelDivision {
    fn new(panel: &Panel, lines: Vec<usize>) -> Self {
        let slots = Slots::new(panel, lines);
        let tracks: Vec<_> = slots.all().collect();
        let whole = |&(track, edge): &(Track, usize)| {
            Division::whole(geometry::length(track.points(panel, edge)), 1)
        };
        Self {
            divisions: tracks.iter().map(whole).collect(),
            slots,
            joints: vec![],
            tracks,
        }
    }

    /// The polyline of an edge by its number.
    pub(super) fn points<'a>(&self, panel: &'a Panel, slot: usize) -> &'a [Point] {
        let (track, edge) = self.tracks[slot];
        track.points(panel, edge)
    }

    /// Whether an edge by its number belongs to a ring.
    pub(super) fn is_closed(&self, panel: &Panel, slot: usize) -> bool {
        self.tracks[slot].0.is_closed(panel)
    }

    /// The fewest parts of each span of each edge, so that every ring is a polygon.
    fn least_parts(&self, panel: &Panel) -> Vec<usize> {
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

    /// Puts a break where the end of a line lies.
    fn join_lines(&mut self, panel: &Panel) {
        self.joints = joint::find(panel, self);
        for joint in &self.joints {
            self.divisions[joint.on].insert(joint.at);
        }
    }
}

/// How every edge of every panel is divided.
pub(super) struct Divisions {
    /// By panel.
    pub(super) panels: Vec<PanelDivision>,
}

impl Divisions {
    /// Breaks edges where stretches end, carries the breaks across seams, then counts parts.
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
            divided.join_lines(panel);
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
    fn set_counts(&mut self, pattern: &Pattern, seams: &[Seam], edge_length: f64) {
        let numbers = Numbers::new(&self.panels);
        let mut classes = Classes::new(numbers.count);
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

    /// What each span would be divided into by itself, in order of their numbers.
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

/// Fewest parts of each of so many spans that make up a ring: a polygon has three sides.
fn least_parts(spans: usize) -> usize {
    3_usize.div_ceil(spans.max(1))
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

/// Numbers all spans of all edges.
struct Numbers {
    /// By panel and number of the edge: its first span.
    first: Vec<Vec<usize>>,
    count: usize,
}

impl Numbers {
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
