//! Darts that are drawn as lines on the cloth, not cut into the outline.
//!
//! Much pattern CAD draws darts closed: the outline runs across the mouth, and the two legs are
//! inner lines that meet at the tip. A dart inside a panel is a narrow outline with two tips. To be
//! sewn, legs must be edges: the former are cut into the outline, the latter become holes.

use super::chain::{JOINED, PathChain};
use super::dxf_piece::DxfPiece;
use super::measured::MeasuredChain;
use crate::config::Limits;
use crate::fault::PatternCode;
use crate::pattern::DrawnDarts;
use crate::pattern::crossing::{crossing, meeting};
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::inside_dart::{self, agree, within};
use crate::pattern::point::{Point2, cross, distance, lerp, sub, turn};
use crate::pattern::polyline::{contains, length, nearest, segments};
use std::f64::consts::PI;

/// A line turns at a tip by at least this; at the corners of its mouth by this [rad].
const TIP_TURN: f64 = 0.75 * PI;
const CORNER_TURN: f64 = PI / 6.0;

/// A leg is so long \[m\]: shorter ones are notches, longer ones lines of style.
const LEG: [f64; 2] = [0.03, 0.4];

/// A leg keeps this near to its chord, as a share of it.
const MOST_BULGE: f64 = 0.12;

/// A mouth is so wide \[m\], and at most this share of a leg: lines that open further are yokes and
/// necklines.
const MOUTH: [f64; 2] = [0.008, 0.12];
const WIDEST: f64 = 0.5;

/// The outline across a mouth is at most this many times its width: it is peaked where it follows
/// the dart as folded.
const MOST_DETOUR: f64 = 1.5;

/// Legs end this near to the outline at least, or lead across it \[m\].
const REACH: f64 = 0.003;

/// Most lines of a piece with the shape of a dart that are looked at, and most points of one.
const MOST: usize = 40;
const MOST_POINTS: usize = 400;

/// A line with the shape of a dart.
enum DartShape {
    /// One that opens at the outline, by its legs from mouth to tip.
    Open([Vec<Point2>; 2]),
    /// One with two tips.
    Inside,
}

/// A place on an outline.
#[derive(Clone, Copy)]
struct RingPlace {
    point: Point2,
    segment: usize,
    /// Distance from the first point of the outline along it \[m\].
    along: f64,
}

/// Cuts the darts that are drawn on a piece into it; they are warned about.
pub(crate) fn cut_darts(
    piece: &mut DxfPiece,
    reading: DrawnDarts,
    limits: &Limits,
    findings: &mut DxfFindings,
) {
    // An open sew line is closed later, where the piece is unfolded.
    let is_open = piece.sew.as_ref().is_some_and(|sew| !sew.closed);
    let is_large = sewn_line(piece).points.len() > limits.panel_vertices;
    if reading == DrawnDarts::Lines || is_open || is_large {
        return;
    }
    let (mut looked_at, mut cut) = (0, 0);
    for line in std::mem::take(&mut piece.internal) {
        let shape = (looked_at < MOST).then(|| shape(&line)).flatten();
        looked_at += usize::from(shape.is_some());
        match shape {
            Some(DartShape::Open(legs)) if cut_into_outline(piece, &legs) => cut += 1,
            Some(DartShape::Inside) if has_room(piece, &line.points) => {
                piece.cutouts.push(line);
                cut += 1;
            }
            _ => piece.internal.push(line),
        }
    }
    if cut > 0 {
        let detail = format!(
            "{cut} darts that are drawn on {:?} were cut into it, to be sewn (darts=lines leaves them lines on the cloth)",
            piece.name
        );
        findings.warn(PatternCode::DrawnDarts, piece.outline.chain.line, detail);
    }
}

fn shape(line: &PathChain) -> Option<DartShape> {
    if line.points.len() > MOST_POINTS {
        return None;
    }
    let mut points = line.points.clone();
    points.dedup_by(|a, b| distance(*a, *b) <= JOINED);
    match legs(&points, line.closed) {
        Some(legs) => Some(DartShape::Open(legs)),
        None => (line.closed && inside_dart::tips(&points).is_some()).then_some(DartShape::Inside),
    }
}

