//! Placements of the panels of a suggestion on the body (P7).

use super::garment_model::GarmentModel;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, Laterality, PanelKind};
use super::ring_panel::{RingPanel, RingPlace};
use crate::pattern::PlacementAnchor::{
    self, ArmLeft, ArmLeftBack, ArmLeftFront, ArmRight, ArmRightBack, ArmRightFront, LegLeft,
    LegRight, Neck, NeckBack, NeckFront, SkirtBack, SkirtFront, TorsoBack, TorsoFront, Waist,
    WaistBack, WaistFront,
};
use crate::pattern::{Placement, Wrap};

/// Returns the placement of each panel that has a place, with its index.
pub(super) fn placements(garment: &GarmentModel) -> Vec<(usize, Placement)> {
    let parts = garment.parts.iter();
    let parts = parts.filter_map(|part| Some((part.panel, placement(garment, part)?)));
    let rings = garment
        .rings
        .iter()
        .map(|ring| (ring.panel, level(garment, ring)));
    parts.chain(rings).collect()
}

/// Returns the placement of a ring: level round the body.
fn level(garment: &GarmentModel, ring: &RingPanel) -> Placement {
    let (at, down) = match ring.place {
        RingPlace::Neck => (Neck, 0.0),
        RingPlace::Waist(down) => (Waist, down),
        RingPlace::BodiceHem => (TorsoFront, tallest(garment, PanelKind::Bodice)),
    };
    Placement {
        at: Some(at),
        up_deg: None,
        offset_m: [0.0, -(1e4 * down).round() / 1e4, 0.0],
        rotate_deg: [0.0; 3],
        wrap: Some(Wrap::Level),
    }
}

fn placement(garment: &GarmentModel, part: &LabeledPanel) -> Option<Placement> {
    let behind = part.front_back == Some(FrontBack::Back);
    let side = match part.laterality {
        Some(Laterality::Left) => 1.0,
        Some(Laterality::Right) => -1.0,
        None => 0.0,
    };
    let (at, offset_m) = match part.kind {
        PanelKind::Bodice | PanelKind::Yoke | PanelKind::Side => {
            (pick(behind, TorsoFront, TorsoBack), beside(part, side))
        }
        PanelKind::Skirt if is_all_round(garment, part) => (SkirtFront, [0.0; 3]),
        PanelKind::Skirt if part.front_back.is_none() => gore(garment, part),
        PanelKind::Skirt | PanelKind::Trouser => {
            let [x, ..] = beside(part, side);
            let at = pick(behind, SkirtFront, SkirtBack);
            (at, [x, -above(garment, part), 0.0])
        }
        PanelKind::Godet => {
            let at = pick(behind, SkirtFront, SkirtBack);
            (at, [0.0, -0.4, 0.1 * if behind { -1.0 } else { 1.0 }])
        }
        PanelKind::Waistband => (band(part, [Waist, WaistFront, WaistBack]), [0.0; 3]),
        PanelKind::NeckBand | PanelKind::Collar | PanelKind::CollarStand | PanelKind::Hood => {
            let at = band(part, [Neck, NeckFront, NeckBack]);
            (
                at,
                if side == 0.0 {
                    [0.0; 3]
                } else {
                    beside(part, side)
                },
            )
        }
        PanelKind::Sleeve | PanelKind::UnderSleeve | PanelKind::ArmBand => (arm(part)?, [0.0; 3]),
        PanelKind::Leg => (pick(side < 0.0, LegLeft, LegRight), [0.0; 3]),
        PanelKind::Cuff if on_leg(garment, part) => {
            let at = pick(behind, SkirtFront, SkirtBack);
            let legs = [PanelKind::Trouser, PanelKind::Leg].map(|kind| tallest(garment, kind));
            let leg = legs[0].max(legs[1]);
            (at, [side * 0.1, -leg, 0.0])
        }
        PanelKind::Cuff => (
            arm(part)?,
            down_the_arm(tallest(garment, PanelKind::Sleeve), side),
        ),
        PanelKind::Pocket | PanelKind::Placket | PanelKind::Layer => return None,
    };
    Some(Placement {
        at: Some(at),
        up_deg: up(part),
        offset_m: offset_m.map(|c| (1e4 * c).round() / 1e4),
        rotate_deg: [0.0; 3],
        wrap: is_all_round(garment, part).then_some(Wrap::Cylinder),
    })
}

/// Returns true for a whole skirt, closed on itself.
fn is_all_round(garment: &GarmentModel, part: &LabeledPanel) -> bool {
    part.kind == PanelKind::Skirt
        && part.front_back.is_none()
        && garment.parts_of(PanelKind::Skirt).count() == 1
}

