//! From the requested runs of a side to the stretches of edges that they go along.

use super::direction::direction;
use super::path::TrackPath;
use super::place::{self, TrackPoint, TrackPosition, TrackTopology};
use super::{Stretch, Track};
use crate::fault::{Fault, SeamCode, nearest};
use crate::pattern::{Direction, OutlineRun, Panel, Pattern, Side};
use std::collections::BTreeMap;

/// Stretches that all seams of one request may have together: bounds the memory that long runs laid
/// many times over one another would take.
const MAX_STRETCHES: usize = 200_000;

/// Number of misspelled names that get a suggestion: the rest of a request full of them would only
/// cost time.
const MAX_SUGGESTIONS: usize = 100;

/// Sides shorter than this are nothing to sew \[m\]: outlines are read to a few micrometers.
const MIN_SIDE_M: f64 = 1e-5;

/// Stretches no longer than this are left out of a run \[m\]: far below what a drawing resolves,
/// far above rounding.
const NEGLIGIBLE_M: f64 = 1e-7;

/// One run whose places are known.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RoutedRun {
    /// JSON pointer to it in the request.
    pub pointer: String,
    /// Direction round its track.
    pub direction: Direction,
    /// The stretches it goes along, in order; none of them without length.
    pub stretches: Vec<Stretch>,
}

impl RoutedRun {
    /// Returns the run gone from the end to the start.
    pub(super) fn reversed(&self) -> Self {
        Self {
            pointer: self.pointer.clone(),
            direction: place::opposite(self.direction),
            stretches: self.stretches.iter().rev().map(|s| s.reversed()).collect(),
        }
    }
}

/// Faults of a side that cannot be sewn, and the side as it could be.
pub(super) struct UnroutableSide {
    pub faults: Vec<Fault>,
    pub corrected: Option<Side>,
}

/// Turns requested sides into routed runs and keeps the bounds on the work that a request may
/// cause.
pub(super) struct RunResolver<'a> {
    pattern: &'a Pattern,
    panels: BTreeMap<&'a str, usize>,
    /// Places inside edges that runs have named so far, by panel, track and edge.
    inside: BTreeMap<(usize, Track, usize), Vec<f64>>,
    stretches_left: usize,
    suggestions_left: usize,
}

impl<'a> RunResolver<'a> {
    pub(super) fn new(pattern: &'a Pattern) -> Self {
        let panels = pattern.panels.iter().enumerate().rev();
        Self {
            pattern,
            panels: panels
                .map(|(index, panel)| (panel.id.as_str(), index))
                .collect(),
            inside: BTreeMap::new(),
            stretches_left: MAX_STRETCHES,
            suggestions_left: MAX_SUGGESTIONS,
        }
    }

    /// Returns the routed runs of `side`, which stands at `pointer`.
    ///
    /// # Errors
    /// The faults of all its runs, with the side as it could be sewn where every wrong run can be
    /// corrected.
    pub(super) fn side(
        &mut self,
        side: &Side,
        pointer: &str,
    ) -> Result<Vec<RoutedRun>, UnroutableSide> {
        let mut routed_runs = vec![];
        let mut faults = vec![];
        let mut corrected = vec![];
        for (i, run) in side.runs().iter().enumerate() {
            let at = match side {
                Side::One(_) => pointer.to_owned(),
                Side::Many(_) => format!("{pointer}/{i}"),
            };
            match self.run(run, &at) {
                Ok(routed_run) => {
                    routed_runs.push(routed_run);
                    corrected.push(run.clone());
                }
                Err(more) => {
                    faults.extend(more);
                    corrected.extend(self.corrected(run));
                }
            }
        }
        if side.runs().is_empty() {
            let fault = Fault::new(
                SeamCode::EmptySide,
                pointer,
                "this side of the seam has no run",
            );
            faults.push(fault.fix("pick at least one edge for each side, or take the seam out"));
        }
        if faults.is_empty() {
            return Ok(routed_runs);
        }
        let all = corrected.len() == side.runs().len() && !corrected.is_empty();
        let corrected = all.then(|| match side {
            Side::One(_) => Side::One(corrected.remove(0)),
            Side::Many(_) => Side::Many(corrected),
        });
        Err(UnroutableSide { faults, corrected })
    }

    /// Returns the run with its panel's name and its direction put right, if that is all that is
    /// wrong with it.
    fn corrected(&mut self, run: &OutlineRun) -> Option<OutlineRun> {
        let mut corrected = run.clone();
        if !self.panels.contains_key(run.panel.as_str()) {
            if self.suggestions_left == 0 {
                return None;
            }
            self.suggestions_left -= 1;
            let ids = self.pattern.panels.iter().map(|panel| panel.id.as_str());
            corrected.panel = nearest(&run.panel, ids)?.to_owned();
        }
        let routed_run = self.run(&corrected, "").or_else(|_| {
            corrected.direction = None;
            self.run(&corrected, "")
        });
        let routed_run = routed_run.ok()?;
        self.stretches_left += routed_run.stretches.len();
        Some(corrected)
    }

