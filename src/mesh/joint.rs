//! Ends of internal lines that lie on an outline, a hole or another line: both get one vertex there.

use super::divide::PanelDivision;
use super::geometry::{self, Point};
use crate::pattern::Panel;

/// Ends nearer than this to another edge lie on it \[m\]: the gap up to which a seam counts as closed.
const JOINED_M: f64 = 1e-3;

/// The end of an internal line that lies on another edge. Both are numbers of edges in [`super::slots::Slots`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint {
    /// The line.
    pub(super) line: usize,
    /// Whether it is its last point.
    pub(super) last: bool,
    /// The edge that it lies on.
    pub(super) on: usize,
    /// Fraction of that edge's arc length.
    pub(super) at: f64,
}

/// Where a point is nearest to an edge.
struct Near {
    distance: f64,
    slot: usize,
    at: f64,
}

/// Finds the joints of a panel's lines.
///
/// Of two lines that meet end to end, the later one is joined to the earlier one. A joint next to a break is put on it.
pub(super) fn find(panel: &Panel, divided: &PanelDivision) -> Vec<Joint> {
    let mut joints = vec![];
    let first_line = divided.slots.first_line();
    for line in first_line..divided.divisions.len() {
        let points = divided.points(panel, line);
        let (Some(first), Some(last)) = (points.first(), points.last()) else {
            continue;
        };
        if divided.is_closed(panel, line) {
            continue;
        }
        for (end, last) in [(*first, false), (*last, true)] {
            let near = (0..divided.divisions.len())
                .filter(|&slot| slot != line)
                .map(|slot| nearest(divided.points(panel, slot), end, slot))
                .filter(|near| {
                    let length = divided.divisions[near.slot].length;
                    let from_end = near.at.min(1.0 - near.at) * length;
                    near.distance <= JOINED_M && (near.slot < line || from_end > JOINED_M)
                })
                .min_by(|a, b| a.distance.total_cmp(&b.distance));
            joints.extend(near.map(|near| Joint {
                line,
                last,
                on: near.slot,
                at: divided.divisions[near.slot].near_break(near.at, JOINED_M),
            }));
        }
    }
    joints
}

fn nearest(points: &[Point], p: Point, slot: usize) -> Near {
    let length = geometry::length(points);
    let mut best = Near {
        distance: f64::INFINITY,
        slot,
        at: 0.0,
    };
    let mut passed = 0.0;
    for pair in points.windows(2) {
        let span = geometry::distance(pair[0], pair[1]);
        let share = geometry::share_along(p, [pair[0], pair[1]]);
        let distance = geometry::distance(p, geometry::lerp(pair[0], pair[1], share));
        if distance < best.distance {
            best.distance = distance;
            best.at = (passed + share * span) / length;
        }
        passed += span;
    }
    best
}
