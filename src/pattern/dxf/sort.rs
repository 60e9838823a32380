//! Sheets to pieces: what is an outline, and which lines and marks lie in which.

use super::chain::{Chain, chains};
use super::entity::{P, Path, Shape};
use super::expand::Sheet;
use super::label::Labels;
use super::layer::{Role, is_named, role};
use super::nest::{self, Inner, Loop};
use super::piece::{Piece, owner};
use super::{Findings, at_line};
use crate::fault::Fault;

/// At most this many lines are compared with the outlines about them; more are taken as drawn lines.
const COMPARED: usize = 1000;

/// The pieces of a sheet; outlines that do not close become faults.
pub(super) fn pieces(sheet: &Sheet, panel_limit: usize, findings: &mut Findings) -> Vec<Piece> {
    let lines = Lines::of(sheet);
    let outlines = lines.outlines(sheet, findings);
    // Sizes and letters drawn as outlines make more outlines than panels, but not without end.
    if outlines.len() > 4 * panel_limit {
        findings
            .faults
            .push(nest::too_many(outlines.len(), panel_limit, sheet.line));
        return Vec::new();
    }
    let (outer, inner) = nest::nest(nest::drop_duplicates(outlines, findings));
    let alone = outer.len() == 1 && sheet.block.is_some();
    let mut pieces: Vec<Piece> = outer
        .into_iter()
        .map(|outline| Piece::new(sheet, outline, alone))
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
    assign_marks(sheet, &lines.mirror, &mut pieces, alone);
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
            chains(&paths)
        };
        Self {
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

    /// Gives every line that is not an outline to the piece that it lies in.
    fn assign(&self, pieces: &mut [Piece], alone: bool, findings: &mut Findings) {
        let middle = |chain: &Chain| chain.points.get(chain.points.len() / 2).copied();
        let is_outline = |pieces: &[Piece], chain: &Chain| {
            pieces.iter().any(|p| p.outline.chain.line == chain.line)
        };
        let known = self
            .sew
            .iter()
            .map(|c| (c, Inner::Sew))
            .chain(self.cutout.iter().map(|c| (c, Inner::Hole)));
        for (chain, kind) in known {
            if is_outline(pieces, chain) {
                continue;
            }
            if let Some(at) = middle(chain).and_then(|at| owner(pieces, at, alone)) {
                pieces[at].adopt(chain.clone(), kind);
            }
        }
        for (i, chain) in self.internal.iter().enumerate() {
            let Some(at) = middle(chain).and_then(|at| owner(pieces, at, alone)) else {
                continue;
            };
            let asked =
                i < COMPARED && chain.closed && pieces[at].sew.is_none() && !pieces[at].sewn;
            let sewn = asked && pieces[at].outline.is_sewn_on(&Loop::new(chain.clone()));
            pieces[at].adopt(chain.clone(), if sewn { Inner::Sew } else { Inner::Line });
        }
        self.assign_cut_lines(pieces, findings);
    }

    /// Lines on the outline layers that are not outlines: cut lines about a seam, else left out with a warning.
    fn assign_cut_lines(&self, pieces: &mut [Piece], findings: &mut Findings) {
        let closed_cut = self.boundary.iter().filter(|c| c.closed && self.seam_first);
        let open = self
            .boundary
            .iter()
            .chain(&self.general)
            .filter(|c| !c.closed && c.points.len() > 1);
        for (i, chain) in closed_cut.chain(open).enumerate() {
            let is_free =
                |piece: &Piece| piece.cut.is_none() && piece.outline.chain.line != chain.line;
            let found = (i < COMPARED)
                .then(|| {
                    pieces
                        .iter()
                        .position(|p| is_free(p) && p.outline.is_cut_along(chain))
                })
                .flatten();
            match found {
                Some(at) => pieces[at].cut = Some(chain.clone()),
                None if !chain.closed => findings.warn(
                    "pattern/open_line",
                    chain.line,
                    "an open line on an outline layer belongs to no piece and is left out",
                ),
                None => {}
            }
        }
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

/// Gives points and straight lines with a meaning to the pieces they lie in.
fn assign_marks(sheet: &Sheet, mirror: &[Chain], pieces: &mut [Piece], alone: bool) {
    let ends = |points: &[P]| Some([*points.first()?, *points.last()?]);
    for line in mirror.iter().filter_map(|chain| ends(&chain.points)) {
        if let Some(at) = owner(pieces, line[0], alone) {
            pieces[at].marks.folds.push(line);
        }
    }
    for entity in &sheet.entities {
        let role = role(&entity.layer);
        let line = match &entity.shape {
            Shape::Point(p) => Some([*p, *p]),
            Shape::Path(path) => ends(&path.points),
            _ => None,
        };
        let is_point = matches!(entity.shape, Shape::Point(_));
        if !matches!(
            role,
            Role::Turn | Role::Notch(_) | Role::Drill | Role::Grain
        ) {
            continue;
        }
        let Some((line, at)) = line.and_then(|line| Some((line, owner(pieces, line[0], alone)?)))
        else {
            continue;
        };
        let marks = &mut pieces[at].marks;
        match role {
            Role::Turn if is_point => marks.turns.push(line[0]),
            Role::Notch(kind) => marks.notches.push((line[0], kind)),
            Role::Drill => marks.drills.push(line[0]),
            Role::Grain if !is_point => marks.grains.push(line),
            _ => {}
        }
    }
}
