//! DXF bytes to a pattern, in nine calls; each takes what the one before it gave.
//!
//! 1. [`read::text`] decodes the file, text or binary, to text.
//! 2. [`DxfDrawing::parse`] splits the text into tags and records ([`read`]) and makes entities of
//!    them ([`entity`]): blocks and a model space, in drawing units.
//! 3. [`blocks::place`] puts the blocks in place: sheets of entities, in meters ([`drawing`]).
//! 4. [`classify::pieces`] joins their lines to outlines and gives every other line, mark and text
//!    to the piece that it lies in ([`piece`]).
//! 5. [`select::one_size`] keeps the pieces of one size of a graded file.
//! 6. [`size_plan::SizePlan::grade`] makes another size of them, where a grade rule table is given.
//! 7. [`drawn_notches::take_notches`] takes notches that are drawn into outlines out of them.
//! 8. [`drawn_darts::cut_darts`] cuts darts that are drawn as lines into them.
//! 9. [`build_panels`] makes a panel of each piece.
//!
//! Source of the dialects: ANSI/AAMA-292 and ASTM D6673 (layers, labels), and the DXF reference of
//! Autodesk (group codes). Assumption: the drawing is flat; what is not is seen from above.

mod drawing;
mod entity;
mod findings;
mod piece;
mod read;

use self::drawing::contents::DxfDrawing;
use self::drawing::{blocks, dialect, units};
use self::findings::DxfFindings;
use self::piece::dxf_piece::DxfPiece;
use self::piece::{classify, drawn_darts, drawn_notches, panel, select, size_plan};
use super::{Allowance, ImportOptions, Panel, Pattern, Source, copies, ids};
use crate::config::Limits;
use crate::fault::{Fault, Faults, PatternCode};
use std::collections::BTreeMap;

pub(super) use self::read::file_type::is_dxf;

/// Reads a pattern from the bytes of a DXF file.
///
/// # Errors
/// Every fault that keeps the file from being read, each with its line.
pub(super) fn import(
    bytes: &[u8],
    options: &ImportOptions,
    limits: &Limits,
) -> Result<Pattern, Faults> {
    let mut findings = DxfFindings::new(options.strict);
    match read_pattern(bytes, options, limits, &mut findings) {
        Ok(pattern) => findings.into_result(pattern),
        Err(fault) => Err(findings.into_faults_with(fault)),
    }
}

/// Reads a pattern; stops at a fault after which nothing could be read.
fn read_pattern(
    bytes: &[u8],
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<Pattern, Fault> {
    let text = read::text(bytes, options.encoding, limits, findings)?;
    let drawing = DxfDrawing::parse(&text, limits, findings)?;
    let labels = blocks::file_labels(&drawing, limits);
    let unit = units::determine(options.units, &labels, drawing.insunits, findings);
    let sheets = blocks::place(&drawing, unit, limits, findings)?;
    let format = dialect::detect(&drawing, &labels);
    drop(drawing);
    let pieces = classify::pieces(&sheets, options, limits, findings);
    let plan = size_plan::plan(&pieces, options)?;
    let wanted = match &plan {
        Some(plan) => plan.drawn_sample(&pieces).map(str::to_owned),
        None => options.size.clone(),
    };
    let (mut pieces, mut sizes) = select::one_size(pieces, wanted.as_deref(), &labels, findings)?;
    if let Some(plan) = plan {
        plan.grade(&mut pieces, &mut sizes, limits, findings)?;
    }
    select::check(&pieces, unit, limits, findings)?;
    for piece in &mut pieces {
        drawn_notches::take_notches(piece, options.notches, findings);
        drawn_darts::cut_darts(piece, options.darts, limits, findings);
    }
    let name = labels.get("style name").or(options.name.as_deref());
    let name = name.unwrap_or("pattern");
    let (pieces, mut panels) = build_panels(pieces, name, options, limits, findings);
    findings.settle_left_out(panels.is_empty());
    let allowance = allowance(&pieces, &panels, findings);
    let mut warnings = findings.take_warnings();
    warnings.extend(copies::add_stated(&mut panels));
    Ok(Pattern {
        id: None,
        source: Source {
            format,
            units: unit.name().to_owned(),
            scale_to_m: unit.in_meters(),
            sample_size: sizes.chosen,
            sizes: sizes.all,
            allowance,
        },
        name: name.chars().take(limits.name_chars).collect(),
        panels,
        seams: Vec::new(),
        placements: BTreeMap::new(),
        warnings,
    })
}

/// Makes the panels, with ids made from the names of the pieces; returns the pieces that became one
/// with them.
fn build_panels(
    pieces: Vec<DxfPiece>,
    style: &str,
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> (Vec<DxfPiece>, Vec<Panel>) {
    let build = |piece: DxfPiece| {
        let panel = panel::build(&piece, options, limits, findings)?;
        Some((piece, panel))
    };
    let (pieces, mut panels): (Vec<_>, Vec<_>) = pieces.into_iter().filter_map(build).unzip();
    let names: Vec<String> = panels.iter().map(|panel| panel.name.clone()).collect();
    for (panel, id) in panels.iter_mut().zip(ids::from_names(&names, style)) {
        panel.id = id;
    }
    (pieces, panels)
}

/// Returns `SewLine` where sew lines became the outlines of all panels. Where only some panels have
/// one, the user is warned.
fn allowance(pieces: &[DxfPiece], panels: &[Panel], findings: &mut DxfFindings) -> Allowance {
    let sewn = pieces.iter().zip(panels).filter(|(piece, panel)| {
        piece.is_sewn || piece.sew.is_some() && !panel.cut_line.is_empty()
    });
    match sewn.count() {
        0 => Allowance::Unknown,
        count if count == panels.len() => Allowance::SewLine,
        count => {
            let detail = format!(
                "{count} of {} panels have a sew line; the outlines of the others may include seam allowance",
                panels.len()
            );
            findings.warn(PatternCode::AllowanceMixed, pieces[0].line, detail);
            Allowance::Unknown
        }
    }
}
