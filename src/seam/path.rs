//! Path along a track from one point to another.

use super::place::{TrackPosition, TrackTopology};
use super::{Stretch, Track};
use crate::pattern::Direction;

/// A direction along a track of a panel.
pub(super) struct TrackPath {
    pub panel: usize,
    pub track: Track,
    pub direction: Direction,
    pub topology: TrackTopology,
}

impl TrackPath {
    /// Returns the stretches from one point to the other, all round where they are the same;
    /// nothing if more than `limit`, or if an open line ends before.
    pub(super) fn walk(
        &self,
        from: TrackPosition,
        to: TrackPosition,
        limit: usize,
    ) -> Option<Vec<Stretch>> {
        let (mut edge, mut at) = from.leaving(self.direction, self.topology)?;
        let (last, end) = to.reaching(self.direction, self.topology)?;
        let mut stretches = vec![];
        while stretches.len() < limit {
            let ahead = match self.direction {
                Direction::Cw => end > at,
                Direction::Ccw => end < at,
            };
            let here = |to| Stretch {
                panel: self.panel,
                track: self.track,
                edge,
                from: at,
                to,
            };
            if edge == last && ahead {
                stretches.push(here(end));
                return Some(stretches);
            }
            if !self.topology.closed {
                return None;
            }
            let n = self.topology.edges;
            match self.direction {
                Direction::Cw => {
                    stretches.push(here(1.0));
                    (edge, at) = ((edge + 1) % n, 0.0);
                }
                Direction::Ccw => {
                    stretches.push(here(0.0));
                    (edge, at) = ((edge + n - 1) % n, 1.0);
                }
            }
        }
        None
    }
}