    fn run(&mut self, run: &OutlineRun, pointer: &str) -> Result<RoutedRun, Vec<Fault>> {
        let Some(&index) = self.panels.get(run.panel.as_str()) else {
            return Err(vec![self.unknown_panel(&run.panel, pointer)]);
        };
        let panel = &self.pattern.panels[index];
        let from = place::resolve(panel, &run.from, &format!("{pointer}/from"));
        let to = place::resolve(panel, &run.to, &format!("{pointer}/to"));
        let (from, to) = match (from, to) {
            (Ok(from), Ok(to)) if from.track != to.track => {
                return Err(vec![places_apart(panel, [from.track, to.track], pointer)]);
            }
            (Ok(from), Ok(to)) => (
                self.snap_to_known(index, from),
                self.snap_to_known(index, to),
            ),
            (from, to) => return Err([from.err(), to.err()].into_iter().flatten().collect()),
        };
        let topology = TrackTopology::of(panel, from.track);
        let places = (topology, [from.at, to.at]);
        let direction = direction(panel, run, places, pointer).map_err(|fault| vec![fault])?;
        if !topology.closed && from == to {
            return Err(vec![zero_length(panel, pointer)]);
        }
        let path = TrackPath {
            panel: index,
            track: from.track,
            direction,
            topology,
        };
        let mut stretches = path
            .walk(from.at, to.at, self.stretches_left)
            .ok_or_else(|| vec![too_long(pointer)])?;
        self.stretches_left -= stretches.len();
        stretches.retain(|s| s.length(self.pattern) > NEGLIGIBLE_M);
        let length: f64 = stretches.iter().map(|s| s.length(self.pattern)).sum();
        if length < MIN_SIDE_M || !length.is_finite() {
            return Err(vec![zero_length(panel, pointer)]);
        }
        Ok(RoutedRun {
            pointer: pointer.to_owned(),
            direction,
            stretches,
        })
    }

    /// Returns the point, or one named before that is as good as the same: a seam that ends where
    /// the next one begins, each by its own figure, must not leave a sliver between them.
    fn snap_to_known(&mut self, panel: usize, point: TrackPoint) -> TrackPoint {
        let TrackPosition::Inside { edge, at } = point.at else {
            return point;
        };
        let length = point.track.length(&self.pattern.panels[panel], edge);
        let known = self.inside.entry((panel, point.track, edge)).or_default();
        let near = |other: &f64| (other - at).abs() * length <= place::snap_distance(length);
        if let Some(&at) = known.iter().find(|other| near(other)) {
            let at = TrackPosition::Inside { edge, at };
            return TrackPoint { at, ..point };
        }
        known.push(at);
        point
    }

    fn unknown_panel(&mut self, name: &str, pointer: &str) -> Fault {
        let fault = Fault::new(
            SeamCode::UnknownPanel,
            format!("{pointer}/panel"),
            format!("the pattern has no panel `{name}`"),
        );
        if self.suggestions_left == 0 {
            return fault;
        }
        self.suggestions_left -= 1;
        let ids = self.pattern.panels.iter().map(|panel| panel.id.as_str());
        match nearest(name, ids.clone()) {
            Some(id) => fault.fix(format!("did you mean `{id}`?")),
            None => {
                let some: Vec<_> = ids.take(12).map(|id| format!("`{id}`")).collect();
                fault.fix(format!("the panels are {}", some.join(", ")))
            }
        }
    }
}

/// Returns the name of a track in a sentence.
fn track_name(track: Track) -> String {
    match track {
        Track::Outline => "the outline".to_owned(),
        Track::Hole(hole) => format!("hole {hole}"),
        Track::Line(line) => format!("internal line {line}"),
    }
}

fn places_apart(panel: &Panel, [from, to]: [Track; 2], pointer: &str) -> Fault {
    let detail = format!(
        "the run on `{}` begins on {} and ends on {}, and no way leads from the one to the other",
        panel.id,
        track_name(from),
        track_name(to)
    );
    Fault::new(SeamCode::PlacesApart, pointer, detail)
        .fix("pick both places on the outline, on the same hole or on the same internal line")
}

fn too_long(pointer: &str) -> Fault {
    Fault::new(
        SeamCode::TooLong,
        pointer,
        format!("the seams go over more than {MAX_STRETCHES} edges in all"),
    )
    .fix("take out runs that lie over one another")
}

fn zero_length(panel: &Panel, pointer: &str) -> Fault {
    Fault::new(
        SeamCode::ZeroLength,
        pointer,
        format!("the run on `{}` has no length", panel.id),
    )
    .fix("pick two corners that lie apart")
}
