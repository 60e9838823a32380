//! Pieces graded to another size by the rules of their points.

use super::chain::PathChain;
use super::dxf_piece::DxfPiece;
use super::measured::MeasuredChain;
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::GradeTable;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use crate::pattern::point::{Point2, distance, lerp};
use crate::pattern::polyline::{nearest, segments};
use std::collections::BTreeMap;

/// A rule belongs to the nearest point of a line that lies this near to it \[m\].
const AT: f64 = 1e-4;

/// Moves the points of pieces to where they lie in a size of a table. A piece without rules stays
/// as it is, and rules that lie on no point move nothing: both are warned about.
///
/// A point with a rule moves by it; those between two such points of a line move by shares of
/// both, by their distances along it. Lines without rules, and marks, move with the outline beside
/// them; holes and closed lines inside as a whole.
///
/// # Errors
/// Rules that the table does not have, and lines of more points than a panel may have.
pub(crate) fn to_size(
    pieces: &mut [DxfPiece],
    table: &GradeTable,
    size: usize,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<(), Fault> {
    for piece in pieces {
        check_size(piece, limits)?;
        let rules = displacements(piece, table, size, findings)?;
        let field = DisplacementField::new(rules, &piece.outline.chain);
        match field {
            Some(field) => grade(piece, &field),
            None => {
                let detail = format!(
                    "no point of the outline of {:?} has a rule of the table; it is the same in all sizes",
                    piece.name
                );
                findings.warn(PatternCode::Ungraded, piece.line, detail);
            }
        }
    }
    Ok(())
}

fn check_size(piece: &DxfPiece, limits: &Limits) -> Result<(), Fault> {
    let count = piece.points().count();
    let most = limits.panel_vertices;
    if count <= most {
        return Ok(());
    }
    let detail = format!(
        "the lines of the piece {:?} have {count} points; pieces of at most {most} are graded",
        piece.name
    );
    let fault = Fault::new(PatternCode::TooLarge, at_line(piece.line), detail);
    Err(fault.fix("export curves with fewer points"))
}

/// Returns the places with a rule that lie on points of lines, and how far each is displaced: rules
/// are in the directions of the drawing that was put in.
fn displacements(
    piece: &DxfPiece,
    table: &GradeTable,
    size: usize,
    findings: &mut DxfFindings,
) -> Result<Vec<(Point2, Point2)>, Fault> {
    let places = CellPoints::new(piece.points());
    let (mut found, mut astray) = (vec![], vec![]);
    for (place, rule) in &piece.marks.rules {
        let Some(point) = places.nearest(*place) else {
            astray.push(*place);
            continue;
        };
        let Some(delta) = table.delta(*rule, size) else {
            let detail = format!(
                "the piece {:?} names the rule {rule} at ({:.4}, {:.4}) m, which the grade rule table does not have",
                piece.name, place[0], place[1]
            );
            let fault = Fault::new(PatternCode::GradeRule, at_line(piece.line), detail);
            return Err(fault.fix("give the table that was exported with the file"));
        };
        found.push((point, piece.linear.apply(delta)));
    }
    if let Some([x, y]) = astray.first() {
        let detail = format!(
            "{} rules of {:?} lie on no point of it, the first at ({x:.4}, {y:.4}) m, and move nothing",
            astray.len(),
            piece.name
        );
        findings.warn(PatternCode::Ungraded, piece.line, detail);
    }
    Ok(found)
}

/// Points by the cell of a grid that they lie in.
struct CellPoints(BTreeMap<(i64, i64), Vec<Point2>>);

impl CellPoints {
    fn new(points: impl Iterator<Item = Point2>) -> Self {
        let mut cells: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for point in points {
            cells.entry(cell(point)).or_default().push(point);
        }
        Self(cells)
    }

    /// Returns the nearest point within reach.
    fn nearest(&self, p: Point2) -> Option<Point2> {
        let (x, y) = cell(p);
        let cells = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
        let points = cells.filter_map(|cell| self.0.get(&cell)).flatten();
        let near = points.filter(|point| distance(**point, p) <= AT);
        near.min_by(|a, b| distance(**a, p).total_cmp(&distance(**b, p)))
            .copied()
    }
}

/// How far the points of a piece are displaced.
struct DisplacementField {
    /// Points with a rule, by their coordinates.
    ruled: BTreeMap<[u64; 2], Point2>,
    outline: Vec<Point2>,
    /// Of each point of the outline.
    of_outline: Vec<Point2>,
}

impl DisplacementField {
    /// Returns the field of some rules; `None` where none lies on the outline.
    fn new(rules: Vec<(Point2, Point2)>, outline: &PathChain) -> Option<Self> {
        let mut field = Self {
            ruled: BTreeMap::new(),
            outline: outline.points.clone(),
            of_outline: vec![[0.0; 2]; outline.points.len()],
        };
        for (place, delta) in rules {
            field.ruled.entry(key(place)).or_insert(delta);
        }
        let ruled = outline
            .points
            .iter()
            .any(|p| field.ruled.contains_key(&key(*p)));
        field.of_outline = field.along(outline);
        ruled.then_some(field)
    }

    /// Returns the displacement of a point beside the outline.
    fn beside(&self, p: Point2) -> Point2 {
        let Some(foot) = nearest(segments(&self.outline), p) else {
            return [0.0; 2];
        };
        let next = (foot.segment + 1) % self.outline.len();
        lerp(
            self.of_outline[foot.segment],
            self.of_outline[next],
            foot.at,
        )
    }

    /// Returns the displacement of a mark.
    fn at(&self, p: Point2) -> Point2 {
        let ruled = self.ruled.get(&key(p)).copied();
        ruled.unwrap_or_else(|| self.beside(p))
    }

    /// Returns the displacements of the points of a line: by the rules on it, and between two of
    /// them by shares of both; where it has no two, with the outline beside it.
    fn along(&self, chain: &PathChain) -> Vec<Point2> {
        let points = &chain.points;
        let n = points.len();
        let ruled: Vec<usize> = (0..n)
            .filter(|i| self.ruled.contains_key(&key(points[*i])))
            .collect();
        let mut displaced: Vec<Point2> = points.iter().map(|p| self.at(*p)).collect();
        let last = if chain.closed && ruled.len() > 1 {
            ruled.len()
        } else {
            ruled.len().saturating_sub(1)
        };
        for k in 0..last {
            let from = ruled[k];
            let to = if k + 1 < ruled.len() {
                ruled[k + 1]
            } else {
                ruled[0] + n
            };
            let ends = [displaced[from], displaced[to % n]];
            let step = |i: usize| distance(points[i % n], points[(i + 1) % n]);
            let whole: f64 = (from..to).map(step).sum();
            let mut way = 0.0;
            for i in from + 1..to {
                way += step(i - 1);
                displaced[i % n] = lerp(ends[0], ends[1], way / whole.max(f64::MIN_POSITIVE));
            }
        }
        displaced
    }

    fn displace_line(&self, chain: &mut PathChain) {
        let displaced = self.along(chain);
        for (point, by) in chain.points.iter_mut().zip(displaced) {
            *point = sum(*point, by);
        }
    }

    /// Displaces what lies inside: a closed line without rules as a whole.
    fn displace_inner(&self, chain: &mut PathChain) {
        let is_ruled = chain
            .points
            .iter()
            .any(|p| self.ruled.contains_key(&key(*p)));
        if is_ruled || !chain.closed {
            return self.displace_line(chain);
        }
        let count = chain.points.len().max(1) as f64;
        let middle = chain
            .points
            .iter()
            .fold([0.0; 2], |a, p| sum(a, p.map(|c| c / count)));
        let by = self.beside(middle);
        for point in &mut chain.points {
            *point = sum(*point, by);
        }
    }
}

fn grade(piece: &mut DxfPiece, field: &DisplacementField) {
    let mut outline = piece.outline.chain.clone();
    field.displace_line(&mut outline);
    piece.outline = MeasuredChain::new(outline);
    let beside = [&mut piece.sew, &mut piece.cut].into_iter().flatten();
    beside.for_each(|chain| field.displace_line(chain));
    let inner = piece.cutouts.iter_mut().chain(&mut piece.internal);
    inner.for_each(|chain| field.displace_inner(chain));
    let marks = &mut piece.marks;
    let notches = marks.notches.iter_mut().flat_map(|notch| &mut notch.points);
    let points = notches.chain(&mut marks.turns).chain(&mut marks.drills);
    let ends = marks.folds.iter_mut().chain(&mut marks.grains).flatten();
    points
        .chain(ends)
        .for_each(|point| *point = sum(*point, field.at(*point)));
}

fn sum(a: Point2, b: Point2) -> Point2 {
    [a[0] + b[0], a[1] + b[1]]
}

/// Returns a point as a key of equal ones.
fn key(p: Point2) -> [u64; 2] {
    // To add 0 makes 0 of -0.
    p.map(|c| (c + 0.0).to_bits())
}

/// Returns the cell of a grid that a point lies in.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a saturated cell only holds more points"
)]
fn cell(p: Point2) -> (i64, i64) {
    let index = |c: f64| ((c / AT).floor()).clamp(-1e15, 1e15) as i64;
    (index(p[0]), index(p[1]))
}
