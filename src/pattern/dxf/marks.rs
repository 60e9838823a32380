//! Texts, notches, drill holes, grain and fold lines: each given to the piece that it lies in.

use super::Findings;
use super::chain::{Chain, chains};
use super::entity::{Entity, Path, Shape};
use super::expand::Sheet;
use super::label;
use super::layer::{Role, role};
use super::nest::Loop;
use super::piece::{NotchMark, Piece, outlines, owner};
use crate::pattern::Point2;

/// The texts of each outline: all of a sheet with one piece alone; else those in it, and those in its box that are in
/// no outline. Other texts are counted as left out, unless they are labels, which may be of the whole file.
pub(super) fn texts<'a>(
    sheet: &'a Sheet,
    outer: &[Loop],
    alone: bool,
    findings: &mut Findings,
) -> Vec<Vec<&'a Entity>> {
    let mut own: Vec<Vec<&Entity>> = vec![Vec::new(); outer.len()];
    for entity in &sheet.entities {
        let Shape::Text(at, text) = &entity.shape else {
            continue;
        };
        match owner(outer.iter(), *at, alone) {
            Some(index) => own[index].push(entity),
            None if label::is_label(text) || text.trim().is_empty() => {}
            None => findings.left_out("TEXT beside the pieces", entity.line),
        }
    }
    own
}

/// Gives points and lines with a meaning to the pieces they lie in.
pub(super) fn assign(
    sheet: &Sheet,
    mirror: &[Chain],
    pieces: &mut [Piece],
    alone: bool,
    findings: &mut Findings,
) {
    for chain in mirror {
        let Some(line) = ends(&chain.points) else {
            continue;
        };
        match owner(outlines(pieces), line[0], alone) {
            Some(at) => pieces[at].marks.folds.push(line),
            None => findings.left_out_many("fold line outside the pieces", chain.line, chain.runs),
        }
    }
    notches(sheet, pieces, alone, findings);
    for entity in &sheet.entities {
        let role = role(&entity.layer);
        let name = match role {
            Role::Turn => "turn point",
            Role::Drill => "drill hole",
            Role::Grain => "grain line",
            _ => continue,
        };
        let Some(place) = place(&entity.shape) else {
            continue;
        };
        let Some(at) = owner(outlines(pieces), place, alone) else {
            findings.left_out(&format!("{name} outside the pieces"), entity.line);
            continue;
        };
        let marks = &mut pieces[at].marks;
        match (role, &entity.shape) {
            (Role::Turn, Shape::Point(p, _)) => marks.turns.push(*p),
            (Role::Drill, _) => marks.drills.push(place),
            (Role::Grain, Shape::Path(path)) => marks.grains.extend(ends(&path.points)),
            _ => findings.left_out(
                &format!("{name} that is drawn as something else"),
                entity.line,
            ),
        }
    }
}

/// Notches: points, and lines joined to the shape that they draw.
fn notches(sheet: &Sheet, pieces: &mut [Piece], alone: bool, findings: &mut Findings) {
    let mut marks: Vec<NotchMark> = Vec::new();
    let mut drawn: Vec<(&Path, usize)> = Vec::new();
    let mut line_kind = None;
    for entity in &sheet.entities {
        let Role::Notch(kind) = role(&entity.layer) else {
            continue;
        };
        match &entity.shape {
            Shape::Point(p, z) => marks.push(NotchMark {
                points: vec![*p],
                kind,
                depth: Some(z.abs()).filter(|depth| *depth > 0.0),
                line: entity.line,
            }),
            Shape::Path(path) => {
                line_kind.get_or_insert(kind);
                drawn.push((path, entity.line));
            }
            _ => {}
        }
    }
    if let Some(kind) = line_kind {
        marks.extend(chains(&drawn, false).into_iter().map(|chain| NotchMark {
            points: chain.points,
            kind,
            depth: None,
            line: chain.line,
        }));
    }
    for mark in marks {
        match mark
            .points
            .first()
            .and_then(|p| owner(outlines(pieces), *p, alone))
        {
            Some(at) => pieces[at].marks.notches.push(mark),
            None => findings.left_out("notch outside the pieces", mark.line),
        }
    }
}

fn ends(points: &[Point2]) -> Option<[Point2; 2]> {
    Some([*points.first()?, *points.last()?])
}

/// Where a mark is: a point, or the middle of what is drawn.
fn place(shape: &Shape) -> Option<Point2> {
    match shape {
        Shape::Point(p, _) => Some(*p),
        Shape::Path(path) if !path.points.is_empty() => {
            let count = path.points.len() as f64;
            let sum = |k: usize| path.points.iter().map(|p| p[k]).sum::<f64>();
            Some([sum(0) / count, sum(1) / count])
        }
        _ => None,
    }
}
