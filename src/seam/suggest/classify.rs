//! From panels to pieces: what each panel is, by its name and by its look, front or back, left or right.

use super::piece::{Hand, Kind, Lateral, Piece, Role, Step, Which};
use super::shape::Shape;
use super::{choose, looks, template, words};
use crate::pattern::{Face, Panel, Pattern};

/// Kinds that a panel may be whose name says only front or back, or nothing.
const BODY: [Kind; 3] = [Kind::Bodice, Kind::Skirt, Kind::Trouser];
const ANY: [Kind; 5] = [
    Kind::Bodice,
    Kind::Skirt,
    Kind::Trouser,
    Kind::Sleeve,
    Kind::NeckBand,
];
/// What a panel without a telling name may be where other panels of the pattern have one.
const EXTRA: [Kind; 2] = [Kind::Sleeve, Kind::NeckBand];
/// What a panel without a telling name must look like at least: mean misfit of a role.
const RECOGNISED: f64 = 2.5;
/// Lengths of two panels that mirror each other agree to this share.
const TWINS: f64 = 0.01;
/// How many readings of a panel are weighed.
const KEPT: usize = 24;
/// Misfit added where the name or the symmetry of a panel speaks against a reading.
const UNLIKELY: f64 = 3.0;
/// Misfit added for a panel drawn on its side, for a hem drawn above, and for a front drawn as seen through the body.
/// A waist this much longer than the hem is unusual.
const WIDE_WAIST: f64 = 1.1;
/// Misfit added where a reading contradicts how such panels are made.
const ABSURD: f64 = 1.5;
/// An edge that turns less is straight, one that turns more curved \[rad\].
const STRAIGHT: f64 = 0.15;
const CURVED: f64 = 0.6;
const ON_ITS_SIDE: f64 = 0.8;
const UPSIDE_DOWN: f64 = 0.8;
/// Misfit added for half a skirt panel that no name calls so.
const HALF_SKIRT: f64 = 1.5;
const FROM_INSIDE: f64 = 0.3;

/// The pieces of a pattern.
pub(super) fn pieces(pattern: &Pattern) -> Vec<Piece> {
    let names: Vec<&str> = pattern.panels.iter().map(|p| p.name.as_str()).collect();
    let common = words::common_start(&names);
    let said: Vec<words::Said> = pattern
        .panels
        .iter()
        .map(|panel| {
            let name = if panel.name.is_empty() {
                &panel.id
            } else {
                &panel.name
            };
            words::said(name, panel.name.get(common..).unwrap_or_default())
        })
        .collect();
    let slits = said.iter().any(|s| s.kind == Some(Kind::Godet));
    let telling = said
        .iter()
        .any(|s| s.which.is_some() || s.kind.is_some_and(|kind| BODY.contains(&kind)));
    let candidates: Vec<Vec<Piece>> = (0..names.len())
        .map(|index| {
            let panel = &pattern.panels[index];
            let said = &said[index];
            candidates(
                index,
                Shape::of(panel, slits),
                said,
                (upright(panel), telling),
            )
        })
        .collect();
    let mut pieces = choose::together(candidates);
    tell_front_from_back(&mut pieces);
    let turned: Vec<bool> = pieces
        .iter()
        .map(|p| is_turned(pattern, &pieces, p))
        .collect();
    for (piece, turned) in pieces.iter_mut().zip(turned) {
        piece.turned = turned;
    }
    tell_left_from_right(&mut pieces, pattern.panels.len());
    pieces
}

/// What a panel may be, the likeliest first.
fn candidates(
    panel: usize,
    shape: Shape,
    said: &words::Said,
    (upright, telling): (Option<bool>, bool),
) -> Vec<Piece> {
    let kinds: Vec<Kind> = match (said.kind, said.which) {
        (Some(kind), _) => vec![kind],
        (None, Some(_)) => BODY.to_vec(),
        (None, None) if telling => EXTRA.to_vec(),
        (None, None) => ANY.to_vec(),
    };
    let named = said.kind.is_some() || said.which.is_some();
    let symmetric = shape.is_symmetric();
    let mut found: Vec<Piece> = vec![];
    for kind in kinds {
        for template in looks::of(kind) {
            let unlikely = template.rare + unlikely(kind, template.half, said, symmetric);
            for divided in template::divide(&shape, &template).into_iter().take(KEPT) {
                let mut piece = Piece {
                    panel,
                    kind,
                    of: said.of.clone(),
                    number: said.number,
                    which: said.which,
                    lateral: said.lateral,
                    lateral_said: said.lateral.is_some(),
                    half: template.half,
                    turned: false,
                    shape: shape.clone(),
                    segments: divided.segments,
                    cost: divided.cost + unlikely,
                    named,
                    kind_said: said.kind.is_some(),
                };
                piece.cost += unusual(&piece, upright);
                found.push(piece);
            }
        }
    }
    found.retain(|piece| named || piece.cost < RECOGNISED);
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found.truncate(KEPT);
    found
}

/// What speaks against taking a panel for half or for whole.
fn unlikely(kind: Kind, half: bool, said: &words::Said, symmetric: bool) -> f64 {
    let halved = match kind {
        Kind::Sleeve => Some(said.which.is_some()),
        Kind::Bodice | Kind::Skirt if said.lateral.is_some() => Some(true),
        Kind::Bodice | Kind::Skirt | Kind::Trouser => symmetric.then_some(false),
        _ => None,
    };
    match halved {
        Some(halved) if halved != half => UNLIKELY,
        None if half && kind == Kind::Skirt => HALF_SKIRT,
        _ => 0.0,
    }
}

