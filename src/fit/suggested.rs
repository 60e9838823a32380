//! Seams that the garment leaves to the service: suggested, with the places where panels start.

use super::garment::{Garment, SeamsAsked};
use crate::config::Limits;
use crate::fault::{Fault, Warning};
use crate::pattern::Pattern;
use crate::seam::suggest::{self, SuggestedSeam};

/// Puts suggested seams and placements into a garment that asks for them, and takes the panels that no seam was found
/// for, and that the garment says nothing of, out of the pattern: spare sleeves and linings would only fall down.
///
/// # Errors
/// No seam could be suggested.
pub(crate) fn fill(
    garment: &mut Garment,
    pattern: &mut Pattern,
    limits: &Limits,
) -> Result<Vec<Warning>, Fault> {
    if !matches!(garment.seams, SeamsAsked::Word(_)) {
        return Ok(vec![]);
    }
    let found = suggest::suggest(pattern, limits);
    if found.seams.is_empty() {
        let told = "no panel of this pattern was recognised, so that no seam can be suggested";
        return Err(Fault::new("seam/none_suggested", "/seams", told)
            .fix("list the seams, or give the panels telling names (front, back, sleeve)"));
    }
    for (id, panel) in found.panels {
        let asked = garment.panels.entry(id).or_default();
        asked.placement.get_or_insert(panel.placement);
    }
    let seams: Vec<_> = found
        .seams
        .into_iter()
        .map(|SuggestedSeam { pair, .. }| pair)
        .collect();
    let sewn = |id: &str| {
        let mut runs = seams
            .iter()
            .flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()));
        runs.any(|run| {
            run.panel == id || run.panel.strip_suffix(crate::pattern::MIRROR) == Some(id)
        })
    };
    let mentioned = |id: &str| sewn(id) || garment.panels.contains_key(id);
    pattern.panels.retain(|panel| mentioned(&panel.id));
    pattern.placements.retain(|id, _| mentioned(id));
    garment.seams = SeamsAsked::Pairs(seams);
    Ok(found.warnings)
}
