//! The folds of a piece: one, or two at right angles, about which it is unfolded one after the
//! other.

use super::corners::CorneredRing;
use super::dxf_piece::DxfPiece;
use super::fold::{FoldLine, Unfolded};
use crate::fault::PatternCode;
use crate::pattern::Point2;
use crate::pattern::Unfold;
use crate::pattern::dxf::findings::DxfFindings;
use std::f64::consts::FRAC_PI_2;

/// Folds that differ from a right angle, or from the same direction, by less than this are square,
/// or parallel \[rad\].
const SQUARE: f64 = 0.01;

/// The folds of a piece, in the order in which it is unfolded.
#[derive(Clone, Debug, Default)]
pub(super) struct Folds {
    lines: Vec<FoldLine>,
}

impl Folds {
    /// Returns the folds of a piece whose outline is drawn as `drawn`; those that it is not
    /// unfolded about are warned about.
    pub(super) fn of(
        piece: &DxfPiece,
        drawn: &CorneredRing,
        unfold: Unfold,
        findings: &mut DxfFindings,
    ) -> Self {
        let mut folds = Self::default();
        if unfold == Unfold::None {
            return folds;
        }
        let lines = piece.fold_lines();
        let mut ring = drawn.clone();
        let mut refused: Option<String> = None;
        for line in first_unfolding(&lines, drawn) {
            if let Some(reason) = folds.refuse(line) {
                refused.get_or_insert(reason);
            } else if let Some(whole) = line.unfold(&ring) {
                ring = whole.outline;
                folds.lines.push(*line);
            } else {
                refused.get_or_insert("a fold line of it is no edge of it".to_owned());
            }
        }
        if let Some(reason) = refused {
            let done = match folds.lines.len() {
                0 => "it was not unfolded",
                _ => "it was unfolded about what comes before only (unfold=none keeps it as drawn)",
            };
            let detail = format!("{:?}: {reason}; {done}", piece.name);
            findings.warn(PatternCode::FoldIgnored, piece.line, detail);
        }
        folds
    }

    /// Returns the reason for which a piece cannot be unfolded about one more line.
    fn refuse(&self, line: &FoldLine) -> Option<String> {
        let angle = self.lines.first()?.angle_to(line);
        let is_square = FRAC_PI_2 - angle < SQUARE;
        if angle < SQUARE || is_square && self.lines.len() > 1 {
            let why = "it has parallel fold lines, about which it would go on without end";
            return Some(why.to_owned());
        }
        (!is_square).then(|| {
            let degrees = angle.to_degrees();
            format!("its fold lines meet at {degrees:.0} degrees, not at a right angle")
        })
    }

    /// Returns true if there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Returns an outline unfolded, or as it is where it does not lie on the folds.
    pub(super) fn unfolded(&self, ring: &CorneredRing) -> Unfolded {
        let mut whole = Unfolded {
            outline: ring.clone(),
            holes: vec![],
        };
        for fold in &self.lines {
            let holes = std::mem::take(&mut whole.holes);
            if let Some(next) = fold.unfold(&whole.outline) {
                whole = next;
            }
            whole.holes.extend(hole_images(*fold, holes));
        }
        whole
    }

    /// Returns the holes of the whole piece of which `ring` is drawn: one where it lies on a fold
    /// or across it.
    pub(super) fn unfolded_holes(&self, ring: CorneredRing) -> Vec<CorneredRing> {
        let mut rings = vec![ring];
        for fold in &self.lines {
            rings = hole_images(*fold, rings);
        }
        rings
    }

    /// Returns an open line about the piece as it runs about the whole.
    pub(super) fn unfolded_line(&self, line: &[Point2]) -> Vec<Point2> {
        let fold = |line: Vec<Point2>, fold: &FoldLine| fold.unfold_line(&line);
        self.lines.iter().fold(line.to_vec(), fold)
    }

    /// Adds the mirror images of marks to them; what lies on a fold stays single.
    pub(super) fn add_images(&self, points: &mut Vec<Point2>) {
        for fold in &self.lines {
            fold.add_images(points);
        }
    }

    /// Adds the mirror images of lines to them.
    pub(super) fn add_line_images(&self, lines: &mut Vec<Vec<Point2>>) {
        for fold in &self.lines {
            let image = |line: &Vec<Point2>| line.iter().map(|p| fold.mirror(*p)).collect();
            let images: Vec<Vec<Point2>> = lines.iter().map(image).collect();
            lines.extend(images);
        }
    }

    /// Returns a mark with its mirror images; what lies on a fold stays single.
    pub(super) fn images(&self, mark: &[Point2]) -> Vec<Vec<Point2>> {
        let mut marks = vec![mark.to_vec()];
        for fold in &self.lines {
            let images: Vec<_> = marks.iter().filter_map(|mark| fold.image(mark)).collect();
            marks.extend(images);
        }
        marks
    }
}

/// Returns the lines with the first that unfolds the outline before the others.
fn first_unfolding<'a>(
    lines: &'a [FoldLine],
    drawn: &CorneredRing,
) -> impl Iterator<Item = &'a FoldLine> {
    let first = lines.iter().position(|line| line.unfold(drawn).is_some());
    let first = first.unwrap_or(0);
    let rest = lines.iter().enumerate().filter(move |(i, _)| *i != first);
    lines.get(first).into_iter().chain(rest.map(|(_, l)| l))
}

/// Returns holes with their mirror images: those on the fold joined to theirs, those across it as
/// they are.
fn hole_images(fold: FoldLine, holes: Vec<CorneredRing>) -> Vec<CorneredRing> {
    let images = |hole: CorneredRing| {
        if let Some(whole) = fold.unfold(&hole) {
            return vec![whole.outline];
        }
        if fold.is_across(&hole) {
            return vec![hole];
        }
        let image = CorneredRing {
            points: hole.points.iter().map(|p| fold.mirror(*p)).collect(),
            is_corner: hole.is_corner.clone(),
        };
        vec![hole, image]
    };
    holes.into_iter().flat_map(images).collect()
}
