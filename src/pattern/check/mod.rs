//! A pattern that came as JSON: checked as a whole, all faults at once; lengths and areas computed
//! anew.

mod copies;
mod panel;

use self::panel::{AT_CORNER, PanelChecker};
use super::Pattern;
use super::point::FARTHEST;
use crate::config::Limits;
use crate::fault::{Fault, Faults, PatternCode, pointer_token};
use std::collections::BTreeSet;

/// Checks `pattern` and recomputes lengths, perimeters and areas.
pub(super) fn checked(mut pattern: Pattern, limits: &Limits) -> Result<Pattern, Faults> {
    let mut faults = Faults(Vec::new());
    if pattern.panels.is_empty() {
        let detail = "the pattern has no panels";
        let fault = Fault::new(PatternCode::NoPanels, "/panels", detail);
        faults.0.push(fault.fix("give at least one"));
    }
    check_counts(&pattern, limits)?;
    faults.0.extend(check_ids(&pattern, limits));
    for (i, panel) in pattern.panels.iter_mut().enumerate() {
        let checker = PanelChecker::new(format!("/panels/{i}"), limits);
        faults.0.extend(checker.check(panel));
    }
    faults
        .0
        .extend(copies::check_copies(&mut pattern, AT_CORNER));
    faults.0.extend(check_placements(&pattern));
    faults.or(pattern)
}

/// Checks that there are not too many panels and seams; mirrored copies do not count.
fn check_counts(pattern: &Pattern, limits: &Limits) -> Result<(), Fault> {
    let count = pattern.panels.len();
    let drawn = pattern.panels.iter().filter(|p| p.copy_of.is_none());
    if drawn.count() > limits.panels || count > 2 * limits.panels {
        let detail = format!(
            "the pattern has {count} panels; at most {} are read",
            limits.panels
        );
        let fault = Fault::new(PatternCode::TooManyPanels, "/panels", detail);
        return Err(fault.fix("leave some out"));
    }
    if pattern.seams.len() > limits.seams {
        let detail = format!(
            "the pattern has {} seams; at most {} are read",
            pattern.seams.len(),
            limits.seams
        );
        let fault = Fault::new(PatternCode::TooManySeams, "/seams", detail);
        return Err(fault.fix("leave some out"));
    }
    Ok(())
}

/// Checks that placements are of panels that are there, at finite places.
fn check_placements(pattern: &Pattern) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (id, placement) in &pattern.placements {
        let at = format!("/placements/{}", pointer_token(id));
        if pattern.panel_index(id).is_none() {
            let detail = format!("there is no panel {id:?}");
            let fault = Fault::new(PatternCode::UnknownPanel, at.clone(), detail);
            faults.push(fault.fix("name a panel of this pattern"));
        }
        let mut numbers = placement.offset_m.iter().chain(&placement.rotate_deg);
        if numbers.any(|c| c.is_nan() || c.abs() > FARTHEST) {
            let detail = "a number is not finite or is beyond 10 km";
            faults.push(Fault::new(PatternCode::NotFinite, at, detail).fix("correct it"));
        }
    }
    faults
}

/// Checks that ids are there, short and different.
fn check_ids(pattern: &Pattern, limits: &Limits) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    for (i, panel) in pattern.panels.iter().enumerate() {
        let at = format!("/panels/{i}/id");
        if panel.id.is_empty() || panel.id.chars().count() > limits.name_chars {
            let detail = format!("an id has 1 to {} characters", limits.name_chars);
            faults.push(Fault::new(PatternCode::Id, at.clone(), detail).fix("give it another id"));
        }
        if !seen.insert(&panel.id) {
            let detail = format!("{:?} is the id of an earlier panel", panel.id);
            let fault = Fault::new(PatternCode::DuplicateId, at, detail);
            faults.push(fault.fix("give every panel its own id"));
        }
    }
    faults
}
