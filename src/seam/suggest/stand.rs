//! Where the pieces of a suggestion start on the body: the placements that go with its seams (P7).

use super::garment::Garment;
use super::piece::{Kind, Lateral, Piece, Role, Which};
use crate::pattern::{Anchor, Placement, Wrap};

/// The placement of each piece that has a place, with the number of its panel.
pub(super) fn placements(garment: &Garment) -> Vec<(usize, Placement)> {
    let all = garment.pieces.iter();
    all.filter_map(|piece| Some((piece.panel, placement(garment, piece)?)))
        .collect()
}

fn placement(garment: &Garment, piece: &Piece) -> Option<Placement> {
    let behind = piece.which == Some(Which::Back);
    let side = match piece.lateral {
        Some(Lateral::Left) => 1.0,
        Some(Lateral::Right) => -1.0,
        None => 0.0,
    };
    let (at, offset_m) = match piece.kind {
        Kind::Bodice | Kind::Yoke => (
            pick(behind, Anchor::TorsoFront, Anchor::TorsoBack),
            beside(piece, side),
        ),
        Kind::Skirt if is_all_round(garment, piece) => (Anchor::SkirtFront, [0.0; 3]),
        Kind::Skirt if piece.which.is_none() => gore(garment, piece),
        Kind::Skirt | Kind::Trouser => {
            let [x, ..] = beside(piece, side);
            let at = pick(behind, Anchor::SkirtFront, Anchor::SkirtBack);
            (at, [x, -above(garment, piece), 0.0])
        }
        Kind::Godet => {
            let at = pick(behind, Anchor::SkirtFront, Anchor::SkirtBack);
            (at, [0.0, -0.4, 0.1 * if behind { -1.0 } else { 1.0 }])
        }
        Kind::Waistband => (
            band(
                piece,
                [Anchor::Waist, Anchor::WaistFront, Anchor::WaistBack],
            ),
            [0.0; 3],
        ),
        Kind::NeckBand | Kind::Collar | Kind::CollarStand | Kind::Hood => {
            let at = band(piece, [Anchor::Neck, Anchor::NeckFront, Anchor::NeckBack]);
            (
                at,
                if side == 0.0 {
                    [0.0; 3]
                } else {
                    beside(piece, side)
                },
            )
        }
        Kind::Sleeve | Kind::ArmBand => (arm(piece)?, [0.0; 3]),
        Kind::Cuff if on_leg(garment, piece) => {
            let at = pick(behind, Anchor::SkirtFront, Anchor::SkirtBack);
            let leg = tallest(garment, Kind::Trouser);
            (at, [side * 0.1, -leg, 0.0])
        }
        Kind::Cuff => (
            arm(piece)?,
            down_the_arm(tallest(garment, Kind::Sleeve), side),
        ),
        Kind::Pocket | Kind::Placket | Kind::Layer => return None,
    };
    Some(Placement {
        at: Some(at),
        up_deg: up(piece),
        offset_m: offset_m.map(|c| (1e4 * c).round() / 1e4),
        rotate_deg: [0.0; 3],
        wrap: is_all_round(garment, piece).then_some(Wrap::Cylinder),
    })
}

/// Whether a panel is a whole skirt, closed on itself.
fn is_all_round(garment: &Garment, piece: &Piece) -> bool {
    piece.kind == Kind::Skirt && piece.which.is_none() && garment.of(Kind::Skirt).count() == 1
}

fn pick(behind: bool, front: Anchor, back: Anchor) -> Anchor {
    if behind { back } else { front }
}

fn band(piece: &Piece, [whole, front, back]: [Anchor; 3]) -> Anchor {
    match piece.which {
        None => whole,
        Some(Which::Front) => front,
        Some(Which::Back) => back,
    }
}

fn arm(piece: &Piece) -> Option<Anchor> {
    Some(match (piece.lateral?, piece.which) {
        (Lateral::Left, None) => Anchor::ArmLeft,
        (Lateral::Left, Some(Which::Front)) => Anchor::ArmLeftFront,
        (Lateral::Left, Some(Which::Back)) => Anchor::ArmLeftBack,
        (Lateral::Right, None) => Anchor::ArmRight,
        (Lateral::Right, Some(Which::Front)) => Anchor::ArmRightFront,
        (Lateral::Right, Some(Which::Back)) => Anchor::ArmRightBack,
    })
}

