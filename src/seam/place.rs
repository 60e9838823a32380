//! From a requested [`Place`] to a [`TrackPoint`] on an outline, a hole or an internal line.

use super::Track;
use crate::fault::{Fault, SeamCode};
use crate::pattern::{Direction, Panel, Place};

/// Places nearer than this to a corner are that corner \[m\]: the gap up to which a seam counts as
/// closed, so the shift cannot be told from sewing, while a mesh edge that short would be a sliver.
const SNAP_M: f64 = 1e-3;

/// Snap distance as a share of the edge, so that very short edges keep their inner places.
const SNAP_SHARE: f64 = 0.05;

/// Distance along an edge of this length \[m\] below which two places on it are one.
pub(super) fn snap_distance(edge_length: f64) -> f64 {
    SNAP_M.min(SNAP_SHARE * edge_length)
}

/// A point of a panel that is known to exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrackPoint {
    pub track: Track,
    pub at: TrackPosition,
}

/// A point of a track. A corner is always `Corner`, so its fractions 0 and 1 are exact; the ends of
/// an open line are its corners 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TrackPosition {
    Corner(usize),
    Inside { edge: usize, at: f64 },
}

/// Number of edges of a track, and whether the last one leads back to the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TrackTopology {
    pub edges: usize,
    pub closed: bool,
}

impl TrackTopology {
    pub(super) fn of(panel: &Panel, track: Track) -> Self {
        Self {
            edges: track.edge_count(panel),
            closed: track.is_closed(panel),
        }
    }

    /// The corner at which an edge ends.
    fn corner_after(self, edge: usize) -> usize {
        if self.closed {
            (edge + 1) % self.edges
        } else {
            edge + 1
        }
    }
}

impl TrackPosition {
    /// Each edge this lies on, with the fraction there.
    fn incidences(self, topology: TrackTopology) -> impl Iterator<Item = (usize, f64)> {
        let ways = [Direction::Cw, Direction::Ccw].map(|way| self.leaving(way, topology));
        let [ahead, behind] = ways;
        ahead.into_iter().chain(behind.filter(|_| ahead != behind))
    }

    /// Returns the edge and fraction from which a path in `direction` leaves; nothing at the end of
    /// an open line.
    pub(super) fn leaving(
        self,
        direction: Direction,
        topology: TrackTopology,
    ) -> Option<(usize, f64)> {
        let n = topology.edges;
        match (self, direction) {
            (Self::Corner(k), Direction::Cw) if k < n => Some((k, 0.0)),
            (Self::Corner(k), Direction::Ccw) if k > 0 => Some((k - 1, 1.0)),
            (Self::Corner(_), Direction::Ccw) if topology.closed => Some((n - 1, 1.0)),
            (Self::Corner(_), _) => None,
            (Self::Inside { edge, at }, _) => Some((edge, at)),
        }
    }

    /// Returns the edge and fraction at which a path in `direction` arrives.
    pub(super) fn reaching(
        self,
        direction: Direction,
        topology: TrackTopology,
    ) -> Option<(usize, f64)> {
        self.leaving(opposite(direction), topology)
    }
}

/// Returns the opposite direction.
pub(super) fn opposite(direction: Direction) -> Direction {
    match direction {
        Direction::Cw => Direction::Ccw,
        Direction::Ccw => Direction::Cw,
    }
}

/// Returns the directions from one point to another along a single edge: none, one, or more than
/// one on rings of one or two edges.
pub(super) fn directions_along_one_edge(
    from: TrackPosition,
    to: TrackPosition,
    topology: TrackTopology,
) -> Vec<Direction> {
    let mut ways = vec![];
    for (edge_from, at_from) in from.incidences(topology) {
        for (edge_to, at_to) in to.incidences(topology) {
            if edge_from == edge_to && at_from < at_to {
                ways.push(Direction::Cw);
            } else if edge_from == edge_to && at_from > at_to {
                ways.push(Direction::Ccw);
            }
        }
    }
    ways
}

