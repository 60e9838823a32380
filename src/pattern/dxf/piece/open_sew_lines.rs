//! Sew lines that are open where they meet the edge of their cut line: at a fold, mostly.

use super::chain::PathChain;
use super::lines::SheetLines;
use super::measured::MeasuredChain;
use super::shared_edges::ends;
use crate::fault::PatternCode;
use crate::pattern::Point2;
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::point::lerp;
use crate::pattern::polyline::{nearest, segments};

/// Ends this near to a line lie on it \[m\].
const ON: f64 = 2e-4;

/// At most this many open lines of a sheet are looked at.
const MOST: usize = 200;

/// Words of notes on pieces that are cut on the fold.
const FOLD_NOTES: [&str; 6] = ["fold", "stoffbruch", "pliure", "piega", "doblez", "сгиб"];

/// Closes the open sew lines of a sheet that end on a straight edge of their cut line, which is a
/// fold where the sheet tells of halves. Each is warned about. A stated fold closes them by itself.
pub(super) fn close(lines: &mut SheetLines, sheet: &DxfSheet, findings: &mut DxfFindings) {
    if !lines.mirror.is_empty() || lines.sew.iter().all(|chain| chain.closed) {
        return;
    }
    let is_half = is_half(sheet);
    let cut = lines.boundary.iter().filter(|chain| chain.closed);
    let cut: Vec<MeasuredChain> = cut.cloned().map(MeasuredChain::new).collect();
    for sew in lines
        .sew
        .iter_mut()
        .filter(|chain| !chain.closed)
        .take(MOST)
    {
        let Some(edge) = ends(sew) else {
            continue;
        };
        let closed = MeasuredChain::new(PathChain {
            closed: true,
            ..sew.clone()
        });
        let is_of = |cut: &MeasuredChain| is_on_edge(edge, &cut.chain) && cut.is_sewn_on(&closed);
        if !cut.iter().any(is_of) {
            continue;
        }
        sew.closed = true;
        let detail = if is_half {
            lines.mirror.push(fold(edge, sew.line));
            "a sew line is open along a straight edge of its cut line, which was taken as the fold (unfold=none keeps the half)"
        } else {
            "a sew line is open along a straight edge of its cut line and was closed there; draw the fold on layer 6 if it is half a piece"
        };
        findings.warn(PatternCode::FoldAssumed, sew.line, detail);
    }
}

fn fold(ends: [Point2; 2], line: usize) -> PathChain {
    PathChain {
        points: ends.to_vec(),
        path_end: vec![true; 2],
        sampled: vec![false; 2],
        closed: false,
        gaps: vec![],
        line,
        path_count: 0,
    }
}

/// Returns true if the straight way between two points runs on a closed line.
fn is_on_edge([a, b]: [Point2; 2], outline: &PathChain) -> bool {
    let places = [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| lerp(a, b, t));
    let mut feet = places
        .iter()
        .map(|p| nearest(segments(&outline.points), *p));
    feet.all(|foot| foot.is_some_and(|foot| foot.distance <= ON))
}

/// Returns true if a sheet tells that it holds halves: put in mirrored, or by a note.
fn is_half(sheet: &DxfSheet) -> bool {
    let is_note = |entity: &DxfEntity| match &entity.shape {
        EntityShape::Text(_, text) => {
            let text = text.to_lowercase();
            FOLD_NOTES.iter().any(|word| text.contains(word))
        }
        _ => false,
    };
    sheet.linear.mirrors() || sheet.entities.iter().any(is_note)
}
