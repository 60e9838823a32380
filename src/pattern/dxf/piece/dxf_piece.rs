//! A piece as drawn: its outline, and the lines and marks that lie in it.

use super::chain::PathChain;
use super::fold::FoldLine;
use super::measured::MeasuredChain;
use crate::pattern::dxf::drawing::labels::{self, DxfLabels};
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::entity::affine::AffineMap;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};
use crate::pattern::{NotchKind, Point2};

/// The kind of a line inside an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InnerLine {
    /// A line along which the piece is sewn.
    Sew,
    /// The outline of a hole.
    Hole,
    /// A line drawn on the cloth.
    Drawn,
}

/// One size of a piece of which all sizes are drawn one in the other.
#[derive(Clone, Debug)]
pub(super) struct NestedSize {
    /// Its name.
    pub(super) name: String,
    /// Its outline.
    pub(super) outline: MeasuredChain,
}

/// A piece as drawn, in meters.
#[derive(Clone)]
pub(crate) struct DxfPiece {
    /// Its name.
    pub(crate) name: String,
    /// The line it begins at.
    pub(crate) line: usize,
    /// The linear part of the map by which it was put in, without its units.
    pub(super) linear: AffineMap,
    /// Its texts.
    pub(crate) labels: DxfLabels,
    /// The outline as drawn.
    pub(crate) outline: MeasuredChain,
    /// All sizes of the outline, growing, where they are drawn one in the other; else empty.
    pub(super) nest: Vec<NestedSize>,
    /// True if that outline is a sew line, by itself or too.
    pub(crate) is_sewn: bool,
    /// The sew line inside it, closed, or open along the fold.
    pub(crate) sew: Option<PathChain>,
    /// A cut line about it, closed or open.
    pub(crate) cut: Option<PathChain>,
    /// Holes.
    pub(crate) cutouts: Vec<PathChain>,
    /// Lines drawn on the cloth.
    pub(crate) internal: Vec<PathChain>,
    /// Points and straight lines with a meaning.
    pub(crate) marks: PieceMarks,
}

/// Points and straight lines with a meaning.
#[derive(Clone, Default)]
pub(crate) struct PieceMarks {
    /// Turn points: corners of the outline.
    pub(crate) turns: Vec<Point2>,
    /// Places with the number of a grade rule.
    pub(super) rules: Vec<(Point2, u32)>,
    /// Notches.
    pub(crate) notches: Vec<NotchMark>,
    /// Drill holes.
    pub(crate) drills: Vec<Point2>,
    /// Fold lines, from end to end.
    pub(crate) folds: Vec<[Point2; 2]>,
    /// Grain lines, from end to end.
    pub(crate) grains: Vec<[Point2; 2]>,
}

/// A notch as drawn: a point, or the lines of its shape.
#[derive(Clone, Debug)]
pub(crate) struct NotchMark {
    /// The point, or the points of the line.
    pub(crate) points: Vec<Point2>,
    /// Its shape.
    pub(crate) kind: NotchKind,
    /// True if it was drawn into the outline, not on a layer of notches.
    pub(super) is_drawn: bool,
    /// Depth to which it is cut, where the file gives it \[m\].
    pub(crate) depth: Option<f64>,
    /// The line it begins at.
    pub(crate) line: usize,
}

impl DxfPiece {
    /// Returns the piece with an outline and the texts that are its own. `is_alone`: it is all that
    /// its sheet holds.
    ///
    /// It is named by its `Piece Name:`, else by its block, else by the first text that is neither
    /// a label nor a quantity.
    pub(super) fn new(
        sheet: &DxfSheet,
        outline: MeasuredChain,
        texts: &[&DxfEntity],
        is_alone: bool,
    ) -> Self {
        let labels = DxfLabels::of(texts.iter().copied());
        let name = labels
            .get("piece name")
            .map(str::to_owned)
            .or_else(|| sheet.block.clone())
            .or_else(|| first_name(texts));
        let line = if is_alone {
            sheet.line
        } else {
            outline.chain.line
        };
        Self {
            name: name.unwrap_or_else(|| "panel".to_owned()),
            line,
            linear: sheet.linear,
            labels,
            outline,
            nest: Vec::new(),
            is_sewn: false,
            sew: None,
            cut: None,
            cutouts: Vec::new(),
            internal: Vec::new(),
            marks: PieceMarks::default(),
        }
    }

