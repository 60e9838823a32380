//! A piece as drawn, and the lines and marks that it takes up.

use super::chain::Chain;
use super::entity::{Entity, P, Shape};
use super::expand::Sheet;
use super::label::Labels;
use super::nest::{Inner, Loop};
use crate::pattern::NotchKind;

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
    pub(super) turns: Vec<P>,
    /// Notches.
    pub(super) notches: Vec<(P, NotchKind)>,
    /// Drill holes.
    pub(super) drills: Vec<P>,
    /// Fold lines, from end to end.
    pub(super) folds: Vec<[P; 2]>,
    /// Grain lines, from end to end.
    pub(super) grains: Vec<[P; 2]>,
}

impl Piece {
    /// The piece with this outline. `alone`: every text of the sheet is its own, else those inside it.
    ///
    /// It is called by its `Piece Name:`, else by its block, else by the first text without a key inside it.
    pub(super) fn new(sheet: &Sheet, outline: Loop, alone: bool) -> Self {
        let is_own = |e: &&Entity| match &e.shape {
            Shape::Text(at, _) => alone || outline.holds(*at),
            _ => false,
        };
        let own: Vec<&Entity> = sheet.entities.iter().filter(is_own).collect();
        let labels = Labels::of(own.iter().copied());
        let free_text = || {
            own.iter().find_map(|e| match &e.shape {
                Shape::Text(_, text) if !text.contains(':') && !text.trim().is_empty() => {
                    Some(text.trim().to_owned())
                }
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

/// Which piece a place lies in: the only one, the first that holds it, or the first that it lies beside.
pub(super) fn owner(pieces: &[Piece], at: P, alone: bool) -> Option<usize> {
    /// A mark this far outside an outline is still on it \[m\].
    const BESIDE: f64 = 0.002;
    if alone {
        return (!pieces.is_empty()).then_some(0);
    }
    let held = pieces.iter().position(|piece| piece.outline.holds(at));
    held.or_else(|| {
        pieces
            .iter()
            .position(|piece| piece.outline.beside(at, BESIDE))
    })
}
