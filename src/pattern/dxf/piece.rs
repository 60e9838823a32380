//! Sheets to pieces: what is an outline, and which marks and lines belong to it.

use super::chain::{Chain, chains};
use super::entity::{Entity, P, Path, Shape};
use super::expand::Sheet;
use super::label::Labels;
use super::layer::{Role, role};
use super::nest::{self, Inner};
use super::{Findings, at_line};
use crate::fault::Fault;
use crate::pattern::NotchKind;
use crate::pattern::outline::{bounds, contains, nearest, segments};

/// A piece as drawn, in metres.
pub(super) struct Piece {
    /// What it is called.
    pub(super) name: String,
    /// The line it begins at.
    pub(super) line: usize,
    /// Its texts.
    pub(super) labels: Labels,
    /// The outline as drawn.
    pub(super) outline: Chain,
    /// The sew line inside it, closed, or open along the fold.
    pub(super) sew: Option<Chain>,
    /// An open cut line about it.
    pub(super) cut: Option<Chain>,
    /// Holes.
    pub(super) cutouts: Vec<Chain>,
    /// Lines drawn on the cloth.
    pub(super) internal: Vec<Chain>,
    /// Points and straight lines with a meaning.
    pub(super) marks: Marks,
}

/// Points and straight lines with a meaning.
#[derive(Default)]
pub(super) struct Marks {
    /// Where the outline has corners.
    pub(super) turns: Vec<P>,
    /// Notches.
    pub(super) notches: Vec<(P, NotchKind)>,
    /// Drill holes.
    pub(super) drills: Vec<P>,
    /// Fold lines.
    pub(super) folds: Vec<[P; 2]>,
    /// Grain lines.
    pub(super) grains: Vec<[P; 2]>,
}

/// The pieces of a sheet; faults name outlines that do not close.
pub(super) fn pieces(sheet: &Sheet, panel_limit: usize, findings: &mut Findings) -> Vec<Piece> {
    let lines = Lines::of(sheet);
    let Some(mut outlines) = lines.outlines(sheet, findings) else {
        return Vec::new();
    };
    if outlines.len() > 4 * panel_limit {
        findings
            .faults
            .push(nest::too_many(outlines.len(), panel_limit, sheet.line));
        return Vec::new();
    }
    nest::drop_duplicates(&mut outlines, findings);
    let (outer, inner) = nest::nest(outlines);
    let alone = outer.len() == 1 && sheet.block.is_some();
    let mut pieces: Vec<Piece> = outer
        .into_iter()
        .map(|outline| Piece::new(sheet, outline, alone))
        .collect();
    for (owner, chain, kind) in inner {
        pieces[owner].adopt(chain, kind);
    }
    lines.assign(&mut pieces, alone, findings);
    assign_marks(sheet, &mut pieces, alone);
    pieces
}

/// The chains of a sheet by role.
struct Lines {
    boundary: Vec<Chain>,
    sew: Vec<Chain>,
    internal: Vec<Chain>,
    cutout: Vec<Chain>,
    general: Vec<Chain>,
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
            general: of(Role::General),
        }
    }

    /// Takes the outlines out: closed chains on the boundary layer, with sew lines that lie in none of them; where
    /// there are neither, closed chains on layers without a meaning. `None` where the sheet has nothing closed.
    fn outlines(&self, sheet: &Sheet, findings: &mut Findings) -> Option<Vec<Chain>> {
        let closed = |chains: &[Chain]| {
            chains
                .iter()
                .filter(|c| c.closed)
                .cloned()
                .collect::<Vec<_>>()
        };
        let mut found = closed(&self.boundary);
        for sew in closed(&self.sew) {
            if !found.iter().any(|outline| nest::lies_in(&sew, outline)) {
                found.push(sew);
            }
        }
        if found.is_empty() {
            found = closed(&self.general);
        }
        if found.is_empty() || sheet.block.is_some() && closed(&self.boundary).is_empty() {
            let mut open = self
                .boundary
                .iter()
                .chain(&self.general)
                .filter(|c| !c.closed)
                .peekable();
            if open.peek().is_none() && found.is_empty() {
                return None;
            }
            for chain in open {
                findings.faults.push(open_outline(sheet, chain));
            }
        }
        Some(found)
    }

    /// Gives every chain that is not an outline to the piece it lies in.
    fn assign(&self, pieces: &mut [Piece], alone: bool, findings: &mut Findings) {
        for (chain, kind) in self
            .sew
            .iter()
            .map(|c| (c, Inner::Sew))
            .chain(self.cutout.iter().map(|c| (c, Inner::Hole)))
        {
            let already = pieces.iter().any(|p| p.outline.line == chain.line);
            if let (false, Some(owner)) = (already, owner(pieces, &chain.points, alone)) {
                pieces[owner].adopt(chain.clone(), kind);
            }
        }
        for chain in &self.internal {
            if let Some(owner) = owner(pieces, &chain.points, alone) {
                let kind = if pieces[owner].sew.is_none() {
                    nest::kind(&pieces[owner].outline, chain)
                } else {
                    Inner::Line
                };
                pieces[owner].adopt(
                    chain.clone(),
                    if kind == Inner::Sew {
                        kind
                    } else {
                        Inner::Line
                    },
                );
            }
        }
        for chain in self
            .boundary
            .iter()
            .chain(&self.general)
            .filter(|c| !c.closed)
        {
            match nest::about(pieces, chain) {
                Some(owner) if pieces[owner].cut.is_none() => {
                    pieces[owner].cut = Some(chain.clone())
                }
                _ if chain.points.len() > 1 => {
                    findings.warn(
                        "pattern/open_line",
                        chain.line,
                        "an open line on the outline layer belongs to no piece and is left out",
                    );
                }
                _ => {}
            }
        }
    }
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

