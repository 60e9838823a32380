//! What stretches lie on: outlines, holes and internal lines, each as a row of edges.

use super::{Stretch, Track};
use crate::pattern::{Edge, Panel, Pattern};

/// An internal line whose ends are nearer than this is closed \[m\]: outlines are read to a few micrometres.
const CLOSED_M: f64 = 1e-5;

impl Track {
    /// The edges of an outline or a hole; nothing for lines and for holes that are not there.
    fn edges(self, panel: &Panel) -> &[Edge] {
        match self {
            Self::Outline => &panel.edges,
            Self::Hole(hole) => panel.holes.get(hole).map_or(&[], |hole| &hole.edges),
            Self::Line(_) => &[],
        }
    }

    /// How many edges it has; none if the panel has no such track.
    pub(crate) fn edge_count(self, panel: &Panel) -> usize {
        match self {
            Self::Line(line) => usize::from(panel.internal_lines.get(line).is_some()),
            ring => ring.edges(panel).len(),
        }
    }

    /// Whether its last edge ends where its first one begins.
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

    /// The polyline of one of its edges \[m\]; empty if it is not there.
    pub(crate) fn points(self, panel: &Panel, edge: usize) -> &[[f64; 2]] {
        let points = match self {
            Self::Line(line) => panel.internal_lines.get(line).filter(|_| edge == 0),
            ring => ring.edges(panel).get(edge).map(|edge| &edge.points),
        };
        points.map_or(&[], Vec::as_slice)
    }

    /// Arc length of one of its edges \[m\].
    pub(super) fn length(self, panel: &Panel, edge: usize) -> f64 {
        match self {
            Self::Line(_) => {
                let points = self.points(panel, edge);
                points.windows(2).map(|p| distance(p[0], p[1])).sum()
            }
            ring => ring
                .edges(panel)
                .get(edge)
                .map_or(0.0, |edge| edge.length_m),
        }
    }
}

/// Whether a panel is the mirrored copy of another: its corners are numbered as its source's, so in space they run the other way round.
pub(super) fn is_mirrored(panel: &Panel) -> bool {
    panel.copy_of.is_some()
}

impl Stretch {
    /// Arc length \[m\].
    pub(super) fn length(&self, pattern: &Pattern) -> f64 {
        let panel = &pattern.panels[self.panel];
        (self.to - self.from).abs() * self.track.length(panel, self.edge)
    }

    /// The same, gone from the end to the start.
    pub(super) fn reversed(&self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            ..*self
        }
    }

    /// Whether it runs so that the cloth lies to its right in the drawing, as it does along a clockwise outline;
    /// nothing on internal lines, which have cloth on both sides.
    pub(super) fn has_cloth_on_right(&self, pattern: &Pattern) -> Option<bool> {
        if matches!(self.track, Track::Line(_)) {
            return None;
        }
        Some((self.to > self.from) != is_mirrored(&pattern.panels[self.panel]))
    }

    /// Points where it begins and ends, in pattern coordinates \[m\].
    pub(super) fn ends(&self, pattern: &Pattern) -> [[f64; 2]; 2] {
        [0.0, 1.0].map(|share| self.point(pattern, share))
    }

    /// The point at this share of its way, in pattern coordinates \[m\].
    pub(super) fn point(&self, pattern: &Pattern, share: f64) -> [f64; 2] {
        let panel = &pattern.panels[self.panel];
        let at = self.from + share * (self.to - self.from);
        let length = self.track.length(panel, self.edge);
        point_at(self.track.points(panel, self.edge), at * length)
    }
}

/// The point of a polyline at this arc length.
fn point_at(points: &[[f64; 2]], at: f64) -> [f64; 2] {
    let mut left = at;
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        if left <= length && length > 0.0 {
            let share = left / length;
            return [0, 1].map(|k| pair[0][k] + share * (pair[1][k] - pair[0][k]));
        }
        left -= length;
    }
    points.last().copied().unwrap_or_default()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
