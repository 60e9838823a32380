//! The lines of a sheet, joined to chains layer by layer, and the outlines among them.

use super::chain::PathChain;
use super::end_pairs::EndPairs;
use super::gap::{Gap, REPAIRED, listed};
use super::join::join_paths;
use super::measured::MeasuredChain;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::drawing::labels::DxfLabels;
use crate::pattern::dxf::drawing::layers::{LayerRole, is_named, role};
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::entity::geometry::EntityPath;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use crate::pattern::polyline::longest_side;

/// The chains of a sheet by the role of their layer.
pub(super) struct SheetLines {
    pub(super) boundary: Vec<PathChain>,
    pub(super) sew: Vec<PathChain>,
    pub(super) internal: Vec<PathChain>,
    pub(super) cutout: Vec<PathChain>,
    pub(super) mirror: Vec<PathChain>,
    pub(super) general: Vec<PathChain>,
    /// True if sew lines lie on a layer with a name: general CAD, where the seam is the outline
    /// that was drawn and the cut line was added to it. In AAMA and ASTM it is the other way round.
    pub(super) seam_first: bool,
}

impl SheetLines {
    /// Joins the lines of a sheet.
    pub(super) fn of(sheet: &DxfSheet) -> Self {
        let has_named_sew = |layer: &str| role(layer) == LayerRole::Sew && is_named(layer);
        let chains_of = |role| chains_of(sheet, role);
        Self {
            boundary: chains_of(LayerRole::Boundary),
            sew: chains_of(LayerRole::Sew),
            internal: chains_of(LayerRole::Internal),
            cutout: chains_of(LayerRole::Cutout),
            mirror: chains_of(LayerRole::Mirror),
            general: chains_of(LayerRole::General),
            seam_first: sheet.entities.iter().any(|e| has_named_sew(&e.layer)),
        }
    }

    /// Returns the outlines: closed chains on the boundary layer, with sew lines that lie in none
    /// of them (where the seam comes first, the other way round); where there are neither, closed
    /// chains on layers without a meaning. Chains that should be outlines and are open are faults.
    pub(super) fn outlines(
        &self,
        sheet: &DxfSheet,
        findings: &mut DxfFindings,
    ) -> Vec<MeasuredChain> {
        let mut found = self.closed_outlines(sheet);
        if found.is_empty() {
            found = closed(&self.general);
        }
        let is_lost = sheet.block.is_some()
            && !self.seam_first
            && !self.boundary.is_empty()
            && self.boundary.iter().all(|chain| !chain.closed);
        if found.is_empty() || is_lost {
            for drawn in [&self.boundary, &self.sew, &self.general] {
                let outlines = open_outlines(drawn);
                for outline in &outlines {
                    let fault = open_outline(sheet, outline);
                    findings.leave_out(fault, outline.path_count);
                }
            }
        } else {
            self.warn_of_left_out(sheet, &found, findings);
        }
        found
    }

    fn closed_outlines(&self, sheet: &DxfSheet) -> Vec<MeasuredChain> {
        let (boundary, sew) = (closed(&self.boundary), closed(&self.sew));
        if self.seam_first {
            let alone = outside(boundary, |cut| sew.iter().any(|s| s.lies_in(cut)));
            return alone.chain(sew.clone()).collect();
        }
        if sheet.block.is_some() && !boundary.is_empty() {
            return boundary;
        }
        let alone = outside(sew, |s| boundary.iter().any(|cut| s.lies_in(cut)));
        let alone: Vec<MeasuredChain> = alone.collect();
        boundary.into_iter().chain(alone).collect()
    }

    /// Warns of outlines beside those that were found that all but close: pieces that are left out.
    fn warn_of_left_out(
        &self,
        sheet: &DxfSheet,
        found: &[MeasuredChain],
        findings: &mut DxfFindings,
    ) {
        let is_inside = |chain: &PathChain| {
            let p = chain.points.first();
            p.is_none_or(|p| found.iter().any(|outline| outline.contains(*p)))
        };
        let drawn = if self.boundary.is_empty() {
            &self.general
        } else {
            &self.boundary
        };
        for outline in open_outlines(drawn) {
            if all_but_closes(&outline) && !is_inside(&outline) {
                let detail = format!("{}; it was left out", openness(sheet, &outline));
                findings.warn(PatternCode::OpenOutline, outline.line, detail);
            }
        }
    }
}

/// Measures the closed ones among chains.
fn closed(chains: &[PathChain]) -> Vec<MeasuredChain> {
    let closed = chains.iter().filter(|chain| chain.closed);
    closed.cloned().map(MeasuredChain::new).collect()
}

/// Returns the chains for which `is_paired` does not hold.
fn outside(
    chains: Vec<MeasuredChain>,
    is_paired: impl Fn(&MeasuredChain) -> bool,
) -> impl Iterator<Item = MeasuredChain> {
    chains.into_iter().filter(move |chain| !is_paired(chain))
}

/// Joins the paths on layers of one role.
fn chains_of(sheet: &DxfSheet, wanted: LayerRole) -> Vec<PathChain> {
    let paths: Vec<(&EntityPath, usize)> = sheet
        .entities
        .iter()
        .filter(|e| role(&e.layer) == wanted)
        .filter_map(|e| Some((e.shape.path()?, e.line)))
        .collect();
    join_paths(&paths, wanted != LayerRole::Internal)
}

/// Returns the open chains, those joined whose ends lie near each other as one.
fn open_outlines(chains: &[PathChain]) -> Vec<PathChain> {
    let open: Vec<PathChain> = chains.iter().filter(|c| !c.closed).cloned().collect();
    EndPairs::of_outlines(&open).join(open)
}

/// Returns true if an open outline is of the size of a piece and closes but for gaps that are a
/// slip.
fn all_but_closes(outline: &PathChain) -> bool {
    /// Side of the smallest piece that is missed \[m\].
    const SIDE: f64 = 0.05;
    /// The largest gap that is a slip \[m\].
    const SLIP: f64 = 0.01;
    outline.closed
        && longest_side(&outline.points) >= SIDE
        && outline.gaps.iter().all(|gap| gap.size() <= SLIP)
}

fn open_outline(sheet: &DxfSheet, outline: &PathChain) -> Fault {
    let detail = openness(sheet, outline);
    Fault::new(PatternCode::OpenOutline, at_line(outline.line), detail)
        .fix("close the outline in the CAD program; gaps up to 0.5 mm are closed for you")
}

/// Returns a sentence on the gaps of an outline.
fn openness(sheet: &DxfSheet, outline: &PathChain) -> String {
    let chain = outline;
    let labels = DxfLabels::of(sheet.entities.iter());
    let name = labels.get("piece name").or(sheet.block.as_deref());
    let of = name.map_or_else(String::new, |name| format!(" of {name:?}"));
    let is_open = |gap: &&Gap| gap.size() > REPAIRED;
    let mut gaps: Vec<Gap> = outline.gaps.iter().filter(is_open).copied().collect();
    if let (false, Some(a), Some(b)) = (chain.closed, chain.points.first(), chain.points.last()) {
        gaps.push(Gap { ends: [*a, *b] });
    }
    let places = match gaps.len() {
        0 | 1 => "by".to_owned(),
        count => format!("at {count} places:"),
    };
    format!("an outline{of} is open {places} {}", listed(&gaps))
}