impl Piece {
    fn new(sheet: &Sheet, outline: Chain, alone: bool) -> Self {
        let own: Vec<&Entity> = sheet
            .entities
            .iter()
            .filter(|e| {
                alone || matches!(&e.shape, Shape::Text(at, _) if contains(&outline.points, *at))
            })
            .collect();
        let labels = Labels::of(own.iter().copied());
        let free_text = || {
            own.iter().find_map(|e| match &e.shape {
                Shape::Text(_, text) if !text.contains(':') && !text.trim().is_empty() => {
                    Some(text.trim().to_owned())
                }
                _ => None,
            })
        };
        let name = labels
            .get("piece name")
            .map(str::to_owned)
            .or_else(|| sheet.block.clone())
            .or_else(free_text);
        Self {
            name: name.unwrap_or_else(|| "panel".to_owned()),
            line: if alone { sheet.line } else { outline.line },
            labels,
            outline,
            sew: None,
            cut: None,
            cutouts: Vec::new(),
            internal: Vec::new(),
            marks: Marks::default(),
        }
    }

    fn adopt(&mut self, chain: Chain, kind: Inner) {
        match kind {
            Inner::Sew if self.sew.is_none() => self.sew = Some(chain),
            Inner::Hole if chain.closed => self.cutouts.push(chain),
            _ => self.internal.push(chain),
        }
    }
}

/// Which piece the points lie in: the only one, the first that contains their middle point, or none.
fn owner(pieces: &[Piece], points: &[P], alone: bool) -> Option<usize> {
    if alone {
        return (!pieces.is_empty()).then_some(0);
    }
    let at = *points.get(points.len() / 2)?;
    pieces
        .iter()
        .position(|p| in_box(&p.outline.points, at, 0.0) && contains(&p.outline.points, at))
        .or_else(|| {
            /// A mark this far outside an outline is still on it \[m\].
            const BESIDE: f64 = 0.002;
            pieces.iter().position(|p| {
                in_box(&p.outline.points, at, BESIDE)
                    && nearest(segments(&p.outline.points), at)
                        .is_some_and(|n| n.distance <= BESIDE)
            })
        })
}

fn in_box(ring: &[P], p: P, margin: f64) -> bool {
    let [low, high] = bounds(ring);
    (0..2).all(|k| low[k] - margin <= p[k] && p[k] <= high[k] + margin)
}

/// Gives points and straight lines with a meaning to the pieces they lie in.
fn assign_marks(sheet: &Sheet, pieces: &mut [Piece], alone: bool) {
    for entity in &sheet.entities {
        let role = role(&entity.layer);
        let points = match &entity.shape {
            Shape::Point(p) => std::slice::from_ref(p),
            Shape::Path(path) => &path.points[..],
            _ => continue,
        };
        if !matches!(
            role,
            Role::Turn | Role::Notch(_) | Role::Drill | Role::Mirror | Role::Grain
        ) {
            continue;
        }
        let Some(owner) = owner(pieces, points, alone) else {
            continue;
        };
        let marks = &mut pieces[owner].marks;
        let (Some(&a), Some(&b)) = (points.first(), points.last()) else {
            continue;
        };
        match (role, points.len()) {
            (Role::Turn, 1) => marks.turns.push(a),
            (Role::Notch(kind), _) => marks.notches.push((a, kind)),
            (Role::Drill, _) => marks.drills.push(a),
            (Role::Mirror, 2..) => marks.folds.push([a, b]),
            (Role::Grain, 2..) => marks.grains.push([a, b]),
            _ => {}
        }
    }
}