/// Finds `place` on `panel`.
///
/// # Errors
/// Corner, edge, notch, hole or line that the panel does not have; a fraction that is not between 0
/// and 1.
pub(super) fn resolve(panel: &Panel, place: &Place, pointer: &str) -> Result<TrackPoint, Fault> {
    let resolver = PlaceResolver { panel, pointer };
    match *place {
        Place::Corner(corner) => resolver.corner(Track::Outline, corner),
        Place::OnEdge { edge, at } => resolver.inside(Track::Outline, edge, at),
        Place::AtNotch { notch } => match panel.notches.get(notch) {
            Some(found) if found.edge < panel.edges.len() && (0.0..=1.0).contains(&found.at) => {
                Ok(resolver.snapped(Track::Outline, found.edge, found.at))
            }
            _ => Err(resolver.missing("notch", notch, panel.notches.len(), "")),
        },
        Place::HoleCorner { hole, corner } => {
            resolver.corner(resolver.inner_track("hole", hole)?, corner)
        }
        Place::OnHoleEdge { hole, edge, at } => {
            resolver.inside(resolver.inner_track("hole", hole)?, edge, at)
        }
        Place::OnLine { line, at } => resolver.inside(resolver.inner_track("line", line)?, 0, at),
    }
}

struct PlaceResolver<'a> {
    panel: &'a Panel,
    pointer: &'a str,
}

impl PlaceResolver<'_> {
    /// The hole or line of this index.
    fn inner_track(&self, what: &str, index: usize) -> Result<Track, Fault> {
        let (track, count) = match what {
            "hole" => (Track::Hole(index), self.panel.holes.len()),
            _ => (Track::Line(index), self.panel.internal_lines.len()),
        };
        if index < count {
            Ok(track)
        } else {
            Err(self.missing(what, index, count, ""))
        }
    }

    fn corner(&self, track: Track, corner: usize) -> Result<TrackPoint, Fault> {
        let count = match track {
            Track::Hole(hole) => self.panel.holes[hole].corners.len(),
            _ => self.panel.corners.len(),
        };
        if corner < count.min(track.edge_count(self.panel)) {
            Ok(TrackPoint {
                track,
                at: TrackPosition::Corner(corner),
            })
        } else {
            Err(self.missing("corner", corner, count, &of_track(track)))
        }
    }

    fn inside(&self, track: Track, edge: usize, at: f64) -> Result<TrackPoint, Fault> {
        let count = track.edge_count(self.panel);
        if edge >= count {
            return Err(self.missing("edge", edge, count, &of_track(track)));
        }
        if !(0.0..=1.0).contains(&at) {
            let of = match track {
                Track::Outline => format!("edge {edge}"),
                Track::Hole(hole) => format!("edge {edge} of hole {hole}"),
                Track::Line(line) => format!("line {line}"),
            };
            let detail = format!("{at} is not a fraction of {of} of `{}`", self.panel.id);
            let fix = "give `at` as a number from 0 (start, in the order of corners) to 1 (end)";
            return Err(Fault::new(SeamCode::BadFraction, self.pointer, detail).fix(fix));
        }
        Ok(self.snapped(track, edge, at))
    }

    fn snapped(&self, track: Track, edge: usize, at: f64) -> TrackPoint {
        let topology = TrackTopology::of(self.panel, track);
        let length = track.length(self.panel, edge);
        let snap = snap_distance(length);
        let at = if at * length <= snap {
            TrackPosition::Corner(edge)
        } else if (1.0 - at) * length <= snap {
            TrackPosition::Corner(topology.corner_after(edge))
        } else {
            TrackPosition::Inside { edge, at }
        };
        TrackPoint { track, at }
    }

    fn missing(&self, what: &str, index: usize, count: usize, of: &str) -> Fault {
        let id = &self.panel.id;
        let plural = if what == "notch" {
            "notches"
        } else {
            &format!("{what}s")
        };
        let fix = match count {
            0 => format!("`{id}` has no {plural}{of}: give the place in another way"),
            1 => format!("`{id}` has only {what} 0{of}"),
            _ => format!("`{id}` has {plural} 0 to {}{of}", count - 1),
        };
        let detail = format!("panel `{id}` has no {what} {index}{of}");
        let code = match what {
            "corner" => SeamCode::UnknownCorner,
            "edge" => SeamCode::UnknownEdge,
            "hole" => SeamCode::UnknownHole,
            "line" => SeamCode::UnknownLine,
            _ => SeamCode::UnknownNotch,
        };
        Fault::new(code, self.pointer, detail).fix(fix)
    }
}

/// Returns what a corner or edge belongs to, where that is not the outline.
fn of_track(track: Track) -> String {
    match track {
        Track::Hole(hole) => format!(" of hole {hole}"),
        Track::Outline | Track::Line(_) => String::new(),
    }
}