/// Returns the line along which a piece is sewn.
fn sewn_line(piece: &DxfPiece) -> &PathChain {
    piece.sew.as_ref().unwrap_or(&piece.outline.chain)
}

/// Returns the legs of an open line with one tip, or of a triangle, from the mouth to the tip.
fn legs(points: &[Point2], is_closed: bool) -> Option<[Vec<Point2>; 2]> {
    let points = if is_closed {
        open_at_mouth(points)?
    } else {
        points.to_vec()
    };
    let turns = |&i: &usize| turn(points[i - 1], points[i], points[i + 1]).abs() >= TIP_TURN;
    let mut tips = (1..points.len().saturating_sub(1)).filter(turns);
    let tip = tips.next().filter(|_| tips.next().is_none())?;
    let second = points[tip..].iter().rev().copied().collect();
    Some([points[..=tip].to_vec(), second])
}

/// Returns a triangle without its shortest side.
fn open_at_mouth(points: &[Point2]) -> Option<Vec<Point2>> {
    let n = points.len();
    let at = |i: usize| points[i % n];
    let turns = |&i: &usize| turn(at(i + n - 1), at(i), at(i + 1)).abs() >= CORNER_TURN;
    let corners: Vec<usize> = (0..n).filter(turns).collect();
    let &[a, b, c] = corners.as_slice() else {
        return None;
    };
    let sides = [(a, b), (b, c), (c, a + n)];
    let short = |side: &&(usize, usize)| distance(at(side.0), at(side.1));
    let mouth = sides.iter().min_by(|s, t| short(s).total_cmp(&short(t)))?;
    Some((mouth.1..=mouth.0 + n).map(at).collect())
}

/// Returns true if a ring lies within a piece, apart from its outline and its holes.
fn has_room(piece: &DxfPiece, ring: &[Point2]) -> bool {
    let outline = &sewn_line(piece).points;
    let is_apart = |p: &Point2| {
        contains(outline, *p)
            && nearest(segments(outline), *p).is_some_and(|foot| foot.distance >= REACH)
    };
    let lies_in = |inner: &[Point2], outer: &[Point2]| contains(outer, inner[0]);
    let is_clear = |hole: &PathChain| {
        !meet(ring, &hole.points) && !lies_in(ring, &hole.points) && !lies_in(&hole.points, ring)
    };
    ring.iter().all(is_apart) && !meet(ring, outline) && piece.cutouts.iter().all(is_clear)
}

/// Returns true if two rings meet.
fn meet(a: &[Point2], b: &[Point2]) -> bool {
    segments(a).any(|(p, q)| segments(b).any(|(r, s)| meeting(p, q, r, s).is_some()))
}

/// Cuts a dart into the line along which a piece is sewn; returns false if it does not fit there.
fn cut_into_outline(piece: &mut DxfPiece, legs: &[Vec<Point2>; 2]) -> bool {
    let Some((cut, corners)) = cut_into(sewn_line(piece), legs) else {
        return false;
    };
    if piece
        .cutouts
        .iter()
        .any(|hole| meet(&corners, &hole.points))
    {
        return false;
    }
    // Turn points, where there are any, name all corners.
    if !piece.marks.turns.is_empty() {
        piece.marks.turns.extend(corners);
    }
    match &mut piece.sew {
        Some(sew) => *sew = cut,
        None => piece.outline = MeasuredChain::new(cut),
    }
    true
}

