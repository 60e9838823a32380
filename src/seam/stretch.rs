//! A stretch: a part of one edge, with a direction along it.

use super::Track;
use super::track::is_mirrored;
use crate::pattern::point::{distance, lerp};
use crate::pattern::{Pattern, Point2};

/// A part of one edge, with a direction along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Index of the panel in the pattern.
    pub panel: usize,
    /// The track of the panel that it lies on.
    pub track: Track,
    /// Index of the edge in that track; 0 on internal lines.
    pub edge: usize,
    /// Start: fraction of the edge's arc length, in the order of corners. Above `to` when it goes
    /// against the edge.
    pub from: f64,
    /// End, likewise.
    pub to: f64,
}

impl Stretch {
    /// Arc length \[m\].
    pub(crate) fn length(&self, pattern: &Pattern) -> f64 {
        let panel = &pattern.panels[self.panel];
        (self.to - self.from).abs() * self.track.length(panel, self.edge)
    }

    /// Returns the stretch gone from the end to the start.
    pub(super) fn reversed(&self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            ..*self
        }
    }

    /// Returns true if the cloth lies to its right in the drawing, as it does along a clockwise
    /// outline; nothing on internal lines, which have cloth on both sides.
    pub(super) fn has_cloth_on_right(&self, pattern: &Pattern) -> Option<bool> {
        if matches!(self.track, Track::Line(_)) {
            return None;
        }
        Some((self.to > self.from) != is_mirrored(&pattern.panels[self.panel]))
    }

    /// Returns the points where it begins and ends, in pattern coordinates \[m\].
    pub(super) fn ends(&self, pattern: &Pattern) -> [Point2; 2] {
        [0.0, 1.0].map(|share| self.point(pattern, share))
    }

    /// Returns the point at this share of its length, in pattern coordinates \[m\].
    pub(super) fn point(&self, pattern: &Pattern, share: f64) -> Point2 {
        let panel = &pattern.panels[self.panel];
        let at = self.from + share * (self.to - self.from);
        let length = self.track.length(panel, self.edge);
        point_at(self.track.points(panel, self.edge), at * length)
    }
}

/// Returns the point of a polyline at this arc length.
fn point_at(points: &[Point2], at: f64) -> Point2 {
    let mut left = at;
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        if left <= length && length > 0.0 {
            return lerp(pair[0], pair[1], left / length);
        }
        left -= length;
    }
    points.last().copied().unwrap_or_default()
}
