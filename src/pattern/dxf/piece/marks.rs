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
use crate::pattern::point::{distance, lerp};
use crate::pattern::polyline::nearest;

/// At most this many fold lines of a piece are read.
const MOST_FOLDS: usize = 16;

/// Points this near to a line lie on it \[m\].
const ON: f64 = 2e-4;

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
        assigner.give_fold_lines(chain);
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

    /// Gives a line on the layer of folds to its piece: each straight stretch of it. Of a bracket
    /// that stands beside the outline, the way from its one end to the other.
    fn give_fold_lines(&mut self, chain: &PathChain) {
        let stretches = straight_stretches(&chain.points);
        let is_bracket = !stretches.iter().all(|s| self.runs_along_outline(*s));
        let bracket = ends(&chain.points).filter(|e| is_bracket && self.runs_along_outline(*e));
        for line in bracket.map_or(stretches, |ends| vec![ends]) {
            match self.owner(line[0]) {
                Some(piece) if self.pieces[piece].marks.folds.len() < MOST_FOLDS => {
                    self.pieces[piece].marks.folds.push(line);
                }
                Some(_) => self
                    .findings
                    .skip("fold line beyond the first 16 of a piece", chain.line),
                None => {
                    let kind = "fold line outside the pieces";
                    self.findings.skip_many(kind, chain.line, chain.path_count);
                }
            }
        }
    }

    /// Returns true if a straight line lies on the outline of its piece: its ends and its middle.
    fn runs_along_outline(&self, [a, b]: [Point2; 2]) -> bool {
        let outline = self.owner(a).map(|piece| &self.pieces[piece].outline);
        let on = |p: Point2| outline.is_some_and(|outline| outline.is_beside(p, ON));
        distance(a, b) > ON && [a, lerp(a, b, 0.5), b].into_iter().all(on)
    }

    fn give_notch(&mut self, mark: NotchMark) {
        match mark.points.first().and_then(|p| self.owner(*p)) {
            Some(piece) => self.pieces[piece].marks.notches.push(mark),
            None => self.findings.skip("notch outside the pieces", mark.line),
        }
    }

    /// Gives a turn point, drill hole, grain line or grade rule to its piece.
    fn give_mark(&mut self, entity: &DxfEntity) {
        if let EntityShape::Text(place, text) = &entity.shape {
            let is_note = role(&entity.layer) == LayerRole::Annotation;
            let rule = grade_rule(text).filter(|_| !is_note);
            let piece = rule.zip(self.owner(*place));
            if let Some((rule, piece)) = piece {
                self.pieces[piece].marks.rules.push((*place, rule));
            }
            return;
        }
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
                is_drawn: false,
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
            is_drawn: false,
            depth: None,
            line: chain.line,
        }));
    }
    marks
}

/// Returns the number of a grade rule, `# 12`.
fn grade_rule(text: &str) -> Option<u32> {
    text.trim().strip_prefix('#')?.trim().parse().ok()
}

fn ends(points: &[Point2]) -> Option<[Point2; 2]> {
    Some([*points.first()?, *points.last()?])
}

/// Returns the stretches of a line that are straight, from end to end.
fn straight_stretches(points: &[Point2]) -> Vec<[Point2; 2]> {
    /// Points of a stretch that are looked at: a line of thousands costs no more than that.
    const SAMPLES: usize = 16;
    let is_straight = |from: usize, to: usize| {
        let chord = (points[from], points[to]);
        let is_near = |p: &Point2| {
            let foot = nearest(std::iter::once(chord), *p);
            foot.is_some_and(|foot| foot.distance <= ON)
        };
        let between = &points[from + 1..to];
        let step = (between.len() / SAMPLES).max(1);
        between.iter().rev().step_by(step).all(is_near)
    };
    let mut stretches = vec![];
    let mut from = 0;
    while from + 1 < points.len() {
        let mut ends = (from + 1..points.len()).take_while(|to| is_straight(from, *to));
        let to = ends.by_ref().last().unwrap_or(from + 1);
        stretches.push([points[from], points[to]]);
        from = to;
    }
    stretches
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
