//! The seams of a garment, checked with its faces and with where its panels start.

use super::garment::Garment;
use super::sewn;
use crate::config::Limits;
use crate::fault::Faults;
use crate::pattern::{Panel, Pattern, SeamPair};
use crate::scene::{self, Placed, ToPlace};
use crate::seam::{self, Face, SeamCheck, SeamCheckInput, SeamSet};
use std::cell::OnceCell;

/// Checks `pairs` on the pattern as the garment sews it; `edge_length` \[m\] is within `limits`.
///
/// Panels start where the garment or the pattern's file puts them, or where their names say, about no body: the body
/// moves them all outwards and changes nothing of the order in which their edges meet.
///
/// # Errors
/// Every fault of every seam at once, in the second part.
pub(crate) fn check_seams(
    garment: &Garment,
    pattern: &Pattern,
    pairs: &[SeamPair],
    (edge_length, limits): (f64, &Limits),
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let starts = Starts::new(garment, pattern);
    let to_check = SeamCheckInput {
        pattern,
        pairs,
        faces: &sewn::faces(garment, pattern),
        edge_length,
        limits,
    };
    seam::check_placed(&to_check, &|panel, face, uv| starts.start(panel, face, uv))
}

/// Where panels start with either face, found when asked for.
struct Starts<'a> {
    garment: &'a Garment,
    pattern: &'a Pattern,
    placed: Vec<[OnceCell<Option<Placed>>; 2]>,
}

impl<'a> Starts<'a> {
    fn new(garment: &'a Garment, pattern: &'a Pattern) -> Self {
        Self {
            garment,
            pattern,
            placed: pattern.panels.iter().map(|_| Default::default()).collect(),
        }
    }

    fn start(&self, panel: usize, face: Face, uv: [f64; 2]) -> Option<[f64; 3]> {
        let of_face = &self.placed[panel][usize::from(face == Face::Down)];
        let placed = of_face.get_or_init(|| self.place(&self.pattern.panels[panel], face));
        Some(placed.as_ref()?.position(uv).into())
    }

    fn place(&self, panel: &Panel, face: Face) -> Option<Placed> {
        let asked = sewn::asked(self.garment, panel).placement;
        let asked = asked
            .as_ref()
            .or_else(|| self.pattern.placements.get(&panel.id));
        let to_place = ToPlace { panel, face, asked };
        scene::place(to_place, None).ok()
    }
}
