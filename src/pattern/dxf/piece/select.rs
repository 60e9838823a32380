//! The pieces that are imported: those of one size, within the limits.

use super::dxf_piece::DxfPiece;
use super::nest;
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Units;
use crate::pattern::dxf::drawing::labels::DxfLabels;
use crate::pattern::dxf::drawing::sizes::{self, SizeChoice};
use crate::pattern::dxf::drawing::units;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::polyline::longest_side;
use std::collections::BTreeSet;

/// Keeps the pieces of one size: the one that is wanted, else that of the file's labels.
///
/// # Errors
/// A wanted size that the file does not have, or no pieces at all.
pub(crate) fn one_size(
    pieces: Vec<DxfPiece>,
    wanted: Option<&str>,
    file: &DxfLabels,
    findings: &mut DxfFindings,
) -> Result<(Vec<DxfPiece>, SizeChoice), Fault> {
    let labels: Vec<&DxfLabels> = pieces.iter().map(|piece| &piece.labels).collect();
    let choice = sizes::choose(wanted, file, &labels, findings)?;
    let named: Vec<(&str, Option<&str>)> = pieces
        .iter()
        .map(|piece| (piece.name.as_str(), piece.labels.get("size")))
        .collect();
    let keep = sizes::is_imported(&choice, &named);
    warn_of_missing_size(&pieces, &keep, &choice, findings);
    let pieces = pieces.into_iter().zip(keep);
    let kept = pieces.filter_map(|(piece, keep)| keep.then_some(piece));
    let kept: Vec<DxfPiece> = kept.collect();
    if kept.is_empty() {
        return Err(findings.no_outline());
    }
    Ok((kept, choice))
}

/// Warns of the pieces that the file has in other sizes than the one that is imported.
fn warn_of_missing_size(
    pieces: &[DxfPiece],
    keep: &[bool],
    choice: &SizeChoice,
    findings: &mut DxfFindings,
) {
    let kept = pieces.iter().zip(keep).filter(|(_, keep)| **keep);
    let mut known: BTreeSet<&str> = kept.map(|(piece, _)| piece.name.as_str()).collect();
    for piece in pieces {
        if known.insert(&piece.name) {
            let detail = format!(
                "{:?} has no size {}, and is left out; size= chooses another",
                piece.name,
                choice.chosen.as_deref().unwrap_or_default()
            );
            findings.warn(PatternCode::SizeMissing, piece.line, detail);
        }
    }
}

/// Checks the number of pieces, and the unit by the largest of them.
///
/// # Errors
/// More pieces than are read, or a size beyond the limits.
pub(crate) fn check(
    pieces: &[DxfPiece],
    unit: Units,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<(), Fault> {
    if pieces.len() > limits.panels {
        let line = pieces[0].line;
        return Err(nest::too_many(pieces.len(), limits.panels, line));
    }
    units::check(unit, largest_side(pieces), limits.panel_size_m, findings)
}

/// Returns the longest side of the box of any outline; 0 if there is none \[m\].
fn largest_side(pieces: &[DxfPiece]) -> f64 {
    pieces
        .iter()
        .map(|piece| &piece.outline.chain.points)
        .filter(|points| points.len() > 2)
        .map(|points| longest_side(points))
        .fold(0.0, f64::max)
}