    /// Returns the points of its lines, and of its notches and drill holes.
    pub(super) fn points(&self) -> impl Iterator<Item = Point2> + '_ {
        let lines = [&self.sew, &self.cut].into_iter().flatten();
        let lines = lines.chain(&self.cutouts).chain(&self.internal);
        let lines = lines.chain([&self.outline.chain]);
        let notches = self.marks.notches.iter().flat_map(|notch| &notch.points);
        let marks = notches.chain(&self.marks.drills);
        lines.flat_map(|line| &line.points).chain(marks).copied()
    }

    /// Returns the number of entities that it was made of.
    pub(super) fn entity_count(&self) -> usize {
        let lines = [&self.sew, &self.cut].into_iter().flatten();
        let lines = lines.chain(&self.cutouts).chain(&self.internal);
        let lines = lines.chain([&self.outline.chain]);
        let marks = &self.marks;
        let points = marks.notches.len() + marks.drills.len() + marks.turns.len();
        let straight = marks.folds.len() + marks.grains.len();
        lines.map(|chain| chain.path_count).sum::<usize>() + points + straight
    }

    /// Adds a line that lies in it. A sew line drawn over the outline says that this is one; the
    /// outline of a hole may be open at a fold.
    pub(super) fn add_line(&mut self, chain: PathChain, kind: InnerLine) {
        match kind {
            InnerLine::Sew if self.is_outline(&chain) => self.is_sewn = true,
            InnerLine::Sew if self.sew.is_none() => self.sew = Some(chain),
            InnerLine::Hole if chain.closed || self.ends_on_fold(&chain) => {
                self.cutouts.push(chain);
            }
            _ => self.internal.push(chain),
        }
    }

    /// Returns its fold lines, each once.
    pub(super) fn fold_lines(&self) -> Vec<FoldLine> {
        let mut lines: Vec<FoldLine> = vec![];
        for line in self.marks.folds.iter().filter_map(|l| FoldLine::new(*l)) {
            if !lines.iter().any(|other| other.is_along(&line)) {
                lines.push(line);
            }
        }
        lines
    }

    /// Returns true if both ends of a line lie on one of its fold lines, apart from each other.
    fn ends_on_fold(&self, chain: &PathChain) -> bool {
        let ends = [chain.points.first(), chain.points.last()];
        let lies = |fold: &FoldLine| ends.iter().flatten().all(|end| fold.contains(**end));
        chain.points.len() > 2 && self.fold_lines().iter().any(lies)
    }

    /// Returns true if a line is the outline drawn once more.
    fn is_outline(&self, chain: &PathChain) -> bool {
        chain.closed
            && self
                .outline
                .is_drawn_over(&MeasuredChain::new(chain.clone()))
    }
}

/// Returns the first text that may be a name.
fn first_name(texts: &[&DxfEntity]) -> Option<String> {
    texts.iter().find_map(|entity| match &entity.shape {
        EntityShape::Text(_, text) if labels::is_name(text) => Some(text.trim().to_owned()),
        _ => None,
    })
}

/// Returns the index of the outline that a place lies in: the only one, the first that holds it,
/// the first that it lies beside, or the smallest whose box holds it (the middle of a piece that is
/// bent like a skirt lies outside its outline).
pub(super) fn owner<'a>(
    outlines: impl Iterator<Item = &'a MeasuredChain> + Clone,
    place: Point2,
    is_alone: bool,
) -> Option<usize> {
    /// A mark this far outside an outline is still on it \[m\].
    const BESIDE: f64 = 0.002;
    if is_alone {
        return outlines.clone().next().map(|_| 0);
    }
    let inside = outlines.clone().position(|outline| outline.contains(place));
    let beside = || {
        let mut outlines = outlines.clone();
        outlines.position(|outline| outline.is_beside(place, BESIDE))
    };
    let in_box = || {
        let outlines = outlines.clone().enumerate();
        let around = outlines.filter(|(_, outline)| outline.is_in_box(place, 0.0));
        let smallest = around.min_by(|a, b| a.1.area.total_cmp(&b.1.area));
        smallest.map(|(i, _)| i)
    };
    inside.or_else(beside).or_else(in_box)
}

/// Returns the outlines of pieces.
pub(super) fn outlines(pieces: &[DxfPiece]) -> impl Iterator<Item = &MeasuredChain> + Clone {
    pieces.iter().map(|piece| &piece.outline)
}
