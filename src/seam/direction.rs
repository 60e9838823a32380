//! Direction of a run: its places tell it where only one is possible, else the client must.

use super::place::{self, TrackPosition, TrackTopology};
use crate::fault::{Fault, SeamCode};
use crate::pattern::{Direction, OutlineRun, Panel};

/// Returns the direction of `run` between places that lie on one track.
///
/// # Errors
/// A direction that is needed and not given, or given and not that of the places.
pub(super) fn direction(
    panel: &Panel,
    run: &OutlineRun,
    (topology, [from, to]): (TrackTopology, [TrackPosition; 2]),
    pointer: &str,
) -> Result<Direction, Fault> {
    let directions = place::directions_along_one_edge(from, to, topology);
    // On a ring of one edge either way leads from any place to any other.
    let one_edge = topology.closed && topology.edges == 1;
    match (directions.as_slice(), run.direction) {
        ([only], None) => Ok(*only),
        ([only], Some(given)) if given != *only && !one_edge => {
            Err(direction_contradicts(panel, [*only, given], pointer))
        }
        (_, Some(given)) => Ok(given),
        (_, None) if from == to && !topology.closed => Ok(Direction::Cw),
        (_, None) => Err(direction_needed(panel, topology, from == to, pointer)),
    }
}

fn direction_contradicts(panel: &Panel, [only, given]: [Direction; 2], pointer: &str) -> Fault {
    Fault::new(
        SeamCode::DirectionContradicts,
        format!("{pointer}/direction"),
        format!(
            "picked in this order the edge of `{}` runs {}, not {}",
            panel.id,
            word(only),
            word(given)
        ),
    )
    .fix(format!(
        "leave `direction` out, or swap `from` and `to` if the edge is to be sewn {}",
        word(given)
    ))
}

fn direction_needed(
    panel: &Panel,
    topology: TrackTopology,
    same_place: bool,
    pointer: &str,
) -> Fault {
    let (why, fix) = if same_place {
        (
            "begins and ends at the same place",
            "pick two different corners, or give `direction` (`cw` or `ccw`) to sew the whole outline round",
        )
    } else if topology.edges <= 2 {
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
        SeamCode::DirectionNeeded,
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
