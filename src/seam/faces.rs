//! Faces of panels, and the relations between them that seams imply.

use super::parity::{FaceRelation, ParityUnionFind};
use super::pleats::{self, FoldedPairs};
use super::{Face, FaceRequest, RoutedSeam, routed_seam};
use crate::pattern::{Match, Pattern, SeamPair};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Parts of a front's name, in the words of pattern makers and of GarmentCode.
const FRONT_WORDS: [&str; 4] = ["front", "frnt", "frt", "ftorso"];

/// Relations between faces that one seam implies.
#[derive(Clone, Debug)]
pub(super) struct SeamRelations<'a> {
    /// Position of the seam in the request.
    pub seam: usize,
    /// The seam as requested.
    pub pair: &'a SeamPair,
    /// Its relations with side B as picked.
    pub picked: Vec<FaceRelation>,
    /// Its relations with side B reversed.
    pub reversed: Vec<FaceRelation>,
    /// True if upper ends meet upper ends as picked; absent where that is not plain.
    pub heights_agree: Option<bool>,
    /// Number of notches that meet as picked, and with side B reversed.
    pub notches: [usize; 2],
    /// True if cloth is folded over on its base as picked, and with side B reversed.
    pub folds: [bool; 2],
}

impl<'a> SeamRelations<'a> {
    /// Returns the relations of a seam. Sides in a pleat that lie wrong side up, as picked and with
    /// side B reversed, say nothing.
    pub(super) fn new(
        pattern: &Pattern,
        pair: &'a SeamPair,
        seam: &RoutedSeam,
        folded: [&FoldedPairs; 2],
    ) -> Self {
        let reversed = seam.reversed();
        let relations = |seam: &RoutedSeam, folded: &FoldedPairs| {
            let mut matched = seam.matched(pattern);
            let mut number = 0..;
            matched.retain(|_| {
                let pair = number.next().unwrap_or_default();
                !folded.contains(&(seam.index, pair))
            });
            routed_seam::face_relations(pattern, &matched)
        };
        Self {
            seam: seam.index,
            pair,
            picked: relations(seam, folded[0]),
            reversed: relations(&reversed, folded[1]),
            folds: folded.map(|folded| pleats::is_folded(folded, seam.index)),
            notches: [seam, &reversed].map(|seam| seam.marks(pattern).len()),
            heights_agree: seam.heights_agree(pattern),
        }
    }

    /// Returns its relations in the order in which it is sewn.
    pub(super) fn relations(&self, coloring: &FaceColoring) -> &[FaceRelation] {
        if coloring.reversed.contains_key(&self.seam) {
            &self.reversed
        } else {
            &self.picked
        }
    }

    pub(super) fn is_auto(&self) -> bool {
        self.pair.matching == Match::Auto
    }
}

/// Reason to reverse the order of a side B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReversalReason {
    /// As picked the surface would be one-sided.
    Twisted,
    /// As picked an upper end would meet a lower one.
    UpsideDown,
    /// As picked the two sides would start far apart.
    FarApart,
    /// As picked fewer notches would meet.
    Notches,
    /// Only reversed it folds the cloth over.
    Folds,
}

/// Face of each panel, and the seams that were reversed for it.
#[derive(Clone, Debug, Default)]
pub(super) struct FaceColoring {
    /// The face of each panel, in the pattern's order.
    pub faces: Vec<Face>,
    /// Seams whose side B is to be reversed.
    pub reversed: BTreeMap<usize, ReversalReason>,
    /// Seams that make the surface one-sided and may.
    pub twists_allowed: Vec<usize>,
}

impl FaceColoring {
    /// Returns `seam` with its side B in the order in which it is sewn.
    pub(super) fn ordered<'a>(&self, seam: &'a RoutedSeam) -> Cow<'a, RoutedSeam> {
        if self.reversed.contains_key(&seam.index) {
            Cow::Owned(seam.reversed())
        } else {
            Cow::Borrowed(seam)
        }
    }
}

/// Returns the stated face of each panel, in the pattern's order.
pub(super) fn stated(
    pattern: &Pattern,
    requested: &BTreeMap<String, FaceRequest>,
) -> Vec<Option<Face>> {
    let of = |id| match requested.get(id) {
        Some(FaceRequest::Up) => Some(Face::Up),
        Some(FaceRequest::Down) => Some(Face::Down),
        Some(FaceRequest::Auto) | None => None,
    };
    pattern
        .panels
        .iter()
        .map(|panel| of(panel.id.as_str()))
        .collect()
}

/// Returns stated faces as relations to a node after the last panel whose face is up.
pub(super) fn stated_relations(stated: &[Option<Face>]) -> impl Iterator<Item = FaceRelation> {
    stated.iter().enumerate().filter_map(|(panel, face)| {
        face.map(|face| FaceRelation {
            ends: [panel, stated.len()],
            same: face == Face::Up,
        })
    })
}

/// Returns the panels, those first that a name says are fronts, each with its face up: as leads of
/// their parts.
pub(super) fn fronts_first(pattern: &Pattern) -> Vec<(usize, Face)> {
    let panels = 0..pattern.panels.len();
    let (mut fronts, others): (Vec<usize>, Vec<usize>) =
        panels.partition(|&i| is_front(pattern, i));
    fronts.extend(others);
    fronts.into_iter().map(|panel| (panel, Face::Up)).collect()
}

/// Returns faces from what is known: the node after the last panel is up; a part that is not tied
/// to it has the face of the first of its panels in `leads`, which names each panel once.
pub(super) fn color_faces(leads: &[(usize, Face)], mut parity: ParityUnionFind) -> Vec<Face> {
    let count = leads.len();
    let (stated_head, stated_same) = parity.find(count);
    let mut up = BTreeMap::from([(stated_head, stated_same)]);
    for &(panel, face) in leads {
        let (head, same) = parity.find(panel);
        up.entry(head).or_insert(same == (face == Face::Up));
    }
    let face = |panel| {
        let (head, same) = parity.find(panel);
        if same == up[&head] {
            Face::Up
        } else {
            Face::Down
        }
    };
    (0..count).map(face).collect()
}

/// Returns true if a panel's id or name says that it is a front.
pub(super) fn is_front(pattern: &Pattern, panel: usize) -> bool {
    let panel = &pattern.panels[panel];
    [&panel.id, &panel.name].iter().any(|name| {
        let name = name.to_lowercase();
        FRONT_WORDS.iter().any(|front| name.contains(front))
    })
}
