//! Seams that the garment leaves to the service: suggested, with the places where panels start.

use super::garment::{Garment, SeamsSpec};
use crate::config::Limits;
use crate::fault::{Fault, SeamCode, Warning};
use crate::pattern::{MIRROR, Pattern, SeamPair};
use crate::seam::suggest::{self, SuggestedSeam, Suggestion};

/// The seams of a garment, listed.
pub(super) struct ListedSeams {
    /// The seams as pairs, stated or suggested.
    pub(super) pairs: Vec<SeamPair>,
    /// The suggested ones with their reasons; none where the garment lists its seams.
    pub(super) suggested: Vec<SuggestedSeam>,
}

/// Lists the seams of a garment, suggesting them if it asks for that.
///
/// Suggesting also puts placements into the garment, and takes the panels that no seam was found
/// for, and that the garment does not mention, out of the pattern: spare sleeves and linings would
/// only fall down.
///
/// # Errors
/// If no seam could be suggested.
pub(super) fn list_seams(
    garment: &mut Garment,
    pattern: &mut Pattern,
    limits: &Limits,
) -> Result<ListedSeams, Fault> {
    if let SeamsSpec::Pairs(pairs) = &garment.seams {
        return Ok(ListedSeams {
            pairs: pairs.clone(),
            suggested: vec![],
        });
    }
    let Suggestion {
        seams,
        panels,
        warnings,
        ..
    } = suggest::suggest(pattern, limits);
    if seams.is_empty() {
        return Err(none_suggested(warnings.first()));
    }
    for (id, panel) in panels {
        let source = id.strip_suffix(MIRROR).unwrap_or(&id);
        let stated = garment.panels.get(source);
        let is_placed = stated.is_some_and(|spec| spec.placement.is_some());
        if pattern.placements.contains_key(source) || is_placed && source != id {
            continue; // The file or the client knows better, and a copy follows its source.
        }
        let spec = garment.panels.entry(id).or_default();
        spec.placement.get_or_insert(panel.placement);
    }
    pattern
        .warnings
        .retain(|warning| !is_of_suggestion(warning));
    pattern.warnings.extend(warnings);
    drop_unmentioned(garment, pattern, &seams);
    let pairs = seams.iter().map(|seam| SeamPair {
        confidence: Some(seam.confidence),
        because: Some(seam.because.clone()),
        ..seam.pair.clone()
    });
    Ok(ListedSeams {
        pairs: pairs.collect(),
        suggested: seams,
    })
}

fn none_suggested(warning: Option<&Warning>) -> Fault {
    let reason = warning.map_or_else(String::new, |w| format!(": {}", w.detail));
    let detail = format!("no seam can be suggested for this pattern{reason}");
    Fault::new(SeamCode::NoneSuggested, "/seams", detail)
        .fix("list the seams, or give the panels telling names (front, back, sleeve)")
}

/// Returns the warnings of suggesting the seams of a garment. They stay with the pattern, so that a
/// saved garment repeats them.
pub(super) fn warnings(pattern: &Pattern) -> Vec<Warning> {
    let warnings = pattern.warnings.iter();
    warnings.filter(|w| is_of_suggestion(w)).cloned().collect()
}

fn is_of_suggestion(warning: &Warning) -> bool {
    warning.code == SeamCode::NotSuggested || warning.code == SeamCode::LeftOut
}

/// Takes the panels that neither a seam nor the garment mentions out of the pattern, and warns of
/// it.
fn drop_unmentioned(garment: &Garment, pattern: &mut Pattern, seams: &[SuggestedSeam]) {
    let (kept, spare): (Vec<_>, Vec<_>) = std::mem::take(&mut pattern.panels)
        .into_iter()
        .partition(|panel| is_mentioned(&panel.id, garment, seams));
    pattern.panels = kept;
    if spare.is_empty() {
        return;
    }
    let ids: Vec<_> = spare.iter().map(|panel| panel.id.as_str()).collect();
    for id in &ids {
        pattern.placements.remove(*id);
    }
    let detail = format!(
        "left out, because no seam is suggested for them and the garment says nothing of them: {}",
        ids.join(", ")
    );
    let warning = Warning::new(SeamCode::LeftOut, "/pattern/panels", detail);
    pattern.warnings.push(warning);
}

/// Returns true if a seam or the garment names the panel or its mirrored copy.
fn is_mentioned(id: &str, garment: &Garment, seams: &[SuggestedSeam]) -> bool {
    let is_of = |panel: &str| panel == id || panel.strip_suffix(MIRROR) == Some(id);
    let sides = seams.iter().flat_map(|seam| [&seam.pair.a, &seam.pair.b]);
    let mut runs = sides.flat_map(|side| side.runs());
    runs.any(|run| is_of(&run.panel)) || garment.panels.keys().any(|panel| is_of(panel))
}
