//! Seams that the garment leaves to the service: suggested, with the places where panels start.

use super::garment::{Garment, SeamsSpec};
use crate::config::Limits;
use crate::fault::{Fault, SeamCode, Warning};
use crate::pattern::{MIRROR, Pattern, SeamPair};
use crate::seam::suggest::{self, MIN_SEWN_CONFIDENCE, SuggestedPanel, SuggestedSeam, Suggestion};
use std::collections::BTreeSet;

/// Reasons and seams that one message tells.
const MAX_REASONS: usize = 8;
const MAX_NAMES: usize = 20;

/// The seams of a garment, listed.
pub(super) struct ListedSeams {
    /// The seams as pairs, stated or suggested.
    pub(super) pairs: Vec<SeamPair>,
    /// The suggested ones with their reasons; none where the garment lists its seams.
    pub(super) suggested: Vec<SuggestedSeam>,
}

/// Lists the seams of a garment, suggesting them if it asks for that.
///
/// Only seams that are sure enough are sewn: offers are left out, and a warning tells of them.
/// Suggesting also puts placements into the garment, and takes the panels that no such seam was
/// found for, and that the garment does not mention, out of the pattern: spare sleeves and linings
/// would only fall down.
///
/// # Errors
/// If no seam could be suggested, or offers only, for panels that need one.
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
    } = suggest::suggest(pattern, limits);
    let (offers, seams): (Vec<_>, Vec<_>) = seams.into_iter().partition(SuggestedSeam::is_offer);
    let needs_none = offers.is_empty() && !panels.is_empty();
    if seams.is_empty() && !needs_none {
        return Err(none_suggested(&offers, &warnings));
    }
    let sewn: BTreeSet<&str> = seams.iter().flat_map(SuggestedSeam::panels).collect();
    let placed = panels
        .into_iter()
        .filter(|(id, _)| sewn.is_empty() || sewn.contains(id.as_str()));
    place(garment, pattern, placed);
    pattern
        .warnings
        .retain(|warning| !is_of_suggestion(warning));
    pattern.warnings.extend(warnings);
    pattern.warnings.extend(not_sewn(&offers));
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

/// Puts suggested placements into the garment, where neither it nor the pattern's file has one: the
/// file or the client knows better, and a copy follows its source.
fn place(
    garment: &mut Garment,
    pattern: &Pattern,
    panels: impl Iterator<Item = (String, SuggestedPanel)>,
) {
    for (id, panel) in panels {
        let source = id.strip_suffix(MIRROR).unwrap_or(&id);
        let stated = garment.panels.get(source);
        let is_placed = stated.is_some_and(|spec| spec.placement.is_some());
        if pattern.placements.contains_key(source) || is_placed && source != id {
            continue;
        }
        let spec = garment.panels.entry(id).or_default();
        spec.placement.get_or_insert(panel.placement);
    }
}

/// Returns the fault of a pattern without a seam that is sure enough to be sewn, with the reasons.
fn none_suggested(offers: &[SuggestedSeam], warnings: &[Warning]) -> Fault {
    let mut reasons: Vec<&str> = warnings.iter().map(|w| w.detail.as_str()).collect();
    let more = reasons.len().saturating_sub(MAX_REASONS);
    reasons.truncate(MAX_REASONS);
    let mut because = match (reasons.as_slice(), more) {
        ([], _) => String::new(),
        (told, 0) => format!(": {}", told.join("; ")),
        (told, more) => format!(": {}; and {more} reasons more", told.join("; ")),
    };
    if offers.is_empty() {
        let detail = format!("no seam can be suggested for this pattern{because}");
        return Fault::new(SeamCode::NoneSuggested, "/seams", detail)
            .fix("list the seams, or give the panels telling names (front, back, sleeve)");
    }
    because.insert_str(0, &format!(" ({})", names(offers)));
    let detail = format!(
        "the seams that are suggested for this pattern are offers of a confidence below {MIN_SEWN_CONFIDENCE}, which are not sewn unasked{because}"
    );
    Fault::new(SeamCode::NoneSuggested, "/seams", detail).fix(
        "list the seams; to accept offers of `POST seams/suggest`, list them in `seams` as they are",
    )
}

/// Returns the warning of offers that are left out of a garment whose other seams are sewn.
fn not_sewn(offers: &[SuggestedSeam]) -> Option<Warning> {
    let detail = format!(
        "suggested seams of a confidence below {MIN_SEWN_CONFIDENCE} are offers and were not sewn: {}; to have them, list them in `seams` with the others",
        names(offers)
    );
    (!offers.is_empty()).then(|| Warning::new(SeamCode::OfferNotSewn, "/seams", detail))
}

/// Returns the names of seams, with what they join and how sure they are.
fn names(offers: &[SuggestedSeam]) -> String {
    let more = offers.len().saturating_sub(MAX_NAMES);
    let name = |seam: &SuggestedSeam| {
        let panels: BTreeSet<&str> = seam.panels().collect();
        let panels: Vec<&str> = panels.into_iter().collect();
        let (id, confidence) = (&seam.pair.id, seam.confidence);
        format!("`{id}` of {}, {confidence}", panels.join(" and "))
    };
    let mut all: Vec<String> = offers.iter().take(MAX_NAMES).map(name).collect();
    if more > 0 {
        all.push(format!("{more} more"));
    }
    all.join("; ")
}

/// Returns the warnings of suggesting the seams of a garment. They stay with the pattern, so that a
/// saved garment repeats them.
pub(super) fn warnings(pattern: &Pattern) -> Vec<Warning> {
    let warnings = pattern.warnings.iter();
    warnings.filter(|w| is_of_suggestion(w)).cloned().collect()
}

fn is_of_suggestion(warning: &Warning) -> bool {
    warning.code == SeamCode::NotSuggested
        || warning.code == SeamCode::LeftOut
        || warning.code == SeamCode::OfferNotSewn
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
        "left out, because no seam that is sure enough is suggested for them and the garment says nothing of them: {}",
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
