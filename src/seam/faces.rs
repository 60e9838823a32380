//! The face of each panel, by two-colouring: stated faces fix colours, seams carry them over, `match: auto` seams give way.

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

    fn is_auto(&self) -> bool {
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

/// Which order a seam has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    AsPicked,
    Reversed,
}

/// The order in which a seam is far shorter where its panels start, with the faces that either order gives, as picked
/// first; nothing if neither is, or that is not known.
pub(super) type Shorter<'a> = &'a dyn Fn(&Saying<'_>, &[Vec<Face>; 2]) -> Option<Order>;

/// What was found.
#[derive(Clone, Debug)]
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

/// Colours the panels.
///
/// First come stated faces, then seams as picked, then those that may twist, then the `auto` ones; within each kind
/// the order of ids counts and not that of the request, so that the same set gives the same faces.
pub(super) fn find(
    pattern: &Pattern,
    stated: &[Option<Face>],
    sayings: &[Saying<'_>],
    shorter: Shorter<'_>,
) -> Colouring {
    let mut parity = Parity::new(stated.len() + 1);
    stated_links(stated).for_each(|link| {
        parity.join(link);
    });
    let mut ordered: Vec<&Saying<'_>> = sayings.iter().collect();
    ordered.sort_by_key(|s| {
        (
            s.is_auto(),
            s.pair.allow_twist,
            s.heights_agree.is_none(),
            &s.pair.id,
        )
    });
    let mut reversed = BTreeMap::new();
    let mut twists_allowed = vec![];
    for saying in ordered {
        let turn = if saying.is_auto() {
            turn(pattern, saying, &parity, shorter)
        } else {
            None
        };
        let links = if turn.is_some() {
            &saying.reversed
        } else {
            &saying.picked
        };
        let fits = parity.join_all(links);
        if !fits && saying.pair.allow_twist {
            twists_allowed.push(saying.seam);
        }
        reversed.extend(turn.map(|why| (saying.seam, why)));
    }
    Colouring {
        faces: coloured(pattern, parity),
        reversed,
        twists_allowed,
    }
}

/// Whether an `auto` seam is to be reversed: parity decides; where it cannot, where panels start; where that is not
/// known or does not tell, heights as drawn, and then which order more notches fit.
fn turn(
    pattern: &Pattern,
    saying: &Saying<'_>,
    parity: &Parity,
    shorter: Shorter<'_>,
) -> Option<Why> {
    match (parity.fits(&saying.picked), parity.fits(&saying.reversed)) {
        (true, true) => {}
        (false, true) => return Some(Why::Twisted),
        (true | false, false) => return None,
    }
    let faces = [&saying.picked, &saying.reversed].map(|links| {
        let mut parity = parity.clone();
        parity.join_all(links);
        coloured(pattern, parity)
    });
    match shorter(saying, &faces) {
        Some(Order::Reversed) => return Some(Why::FarApart),
        Some(Order::AsPicked) => return None,
        None => {}
    }
    match saying.heights_agree {
        Some(true) => None,
        Some(false) => Some(Why::UpsideDown),
        None => (saying.notches[1] > saying.notches[0]).then_some(Why::Notches),
    }
}

/// Faces from what is known: the node after the last panel is up; a part that is not tied to it has the face of its front, or else its first panel, up.
pub(super) fn coloured(pattern: &Pattern, mut parity: Parity) -> Vec<Face> {
    let count = pattern.panels.len();
    let (stated_head, stated_same) = parity.find(count);
    let mut up = BTreeMap::from([(stated_head, stated_same)]);
    let (fronts, others): (Vec<usize>, _) = (0..count).partition(|&i| is_front(pattern, i));
    for panel in fronts.into_iter().chain(others) {
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
