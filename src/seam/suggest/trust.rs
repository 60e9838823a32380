//! Trust in a suggested set as a whole: what it leaves out lowers the confidence of each seam.

use super::cohesion;
use super::completeness::Completeness;
use super::garment_model::GarmentModel;
use super::names::NameHints;
use super::suggestion::SuggestedSeam;
use crate::pattern::Pattern;

/// Times that the set is judged anew: each lowers the trust to another of its three grades.
const MAX_ROUNDS: usize = 3;

/// Lowers the confidence of seams by what the set leaves out, and returns that.
///
/// Offers are not sewn: once the confidence has fallen, more edges may stay open than before, and
/// the set is judged again.
pub(super) fn judge(
    pattern: &Pattern,
    garment: &GarmentModel,
    hints: &[NameHints],
    seams: &mut [SuggestedSeam],
) -> Completeness {
    let first: Vec<f64> = seams.iter().map(|seam| seam.confidence).collect();
    cohesion::distrust_parts_apart(pattern, seams);
    let mut found = Completeness::of(pattern, garment, hints, seams);
    let mut trust = 1.0;
    for _ in 0..MAX_ROUNDS {
        if found.trust() >= trust {
            break;
        }
        trust = found.trust();
        for (seam, first) in seams.iter_mut().zip(&first) {
            seam.confidence = (1e3 * first * trust).round() / 1e3;
        }
        cohesion::distrust_parts_apart(pattern, seams);
        if seams.iter().all(SuggestedSeam::is_offer) {
            break;
        }
        found = Completeness::of(pattern, garment, hints, seams);
    }
    found
}
