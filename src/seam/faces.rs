//! Faces of panels, and what seams say of them.

use super::parity::{Link, Parity};
use super::{Face, FaceAsked, Routed, routed};
use crate::pattern::{Match, Pattern, SeamPair};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// What is part of a front's name, in the words of pattern makers and of GarmentCode.
const FRONT: [&str; 4] = ["front", "frnt", "frt", "ftorso"];

/// What one seam says of faces.
#[derive(Clone, Debug)]
pub(super) struct Saying<'a> {
    /// Position of the seam in the request.
    pub seam: usize,
    /// The seam as asked.
    pub pair: &'a SeamPair,
    /// What it says with side B as picked.
    pub picked: Vec<Link>,
    /// What it says with side B reversed.
    pub reversed: Vec<Link>,
    /// Whether upper ends meet upper ends as picked, where that is plain.
    pub heights_agree: Option<bool>,
    /// How many notches meet as picked, and with side B reversed.
    pub notches: [usize; 2],
}

impl<'a> Saying<'a> {
    pub(super) fn new(pattern: &Pattern, pair: &'a SeamPair, seam: &Routed) -> Self {
        let reversed = seam.reversed();
        Self {
            seam: seam.index,
            pair,
            picked: routed::links(pattern, &seam.matched(pattern)),
            reversed: routed::links(pattern, &reversed.matched(pattern)),
            notches: [seam, &reversed].map(|seam| seam.marks(pattern).len()),
            heights_agree: seam.heights_agree(pattern),
        }
    }

    /// What it says in the order in which it is sewn.
    pub(super) fn links(&self, colouring: &Colouring) -> &[Link] {
        if colouring.reversed.contains_key(&self.seam) {
            &self.reversed
        } else {
            &self.picked
        }
    }

    pub(super) fn is_auto(&self) -> bool {
        self.pair.matching == Match::Auto
    }
}

/// Why the order of a side B was reversed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Why {
    /// As picked the surface would be one-sided.
    Twisted,
    /// As picked an upper end would meet a lower one.
    UpsideDown,
    /// As picked the two sides would start far apart.
    FarApart,
    /// As picked fewer notches would meet.
    Notches,
}

/// What was found.
#[derive(Clone, Debug, Default)]
pub(super) struct Colouring {
    /// The face of each panel, in the pattern's order.
    pub faces: Vec<Face>,
    /// Seams whose side B is to be reversed.
    pub reversed: BTreeMap<usize, Why>,
    /// Seams that make the surface one-sided and may.
    pub twists_allowed: Vec<usize>,
}

impl Colouring {
    /// `seam` with its side B in the order it is sewn in.
    pub(super) fn ordered<'a>(&self, seam: &'a Routed) -> Cow<'a, Routed> {
        if self.reversed.contains_key(&seam.index) {
            Cow::Owned(seam.reversed())
        } else {
            Cow::Borrowed(seam)
        }
    }
}

/// What was stated of each panel, in the pattern's order.
pub(super) fn stated(pattern: &Pattern, asked: &BTreeMap<String, FaceAsked>) -> Vec<Option<Face>> {
    let of = |id| match asked.get(id) {
        Some(FaceAsked::Up) => Some(Face::Up),
        Some(FaceAsked::Down) => Some(Face::Down),
        Some(FaceAsked::Auto) | None => None,
    };
    pattern
        .panels
        .iter()
        .map(|panel| of(panel.id.as_str()))
        .collect()
}

/// What stated faces say, as links to a node after the last panel whose face is up.
pub(super) fn stated_links(stated: &[Option<Face>]) -> impl Iterator<Item = Link> {
    stated.iter().enumerate().filter_map(|(panel, face)| {
        face.map(|face| Link {
            ends: [panel, stated.len()],
            same: face == Face::Up,
        })
    })
}

/// The panels, those first that a name says are fronts.
pub(super) fn fronts_first(pattern: &Pattern) -> Vec<usize> {
    let panels = 0..pattern.panels.len();
    let (mut fronts, others): (Vec<usize>, Vec<usize>) =
        panels.partition(|&i| is_front(pattern, i));
    fronts.extend(others);
    fronts
}

/// Faces from what is known: the node after the last panel is up; a part that is not tied to it has the face of its
/// front, or else its first panel, up.
pub(super) fn coloured(fronts_first: &[usize], mut parity: Parity) -> Vec<Face> {
    let count = fronts_first.len();
    let (stated_head, stated_same) = parity.find(count);
    let mut up = BTreeMap::from([(stated_head, stated_same)]);
    for &panel in fronts_first {
        let (head, same) = parity.find(panel);
        up.entry(head).or_insert(same);
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

/// Whether a panel's id or name says that it is a front.
pub(super) fn is_front(pattern: &Pattern, panel: usize) -> bool {
    let panel = &pattern.panels[panel];
    [&panel.id, &panel.name].iter().any(|name| {
        let name = name.to_lowercase();
        FRONT.iter().any(|front| name.contains(front))
    })
}
