//! The face of each panel, by two-coloring: stated faces fix colors, seams carry them over,
//! `match: auto` seams give way.

use super::Face;
use super::faces::{self, FaceColoring, ReversalReason, SeamRelations};
use super::parity::ParityUnionFind;

/// Order of side B of a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SeamOrder {
    AsPicked,
    Reversed,
}

/// The order in which a seam is far shorter where its panels start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ShorterOrder {
    pub order: SeamOrder,
    /// Share of the other order's length that it leaves, in thousandths: the fewer, the plainer.
    pub remaining_permille: u32,
}

/// Far shorter order of a seam by start positions, with the faces that either order gives, as
/// picked first; nothing if neither is far shorter, or that is not known.
pub(super) type ShorterOrderFn<'a> =
    &'a dyn Fn(&SeamRelations<'_>, &[Vec<Face>; 2]) -> Option<ShorterOrder>;

/// Colors panels and orders `auto` seams.
pub(super) struct FaceColorer<'a> {
    /// Panels whose faces lead those of their parts, in this order.
    pub leads: &'a [(usize, Face)],
    pub shorter_order: ShorterOrderFn<'a>,
}

impl FaceColorer<'_> {
    /// Colors the panels.
    ///
    /// First come stated faces, then seams as picked, then those that may twist, then the `auto`
    /// ones: those first of which places tell most plainly, then those whose heights as drawn are
    /// plain. Within each kind the order of ids counts and not that of the request, so that the
    /// same set gives the same faces.
    pub(super) fn color(
        &self,
        stated: &[Option<Face>],
        all_relations: &[SeamRelations<'_>],
    ) -> FaceColoring {
        let mut parity = ParityUnionFind::new(stated.len() + 1);
        faces::stated_relations(stated).for_each(|relation| {
            parity.join(relation);
        });
        let (mut auto, mut picked): (Vec<&SeamRelations<'_>>, Vec<_>) =
            all_relations.iter().partition(|implied| implied.is_auto());
        let mut found = FaceColoring::default();
        picked.sort_by_key(|s| (s.pair.allow_twist, s.heights_agree.is_none(), &s.pair.id));
        for implied in picked {
            join_seam(implied, None, &mut parity, &mut found);
        }
        auto.sort_by_cached_key(|s| {
            let shorter = self
                .shorter_order(s, &parity)
                .map_or(u32::MAX, |shorter| shorter.remaining_permille);
            let no_height = s.heights_agree.is_none();
            (s.pair.allow_twist, shorter, no_height, &s.pair.id)
        });
        for implied in auto {
            let reason = self.reversal_reason(implied, &parity);
            join_seam(implied, reason, &mut parity, &mut found);
        }
        found.faces = faces::color_faces(self.leads, parity);
        found
    }

    /// Returns why an `auto` seam is to be reversed, if it is: parity decides; where it cannot,
    /// which order folds the cloth over; where neither does, where panels start; where that is not
    /// known or does not tell, heights as drawn, and then which order more notches fit.
    fn reversal_reason(
        &self,
        implied: &SeamRelations<'_>,
        parity: &ParityUnionFind,
    ) -> Option<ReversalReason> {
        match (parity.fits(&implied.picked), parity.fits(&implied.reversed)) {
            (true, true) => {}
            (false, true) => return Some(ReversalReason::Twisted),
            (true | false, false) => return None,
        }
        match implied.folds {
            [false, true] => return Some(ReversalReason::Folds),
            [true, _] => return None,
            [false, false] => {}
        }
        if let Some(shorter) = self.shorter_order(implied, parity) {
            return (shorter.order == SeamOrder::Reversed).then_some(ReversalReason::FarApart);
        }
        match implied.heights_agree {
            Some(true) => None,
            Some(false) => Some(ReversalReason::UpsideDown),
            None => (implied.notches[1] > implied.notches[0]).then_some(ReversalReason::Notches),
        }
    }

    fn shorter_order(
        &self,
        implied: &SeamRelations<'_>,
        parity: &ParityUnionFind,
    ) -> Option<ShorterOrder> {
        let faces = [&implied.picked, &implied.reversed].map(|relations| {
            let mut parity = parity.clone();
            parity.join_all(relations);
            faces::color_faces(self.leads, parity)
        });
        (self.shorter_order)(implied, &faces)
    }
}

/// Adds the relations of a seam, in the order it has, to what is known.
fn join_seam(
    implied: &SeamRelations<'_>,
    reason: Option<ReversalReason>,
    parity: &mut ParityUnionFind,
    found: &mut FaceColoring,
) {
    let relations = if reason.is_some() {
        &implied.reversed
    } else {
        &implied.picked
    };
    let fits = parity.join_all(relations);
    if !fits && implied.pair.allow_twist {
        found.twists_allowed.push(implied.seam);
    }
    found
        .reversed
        .extend(reason.map(|reason| (implied.seam, reason)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_requested_colors_every_panel_up() {
        let colorer = FaceColorer {
            leads: &[(1, Face::Up), (0, Face::Up)],
            shorter_order: &|_, _| None,
        };
        let found = colorer.color(&[None, None], &[]);
        assert_eq!(found.faces, [Face::Up, Face::Up]);
        assert!(found.reversed.is_empty());
    }
}
