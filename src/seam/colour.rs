//! The face of each panel, by two-colouring: stated faces fix colours, seams carry them over, `match: auto` seams give way.

use super::Face;
use super::faces::{self, Colouring, Saying, Why};
use super::parity::Parity;

/// Which order a seam has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    AsPicked,
    Reversed,
}

/// The order in which a seam is far shorter where its panels start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Told {
    pub order: Order,
    /// What it leaves of the other order's length, in thousandths: the fewer, the plainer.
    pub left: u32,
}

/// What places tell of a seam, with the faces that either order gives, as picked first; nothing if neither order is far
/// shorter, or that is not known.
pub(super) type Shorter<'a> = &'a dyn Fn(&Saying<'_>, &[Vec<Face>; 2]) -> Option<Told>;

/// Colours panels and orders `auto` seams.
pub(super) struct Painter<'a> {
    pub fronts_first: &'a [usize],
    pub shorter: Shorter<'a>,
}

impl Painter<'_> {
    /// Colours the panels.
    ///
    /// First come stated faces, then seams as picked, then those that may twist, then the `auto` ones: those first of
    /// which places tell most plainly, then those whose heights as drawn are plain. Within each kind the order of ids
    /// counts and not that of the request, so that the same set gives the same faces.
    pub(super) fn find(&self, stated: &[Option<Face>], sayings: &[Saying<'_>]) -> Colouring {
        let mut parity = Parity::new(stated.len() + 1);
        faces::stated_links(stated).for_each(|link| {
            parity.join(link);
        });
        let (mut auto, mut picked): (Vec<&Saying<'_>>, Vec<_>) =
            sayings.iter().partition(|saying| saying.is_auto());
        let mut found = Colouring::default();
        picked.sort_by_key(|s| (s.pair.allow_twist, s.heights_agree.is_none(), &s.pair.id));
        for saying in picked {
            join(saying, None, &mut parity, &mut found);
        }
        auto.sort_by_cached_key(|s| {
            let told = self.told(s, &parity).map_or(u32::MAX, |told| told.left);
            let no_height = s.heights_agree.is_none();
            (s.pair.allow_twist, told, no_height, &s.pair.id)
        });
        for saying in auto {
            let turn = self.turn(saying, &parity);
            join(saying, turn, &mut parity, &mut found);
        }
        found.faces = faces::coloured(self.fronts_first, parity);
        found
    }

    /// Whether an `auto` seam is to be reversed: parity decides; where it cannot, where panels start; where that is not
    /// known or does not tell, heights as drawn, and then which order more notches fit.
    fn turn(&self, saying: &Saying<'_>, parity: &Parity) -> Option<Why> {
        match (parity.fits(&saying.picked), parity.fits(&saying.reversed)) {
            (true, true) => {}
            (false, true) => return Some(Why::Twisted),
            (true | false, false) => return None,
        }
        if let Some(told) = self.told(saying, parity) {
            return (told.order == Order::Reversed).then_some(Why::FarApart);
        }
        match saying.heights_agree {
            Some(true) => None,
            Some(false) => Some(Why::UpsideDown),
            None => (saying.notches[1] > saying.notches[0]).then_some(Why::Notches),
        }
    }

    fn told(&self, saying: &Saying<'_>, parity: &Parity) -> Option<Told> {
        let faces = [&saying.picked, &saying.reversed].map(|links| {
            let mut parity = parity.clone();
            parity.join_all(links);
            faces::coloured(self.fronts_first, parity)
        });
        (self.shorter)(saying, &faces)
    }
}

/// Takes what a seam says in the order it has to what is known.
fn join(saying: &Saying<'_>, turn: Option<Why>, parity: &mut Parity, found: &mut Colouring) {
    let links = if turn.is_some() {
        &saying.reversed
    } else {
        &saying.picked
    };
    let fits = parity.join_all(links);
    if !fits && saying.pair.allow_twist {
        found.twists_allowed.push(saying.seam);
    }
    found.reversed.extend(turn.map(|why| (saying.seam, why)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_asked_colours_every_panel_up() {
        let painter = Painter {
            fronts_first: &[1, 0],
            shorter: &|_, _| None,
        };
        let found = painter.find(&[None, None], &[]);
        assert_eq!(found.faces, [Face::Up, Face::Up]);
        assert!(found.reversed.is_empty());
    }
}
