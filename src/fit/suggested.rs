//! Seams that the garment leaves to the service: suggested, with the places where panels start.

use super::garment::{Garment, SeamsAsked};
use crate::config::Limits;
use crate::fault::{Fault, Warning};
use crate::pattern::{MIRROR, Pattern, SeamPair};
use crate::seam::suggest::{self, SuggestedSeam};

/// That no seam is suggested for a panel.
const NOT_SUGGESTED: &str = "seam/not_suggested";
/// That panels were taken out of the pattern.
const LEFT_OUT: &str = "seam/left_out";

/// Puts suggested seams and placements into a garment that asks for them, and takes the panels that no seam was found
/// for, and that the garment says nothing of, out of the pattern: spare sleeves and linings would only fall down.
/// Returns the seams with their reasons.
///
/// # Errors
/// No seam could be suggested.
pub(crate) fn fill(
    garment: &mut Garment,
    pattern: &mut Pattern,
    limits: &Limits,
) -> Result<Vec<SuggestedSeam>, Fault> {
    if !matches!(garment.seams, SeamsAsked::Word(_)) {
        return Ok(vec![]);
    }
    let found = suggest::suggest(pattern, limits);
    if found.seams.is_empty() {
        let told = found
            .warnings
            .first()
            .map_or_else(String::new, |w| format!(": {}", w.detail));
        let told = format!("no seam can be suggested for this pattern{told}");
        return Err(Fault::new("seam/none_suggested", "/seams", told)
            .fix("list the seams, or give the panels telling names (front, back, sleeve)"));
    }
    for (id, panel) in found.panels {
        let source = id.strip_suffix(MIRROR).unwrap_or(&id);
        let placed = garment
            .panels
            .get(source)
            .is_some_and(|asked| asked.placement.is_some());
        if pattern.placements.contains_key(source) || placed && source != id {
            continue; // The file or the client knows better, and a copy follows its source.
        }
        let asked = garment.panels.entry(id).or_default();
        asked.placement.get_or_insert(panel.placement);
    }
    pattern.warnings.retain(|warning| !is_ours(warning));
    pattern.warnings.extend(found.warnings);
    leave_out(garment, pattern, &found.seams);
    let pairs = found.seams.iter().map(|seam| SeamPair {
        confidence: Some(seam.confidence),
        because: Some(seam.because.clone()),
        ..seam.pair.clone()
    });
    garment.seams = SeamsAsked::Pairs(pairs.collect());
    Ok(found.seams)
}

/// What was told when the seams of a garment were suggested. It stays with the pattern, so that a saved garment tells it
/// again.
pub(crate) fn warnings(pattern: &Pattern) -> Vec<Warning> {
    let told = pattern.warnings.iter();
    told.filter(|warning| is_ours(warning)).cloned().collect()
}

fn is_ours(warning: &Warning) -> bool {
    [NOT_SUGGESTED, LEFT_OUT].contains(&warning.code.as_str())
}

/// Takes panels that nothing mentions out of the pattern, and says so.
fn leave_out(garment: &Garment, pattern: &mut Pattern, seams: &[SuggestedSeam]) {
    let is_of = |panel: &str, id: &str| panel == id || panel.strip_suffix(MIRROR) == Some(id);
    let mentioned = |id: &str| {
        let sides = seams.iter().flat_map(|seam| [&seam.pair.a, &seam.pair.b]);
        let mut runs = sides.flat_map(|side| side.runs());
        runs.any(|run| is_of(&run.panel, id)) || garment.panels.keys().any(|panel| is_of(panel, id))
    };
    let (kept, spare): (Vec<_>, Vec<_>) = std::mem::take(&mut pattern.panels)
        .into_iter()
        .partition(|panel| mentioned(&panel.id));
    pattern.panels = kept;
    if spare.is_empty() {
        return;
    }
    let ids: Vec<_> = spare.iter().map(|panel| panel.id.as_str()).collect();
    for id in &ids {
        pattern.placements.remove(*id);
    }
    let told = format!(
        "left out, because no seam is suggested for them and the garment says nothing of them: {}",
        ids.join(", ")
    );
    let warning = Warning::new(LEFT_OUT, "/pattern/panels", told);
    pattern.warnings.push(warning);
}
