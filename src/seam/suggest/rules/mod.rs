//! Rules of each class of garment: which edge roles are sewn together.

mod armhole;
mod band;
mod cuff;
mod dart;
mod godet;
mod hood;
mod hood_edges;
mod hood_of_three;
mod leg;
mod neck;
mod raglan;
mod ring;
mod side;
mod skirt;
mod sleeve;
mod sleeve_cap;
mod top;
mod trousers;
mod two_part_sleeve;
mod vent;
mod waist;
mod yoke;

use super::garment_model::GarmentModel;
use crate::pattern::Pattern;

/// Applies every rule in turn; each adds the seams that it proposes to `garment`.
pub(super) fn sew(garment: &mut GarmentModel, pattern: &Pattern) {
    ring::sew_bands(garment);
    godet::sew(garment);
    dart::sew(garment, pattern);
    top::sew(garment);
    sleeve::sew(garment);
    raglan::sew(garment);
    skirt::sew(garment);
    trousers::sew(garment);
    leg::sew(garment);
    waist::sew(garment);
    hood::sew(garment);
    ring::sew_loops(garment);
    neck::sew(garment);
    cuff::sew(garment);
}
