//! Pieces graded to another size by the rules of their points.

use super::chain::PathChain;
use super::dxf_piece::DxfPiece;
use super::measured::MeasuredChain;
use crate::fault::{Fault, PatternCode};
use crate::pattern::GradeTable;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use crate::pattern::point::{Point2, distance, lerp};
use crate::pattern::polyline::{nearest, segments};
use std::collections::BTreeMap;

/// The way of a point from its place in the sample size \[m\].
type Delta = Point2;

/// A rule belongs to the points of lines that lie this near to it \[m\].
const AT: f64 = 1e-5;

/// Moves the points of pieces to where they lie in a size of a table; a piece without rules stays
/// as it is, which is warned about.
///
/// A point with a rule moves by it; those between two such points of a line move by shares of
/// both, by their distances along it. Lines without rules, and marks, move with the outline beside
/// them.
///
/// # Errors
/// Rules that the table does not have.
pub(crate) fn to_size(
    pieces: &mut [DxfPiece],
    table: &GradeTable,
    size: usize,
    findings: &mut DxfFindings,
) -> Result<(), Fault> {
    for piece in pieces {
        let moves = moves(piece, table, size)?;
        if moves.is_empty() {
            let detail = format!(
                "no point of {:?} has a rule of the table; it is the same in all sizes",
                piece.name
            );
            findings.warn(PatternCode::Ungraded, piece.line, detail);
        } else {
            grade(piece, &Moves::new(moves, &piece.outline.chain));
        }
    }
    Ok(())
}

/// Returns the places with a rule, and how far each moves: rules are in the directions of the
/// drawing that was put in.
fn moves(piece: &DxfPiece, table: &GradeTable, size: usize) -> Result<Vec<(Point2, Delta)>, Fault> {
    let delta = |(place, rule): &(Point2, u32)| match table.delta(*rule, size) {
        Some(delta) => Ok((*place, piece.turn.apply(delta))),
        None => {
            let detail = format!(
                "the piece {:?} names the rule {rule} at ({:.4}, {:.4}) m, which the grade rule table does not have",
                piece.name, place[0], place[1]
            );
            let fault = Fault::new(PatternCode::GradeRule, at_line(piece.line), detail);
            Err(fault.fix("give the table that was exported with the file"))
        }
    };
    piece.marks.rules.iter().map(delta).collect()
}

/// The rules of a piece by place, and its outline before and after.
struct Moves {
    by_cell: BTreeMap<(i64, i64), Vec<(Point2, Delta)>>,
    outline: Vec<Point2>,
    outline_moves: Vec<Delta>,
}

impl Moves {
    fn new(moves: Vec<(Point2, Delta)>, outline: &PathChain) -> Self {
        let mut by_cell: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for (place, delta) in moves {
            by_cell.entry(cell(place)).or_default().push((place, delta));
        }
        let mut found = Self {
            by_cell,
            outline: outline.points.clone(),
            outline_moves: vec![],
        };
        found.outline_moves = found
            .along(&outline.points, true)
            .unwrap_or_else(|| vec![[0.0; 2]; outline.points.len()]);
        found
    }

    /// Returns the way of a point that has a rule.
    fn at(&self, p: Point2) -> Option<Delta> {
        let (x, y) = cell(p);
        let near = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
        let mut rules = near.filter_map(|cell| self.by_cell.get(&cell)).flatten();
        let found = rules.find(|(place, _)| distance(*place, p) <= AT);
        found.map(|(_, delta)| *delta)
    }

    /// Returns the way of a point beside the outline.
    fn beside(&self, p: Point2) -> Delta {
        let Some(foot) = nearest(segments(&self.outline), p) else {
            return [0.0; 2];
        };
        let next = (foot.segment + 1) % self.outline.len();
        lerp(
            self.outline_moves[foot.segment],
            self.outline_moves[next],
            foot.at,
        )
    }

    /// Returns the ways of the points of a line by the rules on it; `None` if there are none.
    fn along(&self, points: &[Point2], closed: bool) -> Option<Vec<Delta>> {
        let n = points.len();
        let ruled: Vec<(usize, Delta)> = (0..n)
            .filter_map(|i| Some((i, self.at(points[i])?)))
            .collect();
        let (first, last) = (*ruled.first()?, *ruled.last()?);
        let mut ways = vec![[0.0; 2]; n];
        for (k, (from, start)) in ruled.iter().enumerate() {
            let (to, end) = ruled.get(k + 1).copied().unwrap_or((first.0 + n, first.1));
            if to >= n && !closed {
                break;
            }
            let steps = (*from..to).map(|i| distance(points[i % n], points[(i + 1) % n]));
            let whole: f64 = steps.clone().sum();
            let mut way = 0.0;
            for (i, step) in (*from..to).zip(steps) {
                let share = if whole > 0.0 { way / whole } else { 0.0 };
                ways[i % n] = lerp(*start, end, share);
                way += step;
            }
        }
        if !closed {
            ways[..first.0].fill(first.1);
            ways[last.0..].fill(last.1);
        }
        Some(ways)
    }

    fn move_chain(&self, chain: &mut PathChain) {
        let ways = self.along(&chain.points, chain.closed);
        for (i, point) in chain.points.iter_mut().enumerate() {
            let way = ways.as_ref().map_or_else(|| self.beside(*point), |w| w[i]);
            *point = moved(*point, way);
        }
    }

    fn move_mark(&self, point: &mut Point2) {
        let way = self.at(*point).unwrap_or_else(|| self.beside(*point));
        *point = moved(*point, way);
    }
}

fn grade(piece: &mut DxfPiece, moves: &Moves) {
    let mut outline = piece.outline.chain.clone();
    moves.move_chain(&mut outline);
    piece.outline = MeasuredChain::new(outline);
    let lines = [&mut piece.sew, &mut piece.cut].into_iter().flatten();
    let lines = lines.chain(&mut piece.cutouts).chain(&mut piece.internal);
    lines.for_each(|chain| moves.move_chain(chain));
    let marks = &mut piece.marks;
    let notches = marks.notches.iter_mut().flat_map(|notch| &mut notch.points);
    let points = notches.chain(&mut marks.turns).chain(&mut marks.drills);
    let ends = marks.folds.iter_mut().chain(&mut marks.grains).flatten();
    points.chain(ends).for_each(|point| moves.move_mark(point));
}

fn moved(p: Point2, way: Delta) -> Point2 {
    [p[0] + way[0], p[1] + way[1]]
}

/// Returns the cell of a grid that a point lies in.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a saturated cell only holds more rules"
)]
fn cell(p: Point2) -> (i64, i64) {
    let index = |c: f64| ((c / AT).floor()).clamp(-1e15, 1e15) as i64;
    (index(p[0]), index(p[1]))
}
