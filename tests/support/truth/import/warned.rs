//! Warnings: each must be true, and what must be warned about is.

use super::{Cell, File, Pair, list};

pub(super) fn cell(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let entry = file.entry;
    let unsaid = entry["insunits"].is_null() && entry["units_text"].is_null() && !says_units(file);
    let has_sew = |p: &Pair<'_>| !p.panel.cut_line.is_empty() || p.piece["has_cut_line"] == true;
    let sewn = pairs.iter().filter(|p| has_sew(p)).count();
    let off_fold = |p: &Pair<'_>| {
        !list(&p.piece["mirror_line"]).is_empty() && p.piece["mirror_on_boundary"] != true
    };
    let notch_off = |p: &Pair<'_>| {
        let (all, on) = (
            p.piece["notches"].as_u64(),
            p.piece["notches_on_boundary"].as_u64(),
        );
        all > on || p.piece["has_cut_line"] == true
    };
    let mut wrong = Vec::new();
    for warning in &file.pattern.warnings {
        let right = match warning.code.as_str() {
            "pattern/units_assumed" => unsaid,
            "pattern/allowance_mixed" => sewn > 0 && sewn < pairs.len(),
            "pattern/quantity" => pairs.iter().any(says_no_sides),
            "pattern/fold_ignored" => pairs.iter().any(off_fold),
            // Of truth files, the notches are counted in their own column.
            "pattern/notch_ignored" => file.truth.is_some() || pairs.iter().any(notch_off),
            _ => false,
        };
        if !right {
            wrong.push(format!(
                "{} at {}: {}",
                warning.code, warning.pointer, warning.detail
            ));
        }
    }
    let warned = |code: &str| file.pattern.warnings.iter().any(|w| w.code == code);
    if unsaid && !warned("pattern/units_assumed") {
        wrong.push("units were taken without a word".into());
    }
    if wrong.is_empty() {
        return Cell::Right(file.pattern.warnings.len().to_string());
    }
    Cell::of(&wrong)
}

/// Whether several are cut and the file does not say how many of them mirrored.
fn says_no_sides(pair: &Pair<'_>) -> bool {
    let stated = pair.piece["quantity"].as_str();
    stated.is_some_and(|s| !s.contains(',') && s.trim() > "1")
}

/// Generated files in blocks have the units as text or in the header.
fn says_units(file: &File<'_>) -> bool {
    file.entry["units_text"].is_null()
        && file.truth.is_some()
        && file
            .drawing
            .model
            .iter()
            .any(|e| e.kind == "TEXT" && e.layer == "1")
}
