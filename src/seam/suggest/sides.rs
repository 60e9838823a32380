//! Front from back and left from right: where on the body each piece is worn, and the mirrored copies of those drawn once.

use super::piece::{Hand, Kind, Lateral, Piece, Role, Which};
use crate::pattern::{Face, Pattern};
use std::rc::Rc;

/// Lengths of two panels that mirror each other agree to this share.
const TWINS: f64 = 0.01;

/// Whether a panel is drawn as seen through the body: as the names of halves like it say, or its file. Else backs that
/// are drawn whole are taken to be drawn in one view with their fronts, as tools that know the body write them; halves
/// and panels drawn on the fold are pieces to cut, which lie right side up.
pub(super) fn is_turned(pattern: &Pattern, pieces: &[Piece], piece: &Piece) -> bool {
    let alike = |p: &&Piece| {
        p.half && p.which == piece.which && p.kind == piece.kind && p.kind != Kind::Sleeve
    };
    let says = |p: &Piece| Some(p.lateral_of(side_hand(p)?) == p.lateral?);
    let (straight, turned): (Vec<bool>, Vec<bool>) = pieces
        .iter()
        .filter(alike)
        .filter_map(says)
        .partition(|straight| *straight);
    if straight.len() != turned.len() {
        return turned.len() > straight.len();
    }
    let panel = &pattern.panels[piece.panel];
    match panel.face {
        Some(face) => face == Face::Down,
        None => {
            let drawn_whole = !piece.half || piece.kind == Kind::Sleeve;
            piece.which == Some(Which::Back) && drawn_whole && !panel.unfolded
        }
    }
}

/// The hand on which half a panel has its side.
pub(super) fn side_hand(piece: &Piece) -> Option<Hand> {
    piece.segments.first().map(|s| s.hand)
}

/// Gives fronts and backs to body panels whose names do not say: the deeper neck, the shorter crotch is the front.
pub(super) fn tell_front_from_back(pattern: &Pattern, pieces: &mut [Piece]) {
    for (kind, role, front_is_longer) in [
        (Kind::Bodice, Role::Neck, true),
        (Kind::Trouser, Role::Crotch, false),
        (Kind::Skirt, Role::Waist, true),
    ] {
        let unsaid: Vec<usize> = (0..pieces.len())
            .filter(|i| {
                let p: &Piece = &pieces[*i];
                p.kind == kind && p.which.is_none() && !p.shape.mirrored
            })
            .collect();
        let length = |i: usize| -> f64 {
            let p: &Piece = &pieces[i];
            p.all(role).map(|s| p.shape.length(&s.edges)).sum()
        };
        if unsaid.len() != 2 {
            continue;
        }
        let mean = unsaid.iter().map(|i| length(*i)).sum::<f64>() / unsaid.len() as f64;
        let sides: Vec<(usize, Which)> = unsaid
            .iter()
            .enumerate()
            .map(|(k, i)| {
                let front = if (length(*i) - mean).abs() < 1e-6 {
                    k == 0
                } else {
                    (length(*i) > mean) == front_is_longer
                };
                (*i, if front { Which::Front } else { Which::Back })
            })
            .collect();
        for (i, which) in sides {
            pieces[i].which = Some(which);
        }
    }
    // A mirrored copy of the file's own is what its source is.
    for i in 0..pieces.len() {
        let source = pattern.panels[pieces[i].panel].copy_of.as_deref();
        let source = source.and_then(|id| pattern.panel_index(id));
        let which = source.and_then(|at| pieces.iter().find(|p| p.panel == at)?.which);
        pieces[i].which = pieces[i].which.or(which);
    }
}

/// Gives every half a side of the wearer, adding the mirrored copy of those that are drawn once. Of pieces that are
/// neither drawn as a pair nor called left or right the first is taken: others are other styles of the same part.
pub(super) fn tell_left_from_right(pattern: &Pattern, pieces: &mut Vec<Piece>) {
    let mut taken: Vec<usize> = vec![];
    let mut spare: Vec<usize> = vec![];
    for i in 0..pieces.len() {
        let piece = &pieces[i];
        if piece.lateral_said {
            continue;
        }
        let lateral = if is_drawn_once(piece) {
            let first = taken
                .iter()
                .copied()
                .find(|j| is_same_part(&pieces[*j], piece));
            match first {
                None => Some(usual_side(piece)),
                Some(j) if are_twins(&pieces[j], piece) => pieces[j].lateral.map(Lateral::other),
                Some(_) => {
                    spare.push(i);
                    None
                }
            }
        } else if piece.half {
            side_hand(piece).map(|hand| piece.lateral_of(hand))
        } else {
            None
        };
        if lateral.is_some() {
            taken.push(i);
        }
        pieces[i].lateral = lateral;
    }
    let mut at = 0;
    pieces.retain(|_| {
        at += 1;
        !spare.contains(&(at - 1))
    });
    let mut copies = vec![];
    for piece in pieces.iter() {
        let other = piece.lateral.map(Lateral::other);
        let lone =
            other.is_some() && !piece.lateral_said && !pieces.iter().any(|p| is_partner(p, piece));
        let id = &pattern.panels[piece.panel].id;
        let there = pattern
            .panels
            .iter()
            .any(|p| p.copy_of.as_ref() == Some(id));
        if lone && !there && !piece.shape.mirrored {
            copies.push(Piece {
                panel: piece.panel + pattern.panels.len(),
                ..mirrored(piece)
            });
        }
    }
    pieces.extend(copies);
}

/// Whether a part is worn on both sides but usually drawn for one.
fn is_drawn_once(piece: &Piece) -> bool {
    matches!(piece.kind, Kind::Sleeve | Kind::Cuff | Kind::ArmBand)
}

/// The side for which such a part is usually drawn.
fn usual_side(piece: &Piece) -> Lateral {
    if piece.kind == Kind::ArmBand {
        Lateral::Right
    } else {
        Lateral::Left
    }
}

fn is_same_part(a: &Piece, b: &Piece) -> bool {
    a.kind == b.kind && a.of == b.of && a.which == b.which && a.half == b.half
}

/// Whether two panels have the same edges.
fn are_twins(a: &Piece, b: &Piece) -> bool {
    let sorted = |p: &Piece| {
        let mut all: Vec<f64> = p.shape.edges.iter().map(|e| e.length).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let (a, b) = (sorted(a), sorted(b));
    a.len() == b.len()
        && a.iter()
            .zip(&b)
            .all(|(x, y)| (x - y).abs() <= TWINS * x.max(*y) + 1e-3)
}

fn is_partner(a: &Piece, b: &Piece) -> bool {
    is_same_part(a, b) && a.lateral == b.lateral.map(Lateral::other)
}

/// The mirrored copy of a piece: the same numbers, the other hand.
fn mirrored(piece: &Piece) -> Piece {
    let mut copy = piece.clone();
    copy.shape = Rc::new(copy.shape.reflected());
    copy.lateral = copy.lateral.map(Lateral::other);
    for segment in &mut copy.segments {
        segment.hand = segment.hand.other();
    }
    copy
}
