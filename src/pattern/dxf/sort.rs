//! Sheets to pieces: what is an outline, and which lines and marks lie in which.

use super::chain::{Chain, chains};
use super::entity::{Path, Shape};
use super::expand::Sheet;
use super::label::Labels;
use super::layer::{Role, is_named, role};
use super::marks;
use super::nest::{self, Inner, Loop};
use super::piece::{Piece, outlines, owner};
use super::{Findings, at_line};
use crate::fault::Fault;
use std::collections::BTreeSet;

/// At most this many lines are compared with the outlines about them; more are taken as drawn lines.
const COMPARED: usize = 1000;

/// The pieces of a sheet; outlines that do not close become faults.
pub(super) fn pieces(sheet: &Sheet, panel_limit: usize, findings: &mut Findings) -> Vec<Piece> {
    let mut lines = Lines::of(sheet);
    let outlines = lines.outlines(sheet, findings);
    lines.outlines = outlines.iter().map(|outline| key(&outline.chain)).collect();
    // Sizes and letters drawn as outlines make more outlines than panels, but not without end.
    if outlines.len() > 4 * panel_limit {
        findings
            .faults
            .push(nest::too_many(outlines.len(), panel_limit, sheet.line));
        return Vec::new();
    }
    let (outer, inner) = nest::nest(nest::drop_duplicates(outlines, findings));
    let alone = outer.len() == 1 && sheet.block.is_some();
    let texts = marks::texts(sheet, &outer, alone, findings);
    let mut pieces: Vec<Piece> = outer
        .into_iter()
        .zip(&texts)
        .map(|(outline, own)| Piece::new(sheet, outline, own, alone))
        .collect();
    for piece in &mut pieces {
        piece.sewn = lines
            .sew
            .iter()
            .any(|sew| sew.line == piece.outline.chain.line);
    }
    for (owner, inner) in inner {
        let sewn = pieces[owner].outline.is_sewn_on(&inner);
        pieces[owner].adopt(inner.chain, if sewn { Inner::Sew } else { Inner::Line });
    }
    lines.assign(&mut pieces, alone, findings);
    marks::assign(sheet, &lines.mirror, &mut pieces, alone, findings);
    pieces
}

/// The chains of a sheet by role.
struct Lines {
    boundary: Vec<Chain>,
    sew: Vec<Chain>,
    internal: Vec<Chain>,
    cutout: Vec<Chain>,
    mirror: Vec<Chain>,
    general: Vec<Chain>,
    /// Whether sew lines lie on a layer with a name: general CAD, where the seam is the outline that was drawn and
    /// the cut line was added to it. In AAMA and ASTM it is the other way round.
    seam_first: bool,
    /// The outlines among them, those inside others too.
    outlines: BTreeSet<(usize, Option<[u64; 2]>)>,
}

impl Lines {
    fn of(sheet: &Sheet) -> Self {
        let of = |wanted: Role| {
            let paths: Vec<(&Path, usize)> = sheet
                .entities
                .iter()
                .filter(|e| role(&e.layer) == wanted)
                .filter_map(|e| {
                    if let Shape::Path(path) = &e.shape {
                        Some((path, e.line))
                    } else {
                        None
                    }
                })
                .collect();
            chains(&paths, wanted != Role::Internal)
        };
        Self {
            outlines: BTreeSet::new(),
            boundary: of(Role::Boundary),
            sew: of(Role::Sew),
            internal: of(Role::Internal),
            cutout: of(Role::Cutout),
            mirror: of(Role::Mirror),
            general: of(Role::General),
            seam_first: sheet
                .entities
                .iter()
                .any(|e| role(&e.layer) == Role::Sew && is_named(&e.layer)),
        }
    }

    /// The outlines: closed chains on the boundary layer, with sew lines that lie in none of them (where the seam
    /// comes first, the other way round); where there are neither, closed chains on layers without a meaning.
    fn outlines(&self, sheet: &Sheet, findings: &mut Findings) -> Vec<Loop> {
        let (boundary, sew) = (loops(&self.boundary), loops(&self.sew));
        let mut found = if self.seam_first {
            let alone = boundary
                .into_iter()
                .filter(|cut| !sew.iter().any(|s| s.lies_in(cut)));
            alone.chain(sew.clone()).collect()
        } else {
            let alone: Vec<Loop> = sew
                .into_iter()
                .filter(|s| !boundary.iter().any(|cut| s.lies_in(cut)))
                .collect();
            if sheet.block.is_some() && !boundary.is_empty() {
                boundary
            } else {
                boundary.into_iter().chain(alone).collect()
            }
        };
        if found.is_empty() {
            found = loops(&self.general);
        }
        let lost =
            sheet.block.is_some() && !self.seam_first && self.boundary.iter().all(|c| !c.closed);
        if found.is_empty() || lost && !self.boundary.is_empty() {
            let open = self
                .boundary
                .iter()
                .chain(&self.sew)
                .chain(&self.general)
                .filter(|c| !c.closed);
            findings
                .faults
                .extend(open.map(|chain| open_outline(sheet, chain)));
        }
        found
    }

