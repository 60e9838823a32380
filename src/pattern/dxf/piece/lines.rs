//! The lines of a sheet, joined to chains layer by layer, and the outlines among them.

use super::chain::PathChain;
use super::join::join_paths;
use super::measured::MeasuredChain;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::drawing::labels::DxfLabels;
use crate::pattern::dxf::drawing::layers::{LayerRole, is_named, role};
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::entity::geometry::EntityPath;
use crate::pattern::dxf::findings::{DxfFindings, at_line};

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
        Self {
            boundary: chains_of(sheet, LayerRole::Boundary),
            sew: chains_of(sheet, LayerRole::Sew),
            internal: chains_of(sheet, LayerRole::Internal),
            cutout: chains_of(sheet, LayerRole::Cutout),
            mirror: chains_of(sheet, LayerRole::Mirror),
            general: chains_of(sheet, LayerRole::General),
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
            let drawn = self.boundary.iter().chain(&self.sew).chain(&self.general);
            let open = drawn.filter(|chain| !chain.closed);
            findings
                .faults
                .extend(open.map(|chain| open_outline(sheet, chain)));
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

/// Measures the closed ones among chains.
fn closed(chains: &[PathChain]) -> Vec<MeasuredChain> {
    let closed = chains.iter().filter(|chain| chain.closed);
    closed.cloned().map(MeasuredChain::new).collect()
}

fn open_outline(sheet: &DxfSheet, chain: &PathChain) -> Fault {
    let labels = DxfLabels::of(sheet.entities.iter());
    let name = labels.get("piece name").or(sheet.block.as_deref());
    let of = name.map_or_else(String::new, |name| format!(" of {name:?}"));
    let ends = match (chain.points.first(), chain.points.last()) {
        (Some(a), Some(b)) => format!(
            " between ({:.4}, {:.4}) m and ({:.4}, {:.4}) m",
            a[0], a[1], b[0], b[1]
        ),
        _ => String::new(),
    };
    let gap_mm = 1000.0 * chain.gap();
    let detail = format!("an outline{of} is open by {gap_mm:.2} mm{ends}");
    Fault::new(PatternCode::OpenOutline, at_line(chain.line), detail)
        .fix("close the outline in the CAD program; gaps up to 0.5 mm are closed for you")
}
