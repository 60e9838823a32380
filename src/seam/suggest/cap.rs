//! Which side of a sleeve's cap is the front: that whose notches fit the front of the armhole, or which is cut out more.

use super::garment::Garment;
use super::piece::{Hand, Kind, Lateral, Piece, Role, Segment, Which};

/// Notches fit when they lie as far from the underarm up to this \[m\]: caps are eased in.
const NEAR: f64 = 0.015;
/// Notches of one edge that are looked at.
const MOST_NOTCHES: usize = 64;

/// The part of a cap's width next to the underarm, and how much both sides must differ there.
const OUTER: f64 = 0.35;
const UNEVEN: f64 = 0.03;

/// The hand on which the front of a sleeve lies; nothing where nothing tells.
pub(super) fn front_hand(garment: &Garment, sleeve: &Piece) -> Option<Hand> {
    let cap = sleeve.segment(Role::Cap, None)?;
    let ends =
        [Hand::Left, Hand::Right].map(|hand| notches(sleeve, cap, hand == sleeve.first_hand()));
    let holes = [Which::Front, Which::Back].map(|which| {
        let (piece, segment) =
            garment.segment(Kind::Bodice, which, (Role::Armhole, Lateral::Left))?;
        Some(notches(piece, segment, segment.before == Role::Side))
    });
    let [Some(front), Some(back)] = holes else {
        return None;
    };
    let straight = common(&ends[0], &front) + common(&ends[1], &back);
    let turned = common(&ends[1], &front) + common(&ends[0], &back);
    match straight.cmp(&turned) {
        std::cmp::Ordering::Greater => Some(Hand::Left),
        std::cmp::Ordering::Less => Some(Hand::Right),
        std::cmp::Ordering::Equal => cut_out(sleeve, cap),
    }
}

/// The hand on which the cap is cut out more near the underarm: the arm moves forward.
fn cut_out(sleeve: &Piece, cap: &Segment) -> Option<Hand> {
    let points = sleeve.shape.polyline(&cap.edges);
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return None;
    };
    let base = [last[0] - first[0], last[1] - first[1]];
    let width = base[0].hypot(base[1]).max(1e-9);
    let place = |p: &[f64; 2]| {
        let d = [p[0] - first[0], p[1] - first[1]];
        let along = (d[0] * base[0] + d[1] * base[1]) / (width * width);
        let up = (d[0] * base[1] - d[1] * base[0]).abs() / width;
        [along, up]
    };
    // Area under the cap over the outer parts of its width, from the beginning and from the end.
    let mut area = [0.0, 0.0];
    for pair in points.windows(2) {
        let [a, b] = [place(&pair[0]), place(&pair[1])];
        let middle = 0.5 * (a[0] + b[0]);
        let strip = 0.5 * (a[1] + b[1]) * (b[0] - a[0]);
        if middle < OUTER {
            area[0] += strip;
        } else if middle > 1.0 - OUTER {
            area[1] += strip;
        }
    }
    if (area[0] - area[1]).abs() < UNEVEN * area[0].max(area[1]) {
        return None;
    }
    let hand = sleeve.first_hand();
    Some(if area[0] < area[1] {
        hand
    } else {
        hand.other()
    })
}

/// Distances of the notches on a segment from its beginning or its end \[m\].
fn notches(piece: &Piece, segment: &Segment, from_start: bool) -> Vec<f64> {
    let whole = piece.shape.length(&segment.edges);
    let mut before = 0.0;
    let mut found = vec![];
    for edge in &segment.edges {
        let length = piece.shape.edges[*edge].length;
        for (_, at) in piece.shape.notches.iter().filter(|(e, _)| e == edge) {
            let from = before + at * length;
            found.push(if from_start { from } else { whole - from });
        }
        before += length;
    }
    found.sort_by(f64::total_cmp);
    found.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    found.truncate(MOST_NOTCHES);
    found
}

/// How many of `a` have their like in `b`.
fn common(a: &[f64], b: &[f64]) -> usize {
    a.iter()
        .filter(|x| b.iter().any(|y| (*x - y).abs() <= NEAR))
        .count()
}