    /// Gives every line that is not an outline to the piece that it lies in; one that lies in none is warned about.
    fn assign(&self, pieces: &mut [Piece], alone: bool, findings: &mut Findings) {
        let is_free = |chain: &&Chain| !self.outlines.contains(&key(chain));
        for chain in self.sew.iter().filter(is_free) {
            give(pieces, chain, Some(Inner::Sew), alone, findings);
        }
        for chain in &self.cutout {
            give(pieces, chain, Some(Inner::Hole), alone, findings);
        }
        for (i, chain) in self.internal.iter().enumerate() {
            let kind = (i >= COMPARED).then_some(Inner::Line);
            give(pieces, chain, kind, alone, findings);
        }
        let drawn = self.boundary.iter().chain(&self.general);
        let drawn: Vec<&Chain> = drawn.filter(is_free).collect();
        self.assign_cut_lines(&drawn, pieces, alone, findings);
    }

    /// Lines on the outline layers that are not outlines: cut lines about a seam, else lines on the cloth.
    fn assign_cut_lines(
        &self,
        drawn: &[&Chain],
        pieces: &mut [Piece],
        alone: bool,
        findings: &mut Findings,
    ) {
        for (i, chain) in drawn.iter().enumerate() {
            let is_free = |piece: &Piece| piece.cut.is_none();
            let may_cut = i < COMPARED && (!chain.closed || self.seam_first);
            let cut = pieces
                .iter()
                .position(|p| may_cut && is_free(p) && p.outline.is_cut_along(chain));
            match cut {
                Some(at) => {
                    said_gap(chain, findings);
                    pieces[at].cut = Some((*chain).clone());
                }
                None => give(pieces, chain, Some(Inner::Line), alone, findings),
            }
        }
    }
}

/// What tells one chain of a sheet from all others: the line of its first run and where it begins (a block that is put
/// in twice has the same lines again).
fn key(chain: &Chain) -> (usize, Option<[u64; 2]>) {
    (
        chain.line,
        chain.points.first().map(|p| p.map(f64::to_bits)),
    )
}

/// Gives a chain to the piece that it lies in. Without a kind, it is a sew line where its course is that of one.
fn give(
    pieces: &mut [Piece],
    chain: &Chain,
    kind: Option<Inner>,
    alone: bool,
    findings: &mut Findings,
) {
    let middle = chain.points.get(chain.points.len() / 2).copied();
    let Some(at) = middle.and_then(|at| owner(outlines(pieces), at, alone)) else {
        findings.left_out_many("line outside the pieces", chain.line, chain.runs);
        return;
    };
    if chain.points.len() < 2 {
        findings.left_out("line of a single point", chain.line);
        return;
    }
    let piece = &mut pieces[at];
    let kind = kind.unwrap_or_else(|| {
        let asked = chain.closed && piece.sew.is_none() && !piece.sewn;
        let sewn = asked && piece.outline.is_sewn_on(&Loop::new(chain.clone()));
        if sewn { Inner::Sew } else { Inner::Line }
    });
    if kind == Inner::Line {
        said_gap(chain, findings);
    }
    piece.adopt(chain.clone(), kind);
}

/// Warns of a gap in a line that no outline is made of; those of outlines are told with their panel.
fn said_gap(chain: &Chain, findings: &mut Findings) {
    if let Some(gap) = chain.repaired {
        let detail = format!("a gap of {:.3} mm in a line was closed", 1000.0 * gap);
        findings.warn("pattern/gap_closed", chain.line, detail);
    }
}

fn loops(chains: &[Chain]) -> Vec<Loop> {
    chains
        .iter()
        .filter(|c| c.closed)
        .cloned()
        .map(Loop::new)
        .collect()
}

fn open_outline(sheet: &Sheet, chain: &Chain) -> Fault {
    let name = Labels::of(sheet.entities.iter())
        .get("piece name")
        .map(str::to_owned)
        .or(sheet.block.clone());
    let of = name.map_or_else(String::new, |name| format!(" of {name:?}"));
    let ends = match (chain.points.first(), chain.points.last()) {
        (Some(a), Some(b)) => format!(
            " between ({:.4}, {:.4}) m and ({:.4}, {:.4}) m",
            a[0], a[1], b[0], b[1]
        ),
        _ => String::new(),
    };
    Fault::new(
        "pattern/open_outline",
        at_line(chain.line),
        format!(
            "an outline{of} is open by {:.2} mm{ends}",
            1000.0 * chain.gap()
        ),
    )
    .fix("close the outline in the CAD program; gaps up to 0.5 mm are closed for you")
}
