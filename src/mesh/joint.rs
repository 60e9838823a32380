//! Ends of internal lines that lie on an outline, a hole or another line: both get one vertex
//! there.

use super::geometry;
use super::panel_division::{LineJoint, PanelDivision};
use crate::pattern::Panel;
use crate::pattern::point::{self, Point2};
use crate::pattern::polyline;

/// Ends nearer than this to another edge lie on it \[m\]: the gap up to which a seam counts as
/// closed.
const JOINED_M: f64 = 1e-3;

/// The point of an edge that is nearest to a given one.
struct NearestOnEdge {
    distance: f64,
    slot: usize,
    at: f64,
}

/// Finds the joints of a panel's lines.
///
/// Of two lines that meet end to end, the later one is joined to the earlier one. A joint next to a
/// break is put on it.
pub(super) fn find(panel: &Panel, divided: &PanelDivision) -> Vec<LineJoint> {
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
            joints.extend(near.map(|near| LineJoint {
                line,
                last,
                on: near.slot,
                at: divided.divisions[near.slot].near_break(near.at, JOINED_M),
            }));
        }
    }
    joints
}

fn nearest(points: &[Point2], p: Point2, slot: usize) -> NearestOnEdge {
    let length = polyline::length(points);
    let mut best = NearestOnEdge {
        distance: f64::INFINITY,
        slot,
        at: 0.0,
    };
    let mut passed = 0.0;
    for pair in points.windows(2) {
        let span = point::distance(pair[0], pair[1]);
        let share = geometry::share_along(p, [pair[0], pair[1]]);
        let distance = point::distance(p, point::lerp(pair[0], pair[1], share));
        if distance < best.distance {
            best.distance = distance;
            best.at = (passed + share * span) / length;
        }
        passed += span;
    }
    best
}
