//! Texts, notches, drill holes, grain and fold lines: each given to the piece that it lies in.

use super::chain::PathChain;
use super::dxf_piece::{DxfPiece, NotchMark, outlines, owner};
use super::join::join_paths;
use super::measured::MeasuredChain;
use crate::pattern::Point2;
use crate::pattern::dxf::drawing::labels;
use crate::pattern::dxf::drawing::layers::{LayerRole, role};
use crate::pattern::dxf::drawing::sheet::DxfSheet;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityPath, EntityShape};
use crate::pattern::dxf::findings::DxfFindings;

/// Returns the texts of each outline: all of a sheet with one piece alone; else those in it, and
/// those in its box that are in no outline. Other texts are counted as left out, unless they are
/// labels, which may be of the whole file.
pub(super) fn texts<'a>(
    sheet: &'a DxfSheet,
    outer: &[MeasuredChain],
    is_alone: bool,
    findings: &mut DxfFindings,
) -> Vec<Vec<&'a DxfEntity>> {
    let mut own: Vec<Vec<&DxfEntity>> = vec![Vec::new(); outer.len()];
    for entity in &sheet.entities {
        let EntityShape::Text(at, text) = &entity.shape else {
            continue;
        };
        match owner(outer.iter(), *at, is_alone) {
            Some(index) => own[index].push(entity),
            None if labels::is_label(text) || text.trim().is_empty() => {}
            None => findings.skip("TEXT beside the pieces", entity.line),
        }
    }
    own
}

/// Gives points and lines with a meaning to the pieces that they lie in.
pub(super) fn assign(
    sheet: &DxfSheet,
    mirror: &[PathChain],
    pieces: &mut [DxfPiece],
    is_alone: bool,
    findings: &mut DxfFindings,
) {
    let mut assigner = MarkAssigner {
        pieces,
        is_alone,
        findings,
    };
    for chain in mirror {
        assigner.give_fold_line(chain);
    }
    for mark in notch_marks(sheet) {
        assigner.give_notch(mark);
    }
    for entity in &sheet.entities {
        assigner.give_mark(entity);
    }
}

/// The pieces of a sheet as marks are given to them.
struct MarkAssigner<'a> {
    pieces: &'a mut [DxfPiece],
    /// True if the sheet holds one piece.
    is_alone: bool,
    findings: &'a mut DxfFindings,
}

impl MarkAssigner<'_> {
    fn owner(&self, place: Point2) -> Option<usize> {
        owner(outlines(self.pieces), place, self.is_alone)
    }

    fn give_fold_line(&mut self, chain: &PathChain) {
        let Some(line) = ends(&chain.points) else {
            return;
        };
        match self.owner(line[0]) {
            Some(piece) => self.pieces[piece].marks.folds.push(line),
            None => {
                let kind = "fold line outside the pieces";
                self.findings.skip_many(kind, chain.line, chain.path_count);
            }
        }
    }

    fn give_notch(&mut self, mark: NotchMark) {
        match mark.points.first().and_then(|p| self.owner(*p)) {
            Some(piece) => self.pieces[piece].marks.notches.push(mark),
            None => self.findings.skip("notch outside the pieces", mark.line),
        }
    }

    /// Gives a turn point, drill hole or grain line to its piece.
    fn give_mark(&mut self, entity: &DxfEntity) {
        let role = role(&entity.layer);
        let name = match role {
            LayerRole::Turn => "turn point",
            LayerRole::Drill => "drill hole",
            LayerRole::Grain => "grain line",
            _ => return,
        };
        let Some(place) = place(&entity.shape) else {
            return;
        };
        let Some(piece) = self.owner(place) else {
            let kind = format!("{name} outside the pieces");
            self.findings.skip(&kind, entity.line);
            return;
        };
        let marks = &mut self.pieces[piece].marks;
        match (role, &entity.shape) {
            (LayerRole::Turn, EntityShape::Point(p, _)) => marks.turns.push(*p),
            (LayerRole::Drill, _) => marks.drills.push(place),
            (LayerRole::Grain, EntityShape::Path(path)) => marks.grains.extend(ends(&path.points)),
            _ => {
                let kind = format!("{name} that is drawn as something else");
                self.findings.skip(&kind, entity.line);
            }
        }
    }
}

/// Returns the notches of a sheet: points, and lines joined to the shape that they draw. All drawn
/// notches are taken to be of the kind of the first.
fn notch_marks(sheet: &DxfSheet) -> Vec<NotchMark> {
    let mut marks: Vec<NotchMark> = Vec::new();
    let mut drawn: Vec<(&EntityPath, usize)> = Vec::new();
    let mut drawn_kind = None;
    for entity in &sheet.entities {
        let LayerRole::Notch(kind) = role(&entity.layer) else {
            continue;
        };
        match &entity.shape {
            EntityShape::Point(p, z) => marks.push(NotchMark {
                points: vec![*p],
                kind,
                depth: Some(z.abs()).filter(|depth| *depth > 0.0),
                line: entity.line,
            }),
            EntityShape::Path(path) => {
                drawn_kind.get_or_insert(kind);
                drawn.push((path, entity.line));
            }
            _ => {}
        }
    }
    if let Some(kind) = drawn_kind {
        let chains = join_paths(&drawn, false).into_iter();
        marks.extend(chains.map(|chain| NotchMark {
            points: chain.points,
            kind,
            depth: None,
            line: chain.line,
        }));
    }
    marks
}

fn ends(points: &[Point2]) -> Option<[Point2; 2]> {
    Some([*points.first()?, *points.last()?])
}

/// Returns the place of a mark: a point, or the middle of what is drawn.
fn place(shape: &EntityShape) -> Option<Point2> {
    match shape {
        EntityShape::Point(p, _) => Some(*p),
        EntityShape::Path(path) if !path.points.is_empty() => {
            let count = path.points.len() as f64;
            let sum = |k: usize| path.points.iter().map(|p| p[k]).sum::<f64>();
            Some([sum(0) / count, sum(1) / count])
        }
        _ => None,
    }
}
