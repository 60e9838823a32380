//! From a [`Place`] as asked to a [`Spot`] on an outline.

use crate::fault::Fault;
use crate::pattern::{Direction, Panel, Place};

/// Places nearer than this to a corner are that corner \[m\]: the gap up to which a seam counts as closed,
/// so the shift cannot be told from sewing, while a mesh edge that short would be a sliver.
const SNAP_M: f64 = 1e-3;

/// The same as a share of the edge, so that very short edges keep their inner places.
const SNAP_SHARE: f64 = 0.05;

/// Distance along an edge of this length \[m\] below which two places on it are one.
pub(super) fn snap_distance(edge_length: f64) -> f64 {
    SNAP_M.min(SNAP_SHARE * edge_length)
}

/// A point of an outline that is known to exist. A corner is always `Corner`, so its fractions 0 and 1 are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spot {
    Corner(usize),
    Inside { edge: usize, at: f64 },
}

impl Spot {
    /// Each edge this lies on, with the fraction there. `n` edges in all.
    fn incidences(self, n: usize) -> Vec<(usize, f64)> {
        match self {
            Self::Corner(k) => vec![(k, 0.0), ((k + n - 1) % n, 1.0)],
            Self::Inside { edge, at } => vec![(edge, at)],
        }
    }

    /// The edge and fraction from which a way in `direction` leaves.
    pub(super) fn leaving(self, direction: Direction, n: usize) -> (usize, f64) {
        match (self, direction) {
            (Self::Corner(k), Direction::Cw) => (k, 0.0),
            (Self::Corner(k), Direction::Ccw) => ((k + n - 1) % n, 1.0),
            (Self::Inside { edge, at }, _) => (edge, at),
        }
    }

    /// The edge and fraction at which a way in `direction` arrives.
    pub(super) fn reaching(self, direction: Direction, n: usize) -> (usize, f64) {
        self.leaving(opposite(direction), n)
    }
}

/// The other way round.
pub(super) fn opposite(direction: Direction) -> Direction {
    match direction {
        Direction::Cw => Direction::Ccw,
        Direction::Ccw => Direction::Cw,
    }
}

/// The ways from one spot to another along a single edge: none, one, or more than one on outlines of one or two edges.
pub(super) fn ways_along_one_edge(from: Spot, to: Spot, n: usize) -> Vec<Direction> {
    let mut ways = vec![];
    for (edge_from, at_from) in from.incidences(n) {
        for (edge_to, at_to) in to.incidences(n) {
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
/// Corner, edge or notch that the panel does not have; a fraction that is not between 0 and 1.
pub(super) fn find(panel: &Panel, place: &Place, pointer: &str) -> Result<Spot, Fault> {
    match *place {
        Place::Corner(corner) if corner < panel.corners.len() => Ok(Spot::Corner(corner)),
        Place::Corner(corner) => Err(missing(
            panel,
            "corner",
            corner,
            panel.corners.len(),
            pointer,
        )),
        Place::OnEdge { edge, at } => {
            if edge >= panel.edges.len() {
                return Err(missing(panel, "edge", edge, panel.edges.len(), pointer));
            }
            if !(0.0..=1.0).contains(&at) {
                return Err(Fault::new(
                    "seam/bad_fraction",
                    pointer,
                    format!("{at} is not a fraction of edge {edge} of `{}`", panel.id),
                )
                .fix(
                    "give `at` as a number from 0 (start of the edge, clockwise) to 1 (its end)",
                ));
            }
            Ok(snapped(panel, edge, at))
        }
        Place::AtNotch { notch } => match panel.notches.get(notch) {
            Some(found) if found.edge < panel.edges.len() && (0.0..=1.0).contains(&found.at) => {
                Ok(snapped(panel, found.edge, found.at))
            }
            _ => Err(missing(panel, "notch", notch, panel.notches.len(), pointer)),
        },
    }
}

fn missing(panel: &Panel, what: &str, index: usize, count: usize, pointer: &str) -> Fault {
    let plural = if what == "notch" {
        "notches"
    } else {
        &format!("{what}s")
    };
    let fix = match count {
        0 => format!(
            "`{}` has no {plural}: give the place in another way",
            panel.id
        ),
        1 => format!("`{}` has only {what} 0", panel.id),
        _ => format!("`{}` has {plural} 0 to {}", panel.id, count - 1),
    };
    Fault::new(
        &format!("seam/unknown_{what}"),
        pointer,
        format!("panel `{}` has no {what} {index}", panel.id),
    )
    .fix(fix)
}

fn snapped(panel: &Panel, edge: usize, at: f64) -> Spot {
    let length = panel.edges[edge].length_m;
    let snap = snap_distance(length);
    if at * length <= snap {
        Spot::Corner(edge)
    } else if (1.0 - at) * length <= snap {
        Spot::Corner((edge + 1) % panel.edges.len())
    } else {
        Spot::Inside { edge, at }
    }
}
