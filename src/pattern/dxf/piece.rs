//! A piece as drawn, and the lines and marks that it takes up.

use super::chain::Chain;
use super::entity::{Entity, Shape};
use super::expand::Sheet;
use super::label::{self, Labels};
use super::nest::{Inner, Loop};
use crate::pattern::NotchKind;
use crate::pattern::Point2;

/// A piece as drawn, in metres.
pub(super) struct Piece {
    /// What it is called.
    pub(super) name: String,
    /// The line it begins at.
    pub(super) line: usize,
    /// Its texts.
    pub(super) labels: Labels,
    /// The outline as drawn.
    pub(super) outline: Loop,
    /// Whether that outline is a sew line.
    pub(super) sewn: bool,
    /// The sew line inside it, closed, or open along the fold.
    pub(super) sew: Option<Chain>,
    /// A cut line about it, closed or open.
    pub(super) cut: Option<Chain>,
    /// Holes.
    pub(super) cutouts: Vec<Chain>,
    /// Lines drawn on the cloth.
    pub(super) internal: Vec<Chain>,
    /// Points and straight lines with a meaning.
    pub(super) marks: Marks,
}

/// Points and straight lines with a meaning.
#[derive(Default)]
pub(super) struct Marks {
    /// Where the outline has corners.
    pub(super) turns: Vec<Point2>,
    /// Notches.
    pub(super) notches: Vec<NotchMark>,
    /// Drill holes.
    pub(super) drills: Vec<Point2>,
    /// Fold lines, from end to end.
    pub(super) folds: Vec<[Point2; 2]>,
    /// Grain lines, from end to end.
    pub(super) grains: Vec<[Point2; 2]>,
}

/// A notch as drawn: a point, or the lines of its shape.
#[derive(Clone, Debug)]
pub(super) struct NotchMark {
    /// The point, or the points of the line.
    pub(super) points: Vec<Point2>,
    /// Its shape.
    pub(super) kind: NotchKind,
    /// How deep it is cut, where the file says \[m\].
    pub(super) depth: Option<f64>,
    /// The line it begins at.
    pub(super) line: usize,
}

impl Piece {
    /// The piece with this outline and the texts that are its own. `alone`: it is all that its sheet holds.
    ///
    /// It is called by its `Piece Name:`, else by its block, else by the first text that is neither a label nor a
    /// quantity.
    pub(super) fn new(sheet: &Sheet, outline: Loop, own: &[&Entity], alone: bool) -> Self {
        let labels = Labels::of(own.iter().copied());
        let free_text = || {
            own.iter().find_map(|e| match &e.shape {
                Shape::Text(_, text) if label::is_name(text) => Some(text.trim().to_owned()),
                _ => None,
            })
        };
        let name = labels
            .get("piece name")
            .map(str::to_owned)
            .or_else(|| sheet.block.clone())
            .or_else(free_text);
        Self {
            name: name.unwrap_or_else(|| "panel".to_owned()),
            line: if alone {
                sheet.line
            } else {
                outline.chain.line
            },
            labels,
            outline,
            sewn: false,
            sew: None,
            cut: None,
            cutouts: Vec::new(),
            internal: Vec::new(),
            marks: Marks::default(),
        }
    }

    /// Takes up a line that lies in it.
    pub(super) fn adopt(&mut self, chain: Chain, kind: Inner) {
        match kind {
            Inner::Sew if self.sew.is_none() => self.sew = Some(chain),
            Inner::Hole if chain.closed => self.cutouts.push(chain),
            _ => self.internal.push(chain),
        }
    }
}

/// Which piece a place lies in: the only one, the first that holds it, the first that it lies beside, or the smallest
/// whose box holds it (the middle of a piece that is bent like a skirt lies outside its outline).
pub(super) fn owner<'a>(
    outlines: impl Iterator<Item = &'a Loop> + Clone,
    at: Point2,
    alone: bool,
) -> Option<usize> {
    /// A mark this far outside an outline is still on it \[m\].
    const BESIDE: f64 = 0.002;
    if alone {
        return outlines.clone().next().map(|_| 0);
    }
    let held = outlines.clone().position(|outline| outline.holds(at));
    let beside = || {
        outlines
            .clone()
            .position(|outline| outline.beside(at, BESIDE))
    };
    let boxed = || {
        let boxes = outlines.clone().enumerate();
        let around = boxes.filter(|(_, outline)| outline.boxes(at, 0.0));
        around
            .min_by(|a, b| a.1.area().total_cmp(&b.1.area()))
            .map(|(i, _)| i)
    };
    held.or_else(beside).or_else(boxed)
}

/// The outlines of pieces.
pub(super) fn outlines(pieces: &[Piece]) -> impl Iterator<Item = &Loop> + Clone {
    pieces.iter().map(|piece| &piece.outline)
}
