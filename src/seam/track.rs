//! Tracks that stretches lie on: outlines, holes and internal lines, each a sequence of edges.

use crate::pattern::point::distance;
use crate::pattern::{Edge, Panel, Point2, polyline};

/// An internal line whose ends are nearer than this is closed \[m\]: outlines are read to a few
/// micrometers.
const CLOSED_M: f64 = 1e-5;

/// Track of a panel that stretches lie on: a sequence of edges numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Track {
    /// The outline.
    Outline,
    /// A hole, by index.
    Hole(usize),
    /// An internal line, by index. It counts as one edge, from its first point to its last.
    Line(usize),
}

impl Track {
    /// Returns the edges of an outline or a hole; nothing for lines and for holes that are not
    /// there.
    fn edges(self, panel: &Panel) -> &[Edge] {
        match self {
            Self::Outline => &panel.edges,
            Self::Hole(hole) => panel.holes.get(hole).map_or(&[], |hole| &hole.edges),
            Self::Line(_) => &[],
        }
    }

    /// Returns the number of its edges; none if the panel has no such track.
    pub(crate) fn edge_count(self, panel: &Panel) -> usize {
        match self {
            Self::Line(line) => usize::from(panel.internal_lines.get(line).is_some()),
            ring => ring.edges(panel).len(),
        }
    }

    /// Returns true if its last edge ends where its first one begins.
    pub(crate) fn is_closed(self, panel: &Panel) -> bool {
        let Self::Line(line) = self else { return true };
        let points = panel
            .internal_lines
            .get(line)
            .map_or(&[][..], Vec::as_slice);
        match points {
            [first, _, _, .., last] => distance(*first, *last) <= CLOSED_M,
            _ => false,
        }
    }

    /// Returns the polyline of one of its edges \[m\]; empty if it is not there.
    pub(crate) fn points(self, panel: &Panel, edge: usize) -> &[Point2] {
        let points = match self {
            Self::Line(line) => panel.internal_lines.get(line).filter(|_| edge == 0),
            ring => ring.edges(panel).get(edge).map(|edge| &edge.points),
        };
        points.map_or(&[], Vec::as_slice)
    }

    /// Returns the arc length of one of its edges \[m\].
    pub(super) fn length(self, panel: &Panel, edge: usize) -> f64 {
        match self {
            Self::Line(_) => polyline::length(self.points(panel, edge)),
            ring => ring
                .edges(panel)
                .get(edge)
                .map_or(0.0, |edge| edge.length_m),
        }
    }
}

/// Returns true for the mirrored copy of another panel: its corners are numbered as its source's,
/// so in space they run the other way round.
pub(super) fn is_mirrored(panel: &Panel) -> bool {
    panel.copy_of.is_some()
}