fn pick(behind: bool, front: PlacementAnchor, back: PlacementAnchor) -> PlacementAnchor {
    if behind { back } else { front }
}

fn band(part: &LabeledPanel, [whole, front, back]: [PlacementAnchor; 3]) -> PlacementAnchor {
    match part.front_back {
        None => whole,
        Some(FrontBack::Front) => front,
        Some(FrontBack::Back) => back,
    }
}

fn arm(part: &LabeledPanel) -> Option<PlacementAnchor> {
    Some(match (part.laterality?, part.front_back) {
        (Laterality::Left, None) => ArmLeft,
        (Laterality::Left, Some(FrontBack::Front)) => ArmLeftFront,
        (Laterality::Left, Some(FrontBack::Back)) => ArmLeftBack,
        (Laterality::Right, None) => ArmRight,
        (Laterality::Right, Some(FrontBack::Front)) => ArmRightFront,
        (Laterality::Right, Some(FrontBack::Back)) => ArmRightBack,
    })
}

fn on_leg(garment: &GarmentModel, part: &LabeledPanel) -> bool {
    part.of.contains(&PanelKind::Trouser) || !garment.has(PanelKind::Sleeve)
}

/// Returns the offset of half a panel, which stands beside the middle \[m\].
fn beside(part: &LabeledPanel, side: f64) -> [f64; 3] {
    let width = if part.half || side != 0.0 {
        extent(part)[0]
    } else {
        0.0
    };
    [0.5 * side * width, 0.0, 0.0]
}

/// Returns how far the levels above a level of a skirt reach down \[m\].
fn above(garment: &GarmentModel, part: &LabeledPanel) -> f64 {
    let higher = garment.parts_of(part.kind).filter(|p| {
        p.front_back == part.front_back && p.number < part.number && p.laterality == part.laterality
    });
    higher.map(|p| extent(p)[1]).sum()
}

/// Returns the place of a gore: they stand side by side, half of them in front.
fn gore(garment: &GarmentModel, part: &LabeledPanel) -> (PlacementAnchor, [f64; 3]) {
    let mut gores: Vec<&LabeledPanel> = garment
        .parts_of(PanelKind::Skirt)
        .filter(|p| p.front_back.is_none())
        .collect();
    gores.sort_by_key(|p| p.number);
    let at = gores
        .iter()
        .position(|p| p.panel == part.panel)
        .unwrap_or_default();
    let in_front = gores.len().div_ceil(2);
    let (anchor, place, of) = if at < in_front {
        (SkirtFront, at, in_front)
    } else {
        (SkirtBack, gores.len() - 1 - at, gores.len() - in_front)
    };
    #[expect(clippy::cast_precision_loss, reason = "a handful of gores")]
    let step = place as f64 - 0.5 * (of as f64 - 1.0);
    (anchor, [step * extent(part)[0], 0.0, 0.0])
}

fn tallest(garment: &GarmentModel, kind: PanelKind) -> f64 {
    garment
        .parts_of(kind)
        .map(|p| extent(p)[1])
        .fold(0.0, f64::max)
}

/// Returns the offset down a sleeve that leans away from the body \[m\].
fn down_the_arm(length: f64, side: f64) -> [f64; 3] {
    [0.64 * side * length, -0.76 * length, 0.0]
}

/// Returns the direction on the drawing that is up, from the hem into the panel \[degrees\];
/// nothing where it is that of the drawing.
fn up(part: &LabeledPanel) -> Option<f64> {
    let hem = part.segment(EdgeRole::Hem, None)?;
    let (first, last) = (hem.edges.first()?, hem.edges.last()?);
    let [a, b] = [
        part.features.edges[*first].ends[0],
        part.features.edges[*last].ends[1],
    ];
    let along = (b[1] - a[1]).atan2(b[0] - a[0]).to_degrees();
    // The hem of a panel that lies hem down and in clockwise order runs to the left.
    let up = if part.features.mirrored {
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

/// Returns the width and height of a panel the way up that it is worn \[m\].
fn extent(part: &LabeledPanel) -> [f64; 2] {
    let (sin, cos) = (90.0 - up(part).unwrap_or(90.0)).to_radians().sin_cos();
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for [x, y] in part.features.points.iter().flatten() {
        for (bound, value) in bounds
            .iter_mut()
            .zip([cos * x - sin * y, sin * x + cos * y])
        {
            *bound = [bound[0].min(value), bound[1].max(value)];
        }
    }
    bounds.map(|[low, high]| (high - low).max(0.0))
}
