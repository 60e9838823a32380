//! From the runs of a side as asked to the stretches of edges they go along.

use super::Stretch;
use super::place::{self, Spot};
use crate::fault::{Fault, nearest};
use crate::pattern::{Direction, Panel, Pattern, Run, Side};
use std::collections::BTreeMap;

/// Stretches that all seams of one request may have together: bounds the memory that long runs laid many times over one another would take.
const STRETCHES: usize = 200_000;

/// How many misspelt names get a suggestion: the rest of a request full of them would only cost time.
const SUGGESTIONS: usize = 100;

/// Sides shorter than this are nothing to sew \[m\]: outlines are read to a few micrometres.
const SHORTEST_M: f64 = 1e-5;

/// Stretches no longer than this are left out of a run \[m\]: far below what a drawing resolves, far above rounding.
const NOTHING_M: f64 = 1e-7;

/// One run whose places are known.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Leg {
    /// Where in the request it stands.
    pub pointer: String,
    /// Which way round it goes.
    pub direction: Direction,
    /// The stretches it goes along, in order; none of them without length.
    pub stretches: Vec<Stretch>,
}

impl Leg {
    /// The same stretches gone from the end to the start.
    pub(super) fn reversed(&self) -> Self {
        Self {
            pointer: self.pointer.clone(),
            direction: place::opposite(self.direction),
            stretches: self.stretches.iter().rev().map(|s| s.reversed()).collect(),
        }
    }
}

/// Turns sides as asked into legs and keeps the bounds on the work that a request may cause.
pub(super) struct Resolver<'a> {
    pattern: &'a Pattern,
    panels: BTreeMap<&'a str, usize>,
    /// Places inside edges that runs have named so far, by panel and edge.
    inside: BTreeMap<(usize, usize), Vec<f64>>,
    stretches_left: usize,
    suggestions_left: usize,
}

impl<'a> Resolver<'a> {
    pub(super) fn new(pattern: &'a Pattern) -> Self {
        let panels = pattern.panels.iter().enumerate().rev();
        Self {
            pattern,
            panels: panels
                .map(|(index, panel)| (panel.id.as_str(), index))
                .collect(),
            inside: BTreeMap::new(),
            stretches_left: STRETCHES,
            suggestions_left: SUGGESTIONS,
        }
    }

    /// The legs of `side`, which stands at `pointer`; the faults of all its runs if there are any.
    pub(super) fn side(&mut self, side: &Side, pointer: &str) -> Result<Vec<Leg>, Vec<Fault>> {
        let mut legs = vec![];
        let mut faults = vec![];
        for (i, run) in side.runs().iter().enumerate() {
            let at = match side {
                Side::One(_) => pointer.to_owned(),
                Side::Many(_) => format!("{pointer}/{i}"),
            };
            match self.run(run, &at) {
                Ok(leg) => legs.push(leg),
                Err(more) => faults.extend(more),
            }
        }
        if side.runs().is_empty() {
            faults.push(
                Fault::new(
                    "seam/empty_side",
                    pointer,
                    "this side of the seam has no run",
                )
                .fix("pick at least one edge for each side, or take the seam out"),
            );
        }
        if faults.is_empty() {
            Ok(legs)
        } else {
            Err(faults)
        }
    }

    fn run(&mut self, run: &Run, pointer: &str) -> Result<Leg, Vec<Fault>> {
        let Some(&index) = self.panels.get(run.panel.as_str()) else {
            return Err(vec![self.unknown_panel(&run.panel, pointer)]);
        };
        let panel = &self.pattern.panels[index];
        let from = place::find(panel, &run.from, &format!("{pointer}/from"));
        let to = place::find(panel, &run.to, &format!("{pointer}/to"));
        let (from, to) = match (from, to) {
            (Ok(from), Ok(to)) => (self.joined(index, from), self.joined(index, to)),
            (from, to) => return Err([from.err(), to.err()].into_iter().flatten().collect()),
        };
        let direction = direction(panel, run, [from, to], pointer).map_err(|fault| vec![fault])?;
        let way = Way {
            panel: index,
            direction,
            n: panel.edges.len(),
        };
        let mut stretches = way
            .walk(from, to, self.stretches_left)
            .ok_or_else(|| vec![too_long(pointer)])?;
        self.stretches_left -= stretches.len();
        stretches.retain(|s| s.length(self.pattern) > NOTHING_M);
        let length: f64 = stretches.iter().map(|s| s.length(self.pattern)).sum();
        if length < SHORTEST_M || !length.is_finite() {
            return Err(vec![zero_length(panel, pointer)]);
        }
        Ok(Leg {
            pointer: pointer.to_owned(),
            direction,
            stretches,
        })
    }