fn on_leg(garment: &Garment, piece: &Piece) -> bool {
    piece.of.contains(&Kind::Trouser) || !garment.has(Kind::Sleeve)
}

/// Half a panel stands beside the middle.
fn beside(piece: &Piece, side: f64) -> [f64; 3] {
    let width = if piece.half || side != 0.0 {
        extent(piece)[0]
    } else {
        0.0
    };
    [0.5 * side * width, 0.0, 0.0]
}

/// How far the levels above a level of a skirt reach down \[m\].
fn above(garment: &Garment, piece: &Piece) -> f64 {
    let higher = garment.of(piece.kind).filter(|p| {
        p.which == piece.which && p.number < piece.number && p.lateral == piece.lateral
    });
    higher.map(|p| extent(p)[1]).sum()
}

/// Gores stand side by side, half of them in front.
fn gore(garment: &Garment, piece: &Piece) -> (Anchor, [f64; 3]) {
    let mut gores: Vec<&Piece> = garment
        .of(Kind::Skirt)
        .filter(|p| p.which.is_none())
        .collect();
    gores.sort_by_key(|p| p.number);
    let at = gores
        .iter()
        .position(|p| p.panel == piece.panel)
        .unwrap_or_default();
    let in_front = gores.len().div_ceil(2);
    let (anchor, place, of) = if at < in_front {
        (Anchor::SkirtFront, at, in_front)
    } else {
        (
            Anchor::SkirtBack,
            gores.len() - 1 - at,
            gores.len() - in_front,
        )
    };
    #[expect(clippy::cast_precision_loss, reason = "a handful of gores")]
    let step = place as f64 - 0.5 * (of as f64 - 1.0);
    (anchor, [step * extent(piece)[0], 0.0, 0.0])
}

fn tallest(garment: &Garment, kind: Kind) -> f64 {
    garment.of(kind).map(|p| extent(p)[1]).fold(0.0, f64::max)
}

/// The way down a sleeve that leans away from the body.
fn down_the_arm(length: f64, side: f64) -> [f64; 3] {
    [0.64 * side * length, -0.76 * length, 0.0]
}

/// Direction on the drawing that is up, from the hem into the panel; nothing where the drawing says nothing else \[degrees\].
fn up(piece: &Piece) -> Option<f64> {
    let hem = piece.segment(Role::Hem, None)?;
    let (first, last) = (hem.edges.first()?, hem.edges.last()?);
    let [a, b] = [
        piece.shape.edges[*first].ends[0],
        piece.shape.edges[*last].ends[1],
    ];
    let along = (b[1] - a[1]).atan2(b[0] - a[0]).to_degrees();
    // The hem of a panel that lies hem down and in clockwise order runs to the left.
    let up = if piece.shape.mirrored {
        along + 90.0
    } else {
        along - 90.0
    };
    // A hem is seldom quite level: only a quarter turn says how the panel lies.
    let quarters = ((up - 90.0) / 90.0).round();
    let off = (up - 90.0 - 90.0 * quarters).abs();
    let angle = if off < 30.0 {
        90.0 + 90.0 * quarters
    } else {
        up.round()
    };
    let angle = angle.rem_euclid(360.0);
    ((angle - 90.0).abs() > 1e-9).then_some(angle)
}

/// Width and height of a piece the way up that it is worn \[m\].
fn extent(piece: &Piece) -> [f64; 2] {
    let (sin, cos) = (90.0 - up(piece).unwrap_or(90.0)).to_radians().sin_cos();
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for [x, y] in piece.shape.points.iter().flatten() {
        for (bound, value) in bounds
            .iter_mut()
            .zip([cos * x - sin * y, sin * x + cos * y])
        {
            *bound = [bound[0].min(value), bound[1].max(value)];
        }
    }
    bounds.map(|[low, high]| (high - low).max(0.0))
}
