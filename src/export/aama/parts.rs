//! The parts of a panel that are drawn, whole or of one half.

use crate::pattern::outline::ring_of;
use crate::pattern::point::{Point2, distance, lerp};
use crate::pattern::{Hole, NotchKind, Panel};

/// The parts of a panel that are drawn.
#[derive(Clone, Debug)]
pub(super) struct PanelParts<'a> {
    /// The outline, closed; its first point is a corner where it is whole.
    pub(super) outline: Vec<Point2>,
    /// Point by point, true if it is a corner.
    pub(super) is_corner: Vec<bool>,
    /// The cut line; empty where it is the outline.
    pub(super) cut_line: Vec<Point2>,
    /// True if the cut line is closed, or ends on the fold.
    pub(super) is_cut_closed: bool,
    /// The fold, from end to end, where a half is drawn.
    pub(super) fold: Option<[Point2; 2]>,
    pub(super) notches: Vec<PlacedNotch>,
    pub(super) drills: Vec<Point2>,
    pub(super) holes: Vec<&'a Hole>,
    /// Lines on the cloth.
    pub(super) lines: Vec<&'a Vec<Point2>>,
}

/// A notch at its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlacedNotch {
    pub(super) at: Point2,
    pub(super) kind: NotchKind,
    pub(super) depth_m: Option<f64>,
}

impl<'a> PanelParts<'a> {
    /// Returns all parts of a panel.
    pub(super) fn whole(panel: &'a Panel) -> Self {
        let outline = ring_of(&panel.edges);
        let mut is_corner = vec![false; outline.len()];
        let mut first = 0;
        for edge in &panel.edges {
            if let Some(corner) = is_corner.get_mut(first) {
                *corner = true;
            }
            first += edge.points.len().saturating_sub(1);
        }
        let notches = panel.notches.iter().filter_map(|notch| {
            let edge = panel.edges.get(notch.edge)?;
            Some(PlacedNotch {
                at: place_on(&edge.points, notch.at)?,
                kind: notch.kind,
                depth_m: notch.depth_m,
            })
        });
        Self {
            outline,
            is_corner,
            cut_line: panel.cut_line.clone(),
            is_cut_closed: true,
            fold: None,
            notches: notches.collect(),
            drills: panel.drill_holes.clone(),
            holes: panel.holes.iter().collect(),
            lines: panel.internal_lines.iter().collect(),
        }
    }
}

/// Returns the place at a fraction of the length of a polyline.
fn place_on(points: &[Point2], at: f64) -> Option<Point2> {
    let steps = || {
        points
            .windows(2)
            .map(|w| (w[0], w[1], distance(w[0], w[1])))
    };
    let mut left = at * steps().map(|(.., long)| long).sum::<f64>();
    for (a, b, long) in steps() {
        if left <= long && long > 0.0 {
            return Some(lerp(a, b, left / long));
        }
        left -= long;
    }
    points.last().copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_lies_at_its_fraction_of_the_length() {
        let line = [[0.0, 0.0], [1.0, 0.0], [1.0, 3.0]];
        for (at, place) in [
            (0.0, line[0]),
            (0.25, line[1]),
            (0.5, [1.0, 1.0]),
            (1.0, line[2]),
        ] {
            assert_eq!(place_on(&line, at), Some(place));
        }
    }
}