    /// The same spot, or one named before that is as good as the same: a seam that ends where the next one
    /// begins, each by its own figure, must not leave a sliver between them.
    fn joined(&mut self, panel: usize, spot: Spot) -> Spot {
        let Spot::Inside { edge, at } = spot else {
            return spot;
        };
        let length = self.pattern.panels[panel].edges[edge].length_m;
        let known = self.inside.entry((panel, edge)).or_default();
        let near = |other: &f64| (other - at).abs() * length <= place::snap_distance(length);
        match known.iter().find(|other| near(other)) {
            Some(&at) => Spot::Inside { edge, at },
            None => {
                known.push(at);
                spot
            }
        }
    }

    fn unknown_panel(&mut self, name: &str, pointer: &str) -> Fault {
        let fault = Fault::new(
            "seam/unknown_panel",
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

/// Which way `run` goes: the edge between its places says so where there is just one, else the client must.
fn direction(panel: &Panel, run: &Run, ends: [Spot; 2], pointer: &str) -> Result<Direction, Fault> {
    let [from, to] = ends;
    let ways = place::ways_along_one_edge(from, to, panel.edges.len());
    match (ways.as_slice(), run.direction) {
        ([way], None) => Ok(*way),
        ([way], Some(given)) if given != *way => Err(Fault::new(
            "seam/direction_contradicts",
            format!("{pointer}/direction"),
            format!(
                "picked in this order the edge of `{}` runs {}, not {}",
                panel.id,
                word(*way),
                word(given)
            ),
        )
        .fix(format!(
            "leave `direction` out, or swap `from` and `to` if the edge is to be sewn {}",
            word(given)
        ))),
        (_, Some(given)) => Ok(given),
        (_, None) => Err(direction_needed(panel, from == to, pointer)),
    }
}

fn direction_needed(panel: &Panel, closed: bool, pointer: &str) -> Fault {
    let (why, fix) = if closed {
        (
            "begins and ends at the same place",
            "pick two different corners, or give `direction` (`cw` or `ccw`) to sew the whole outline round",
        )
    } else if panel.edges.len() <= 2 {
        (
            "joins two places that more than one edge joins",
            "give `direction`: `cw` for the edge that leaves `from` clockwise, `ccw` for the other one",
        )
    } else {
        (
            "joins two places that do not lie on one edge",
            "pick two neighbouring corners, or give `direction` (`cw` or `ccw`) to go over several edges",
        )
    };
    Fault::new(
        "seam/direction_needed",
        format!("{pointer}/direction"),
        format!(
            "the run on `{}` {why}, so it is not plain which way it goes",
            panel.id
        ),
    )
    .fix(fix)
}

fn word(direction: Direction) -> &'static str {
    match direction {
        Direction::Cw => "clockwise (`cw`)",
        Direction::Ccw => "counter-clockwise (`ccw`)",
    }
}

fn too_long(pointer: &str) -> Fault {
    Fault::new(
        "seam/too_long",
        pointer,
        format!("the seams go over more than {STRETCHES} edges in all"),
    )
    .fix("take out runs that lie over one another")
}

fn zero_length(panel: &Panel, pointer: &str) -> Fault {
    Fault::new(
        "seam/zero_length",
        pointer,
        format!("the run on `{}` has no length", panel.id),
    )
    .fix("pick two corners that lie apart")
}

/// A way round an outline of `n` edges.
struct Way {
    panel: usize,
    direction: Direction,
    n: usize,
}

impl Way {
    /// The stretches from one spot to the other, the whole outline where they are the same; nothing if more than `limit`.
    fn walk(&self, from: Spot, to: Spot, limit: usize) -> Option<Vec<Stretch>> {
        let (mut edge, mut at) = from.leaving(self.direction, self.n);
        let (last, end) = to.reaching(self.direction, self.n);
        let mut stretches = vec![];
        while stretches.len() < limit {
            let ahead = match self.direction {
                Direction::Cw => end > at,
                Direction::Ccw => end < at,
            };
            let here = |to| Stretch {
                panel: self.panel,
                edge,
                from: at,
                to,
            };
            if edge == last && ahead {
                stretches.push(here(end));
                return Some(stretches);
            }
            match self.direction {
                Direction::Cw => {
                    stretches.push(here(1.0));
                    (edge, at) = ((edge + 1) % self.n, 0.0);
                }
                Direction::Ccw => {
                    stretches.push(here(0.0));
                    (edge, at) = ((edge + self.n - 1) % self.n, 1.0);
                }
            }
        }
        None
    }
}
