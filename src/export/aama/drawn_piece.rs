//! A piece as it is drawn: which line is cut, which is sewn, where corners are.

use super::fold;
use super::parts::{PanelParts, PlacedNotch};
use crate::pattern::outline::ring_of;
use crate::pattern::point::Point2;
use crate::pattern::polyline::signed_area;
use crate::pattern::{Allowance, Panel};

/// A piece as it is drawn \[m\].
pub(super) struct DrawnPiece {
    /// The line that is cut, closed.
    pub(super) boundary: Vec<Point2>,
    /// The line that is sewn, closed; `None` where the file of the pattern did not tell it.
    pub(super) sew: Option<Vec<Point2>>,
    /// The fold on which a half is drawn.
    pub(super) fold: Option<[Point2; 2]>,
    /// Corners of the outline and of cut-outs.
    pub(super) turns: Vec<Point2>,
    /// Their other points.
    pub(super) curve_points: Vec<Point2>,
    pub(super) notches: Vec<PlacedNotch>,
    pub(super) drills: Vec<Point2>,
    /// Outlines of cut-outs.
    pub(super) holes: Vec<Vec<Point2>>,
    /// Lines on the cloth.
    pub(super) lines: Vec<Vec<Point2>>,
    /// Direction of the warp, counter-clockwise from +x \[degrees\].
    pub(super) grain_deg: Option<f64>,
    /// True if the panel has a cut line that does not go round its outline.
    pub(super) is_cut_beside: bool,
}

impl DrawnPiece {
    /// Draws a panel of a pattern with this seam allowance in its outlines.
    pub(super) fn of(panel: &Panel, allowance: Allowance) -> Self {
        let whole = PanelParts::whole(panel);
        let half = panel.unfolded.then(|| fold::half(&whole)).flatten();
        let parts = half.unwrap_or(whole);
        let (turns, curve_points) = points(&parts);
        let holes = parts.holes.iter().map(|hole| ring_of(&hole.edges));
        let mut piece = Self {
            holes: holes.collect(),
            boundary: Vec::new(),
            sew: None,
            fold: parts.fold,
            turns,
            curve_points,
            lines: parts.lines.into_iter().cloned().collect(),
            notches: parts.notches,
            drills: parts.drills,
            grain_deg: panel.grain.map(|grain| grain.angle_deg),
            is_cut_beside: false,
        };
        let cut = (parts.cut_line, parts.is_cut_closed);
        piece.set_lines(parts.outline, cut, allowance);
        piece
    }

    /// Chooses the lines that are cut and sewn.
    ///
    /// A cut line that is open, or encloses less than the outline, was drawn beside a part of it,
    /// and becomes a line on the cloth.
    fn set_lines(
        &mut self,
        outline: Vec<Point2>,
        (cut, is_closed): (Vec<Point2>, bool),
        allowance: Allowance,
    ) {
        let area = |ring: &[Point2]| signed_area(ring).abs();
        let goes_round = is_closed && cut.len() > 2 && area(&cut) >= area(&outline);
        if goes_round {
            self.boundary = cut;
            self.sew = Some(outline);
            return;
        }
        self.is_cut_beside = !cut.is_empty();
        self.lines.extend((cut.len() > 1).then_some(cut));
        self.sew = (allowance != Allowance::Unknown).then(|| outline.clone());
        self.boundary = outline;
    }

    /// Returns the number of points of its outline and cut-outs.
    pub(super) fn point_count(&self) -> usize {
        self.turns.len() + self.curve_points.len()
    }
}

/// Returns the corners of the outline and of cut-outs, and their other points.
fn points(parts: &PanelParts<'_>) -> (Vec<Point2>, Vec<Point2>) {
    let (mut turns, mut curve_points) = (Vec::new(), Vec::new());
    for (point, is_corner) in parts.outline.iter().zip(&parts.is_corner) {
        if *is_corner {
            turns.push(*point);
        } else {
            curve_points.push(*point);
        }
    }
    for edge in parts.holes.iter().flat_map(|hole| &hole.edges) {
        if let Some((corner, rest)) = edge.points.split_first() {
            turns.push(*corner);
            curve_points.extend(rest.split_last().map_or(&[][..], |(_, inner)| inner));
        }
    }
    (turns, curve_points)
}