/// Returns an outline that runs along the legs of a dart, and the corners of that.
fn cut_into(outline: &PathChain, legs: &[Vec<Point2>; 2]) -> Option<(PathChain, [Point2; 3])> {
    let ring = &outline.points;
    let [first, second] = [leg_from(ring, &legs[0])?, leg_from(ring, &legs[1])?];
    let tip = *legs[0].last()?;
    if !is_dart([&first.1, &second.1]) || !contains(ring, tip) {
        return None;
    }
    let around: f64 = segments(ring).map(|(a, b)| distance(a, b)).sum();
    let ahead = (second.0.along - first.0.along).rem_euclid(around);
    let (from, to) = if 2.0 * ahead <= around {
        (&first, &second)
    } else {
        (&second, &first)
    };
    let across = ahead.min(around - ahead);
    if across > MOST_DETOUR * distance(from.0.point, to.0.point) {
        return None;
    }
    let back = to.1.iter().rev().skip(1);
    let mut points: Vec<Point2> = from.1.iter().chain(back).copied().collect();
    let new = points.len();
    let n = ring.len();
    let left = (from.0.segment + n - to.0.segment) % n;
    let left = if left == 0 { n } else { left };
    let is_apart = |k: &usize| {
        [from, to]
            .iter()
            .all(|end| distance(ring[*k], end.0.point) > JOINED)
    };
    let kept = (1..=left).map(|k| (to.0.segment + k) % n);
    let kept: Vec<usize> = kept.filter(is_apart).collect();
    points.extend(kept.iter().map(|k| ring[*k]));
    if crossing(&points).is_some() {
        return None;
    }
    let flags = |of: &[bool]| {
        let kept = kept.iter().map(|k| of[*k]);
        [false].into_iter().cycle().take(new).chain(kept).collect()
    };
    let cut = PathChain {
        path_end: flags(&outline.path_end),
        sampled: flags(&outline.sampled),
        points,
        ..outline.clone()
    };
    Some((cut, [from.0.point, tip, to.0.point]))
}

/// Returns a leg from where it meets the outline on, and that place: its first crossing on the way
/// from the tip, else the point of the outline that its end is beside.
fn leg_from(ring: &[Point2], leg: &[Point2]) -> Option<(RingPlace, Vec<Point2>)> {
    let mut inner: Vec<Point2> = vec![];
    for pair in leg.windows(2).rev() {
        inner.push(pair[1]);
        let meets = |(segment, (a, b)): (usize, (Point2, Point2))| {
            meeting(pair[1], pair[0], a, b).map(|point| (segment, point))
        };
        let met = segments(ring).enumerate().filter_map(meets);
        let far = |(_, point): &(usize, Point2)| distance(*point, pair[1]);
        if let Some((segment, point)) = met.min_by(|p, q| far(p).total_cmp(&far(q))) {
            return Some(leg_to(ring, (segment, point), inner));
        }
    }
    let foot = nearest(segments(ring), leg[0]).filter(|foot| foot.distance <= REACH)?;
    let (a, b) = segments(ring).nth(foot.segment)?;
    Some(leg_to(ring, (foot.segment, lerp(a, b, foot.at)), inner))
}

fn leg_to(
    ring: &[Point2],
    (segment, point): (usize, Point2),
    mut inner: Vec<Point2>,
) -> (RingPlace, Vec<Point2>) {
    let before = segments(ring).take(segment);
    let along = before.map(|(a, b)| distance(a, b)).sum::<f64>() + distance(ring[segment], point);
    inner.push(point);
    inner.reverse();
    let place = RingPlace {
        point,
        segment,
        along,
    };
    (place, inner)
}

/// Returns true if two lines from the mouth to the tip are the legs of a dart.
fn is_dart(legs: [&[Point2]; 2]) -> bool {
    let lengths = legs.map(length);
    let width = distance(legs[0][0], legs[1][0]);
    let is_straight = |leg: &[Point2]| {
        let (a, b) = (leg[0], leg[leg.len() - 1]);
        let chord = distance(a, b);
        let aside = |p: &Point2| cross(sub(b, a), sub(*p, a)).abs() / chord;
        leg.iter().all(|p| aside(p) <= MOST_BULGE * chord)
    };
    lengths.iter().all(|length| within(*length, LEG))
        && agree(lengths[0], lengths[1])
        && within(width, MOUTH)
        && width <= WIDEST * lengths[0].min(lengths[1])
        && legs.into_iter().all(is_straight)
}