/// What speaks against how a reading says that a panel is drawn: on its side, hem up, or a front as seen through the body.
fn unusual(piece: &Piece, upright: Option<bool>) -> f64 {
    let lower: Vec<usize> = piece
        .all(Role::Hem)
        .chain(piece.all(Role::Long))
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let mut cost = if is_absurd(piece) { ABSURD } else { 0.0 };
    if piece.kind == Kind::Sleeve || lower.is_empty() {
        return cost;
    }
    if upright.is_some_and(|upright| piece.shape.is_level(&lower) != upright) {
        cost += ON_ITS_SIDE;
    }
    let hem: Vec<usize> = piece
        .all(Role::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let above = piece.shape.height(&hem) > piece.shape.height(&piece.shape.ring);
    if upright == Some(true) && !hem.is_empty() && above {
        cost += UPSIDE_DOWN;
    }
    if piece.kind == Kind::Skirt && piece.number == 0 {
        let length = |role| -> f64 { piece.all(role).map(|s| piece.shape.length(&s.edges)).sum() };
        if length(Role::Waist) > WIDE_WAIST * length(Role::Hem) {
            cost += UPSIDE_DOWN;
        }
    }
    let said = piece
        .lateral
        .filter(|_| piece.half && piece.which == Some(Which::Front) && BODY.contains(&piece.kind));
    if said.is_some() && side_hand(piece).map(|hand| piece.lateral_of(hand)) != said {
        cost += FROM_INSIDE;
    }
    cost
}

/// Whether a reading has what no such panel has: shoulders that rise towards the arm, an underarm longer than the sleeve,
/// a cap that is straight, a hood whose opening is round, slits for godets in the waist.
fn is_absurd(piece: &Piece) -> bool {
    let hem: Vec<usize> = piece
        .all(Role::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    let rising = piece.all(Role::Shoulder).any(|shoulder| {
        let chain = piece.chain_from(shoulder, Role::Neck);
        let end = |step: Option<&Step>, last: bool| {
            step.map(|s| piece.shape.edges[s.edge].ends[usize::from(s.forward == last)])
        };
        match (end(chain.first(), false), end(chain.last(), true)) {
            (Some(neck), Some(arm)) => piece.shape.above(&hem, neck) < piece.shape.above(&hem, arm),
            _ => false,
        }
    });
    let length = |role| -> f64 { piece.all(role).map(|s| piece.shape.length(&s.edges)).sum() };
    let curl = |role| -> f64 { piece.all(role).map(|s| piece.shape.curl(&s.edges)).sum() };
    let straight_cap = piece.segment(Role::Cap, None).is_some() && curl(Role::Cap) < STRAIGHT;
    let curved_face = piece.kind == Kind::Hood && curl(Role::Hem) > CURVED;
    let short_top = length(Role::Top) > 0.0 && length(Role::Underarm) > length(Role::Top);
    let count = |role| -> usize { piece.all(role).map(|s| s.edges.len()).sum() };
    let slit_waist = piece.shape.slits && count(Role::Waist) > count(Role::Hem);
    rising || slit_waist || straight_cap || curved_face || short_top
}

/// Whether a panel stands or lies in its drawing, as far as its grain says.
fn upright(panel: &Panel) -> Option<bool> {
    let Some(grain) = panel.grain else {
        return Some(true);
    };
    let from_vertical = (grain.angle_deg - 90.0).abs();
    match from_vertical {
        d if d <= 30.0 => Some(true),
        d if d >= 60.0 => Some(false),
        _ => None,
    }
}

/// Whether a panel is drawn as seen through the body: as the names of halves like it say, or its file. Else backs that
/// are drawn whole are taken to be drawn in one view with their fronts, as tools that know the body write them; halves
/// and panels drawn on the fold are pieces to cut, which lie right side up.
fn is_turned(pattern: &Pattern, pieces: &[Piece], piece: &Piece) -> bool {
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
fn side_hand(piece: &Piece) -> Option<Hand> {
    piece.segments.first().map(|s| s.hand)
}

/// Gives fronts and backs to body panels whose names do not say: the deeper neck, the shorter crotch is the front.
fn tell_front_from_back(pieces: &mut [Piece]) {
    for (kind, role, front_is_longer) in [
        (Kind::Bodice, Role::Neck, true),
        (Kind::Trouser, Role::Crotch, false),
        (Kind::Skirt, Role::Waist, true),
    ] {
        let unsaid: Vec<usize> = (0..pieces.len())
            .filter(|i| pieces[*i].kind == kind && pieces[*i].which.is_none())
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
}

/// Gives every half a side of the wearer, adding the mirrored copy of those that are drawn once. Of pieces that are
/// neither drawn as a pair nor called left or right the first is taken: others are other styles of the same part.
fn tell_left_from_right(pieces: &mut Vec<Piece>, panels: usize) {
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
        if lone && !piece.shape.mirrored {
            copies.push(Piece {
                panel: piece.panel + panels,
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
    copy.shape = copy.shape.reflected();
    copy.lateral = copy.lateral.map(Lateral::other);
    for segment in &mut copy.segments {
        segment.hand = segment.hand.other();
    }
    copy
}
