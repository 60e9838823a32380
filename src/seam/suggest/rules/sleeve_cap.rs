//! The front of a sleeve's cap: the side whose notches fit the front of the armhole, or which is
//! cut out more.

use crate::pattern::Point2;
use crate::seam::suggest::garment_model::GarmentModel;
use crate::seam::suggest::labeled_panel::{LabeledPanel, RoleSegment};
use crate::seam::suggest::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};

/// Notches fit when they lie as far from the underarm up to this \[m\]: caps are eased in.
const NOTCH_TOLERANCE_M: f64 = 0.015;
/// Notches of one edge that are looked at.
const MAX_NOTCHES: usize = 64;

/// The part of a cap's width next to the underarm, and how much both sides must differ there.
const OUTER_SHARE: f64 = 0.35;
const MIN_DIFFERENCE: f64 = 0.03;

/// Returns the side of the drawing on which the front of a sleeve lies; nothing where nothing
/// tells.
pub(super) fn front_side(garment: &GarmentModel, sleeve: &LabeledPanel) -> Option<DrawnSide> {
    let cap = sleeve.segment(EdgeRole::Cap, None)?;
    let ends = [DrawnSide::Left, DrawnSide::Right]
        .map(|drawn_side| notches(sleeve, cap, drawn_side == sleeve.first_drawn_side()));
    let holes = [FrontBack::Front, FrontBack::Back].map(|front_back| {
        let (part, segment) = garment.segment(
            PanelKind::Bodice,
            front_back,
            (EdgeRole::Armhole, Laterality::Left),
        )?;
        Some(notches(part, segment, segment.before == EdgeRole::Side))
    });
    let [Some(front), Some(back)] = holes else {
        return None;
    };
    let straight = common(&ends[0], &front) + common(&ends[1], &back);
    let turned = common(&ends[1], &front) + common(&ends[0], &back);
    match straight.cmp(&turned) {
        std::cmp::Ordering::Greater => Some(DrawnSide::Left),
        std::cmp::Ordering::Less => Some(DrawnSide::Right),
        std::cmp::Ordering::Equal => cut_out(sleeve, cap),
    }
}

/// Returns the side of the drawing on which the cap is cut out more near the underarm: the arm
/// moves forward.
fn cut_out(sleeve: &LabeledPanel, cap: &RoleSegment) -> Option<DrawnSide> {
    let points = sleeve.features.polyline(&cap.edges);
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return None;
    };
    let base = [last[0] - first[0], last[1] - first[1]];
    let width = base[0].hypot(base[1]).max(1e-9);
    let place = |p: &Point2| {
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
        if middle < OUTER_SHARE {
            area[0] += strip;
        } else if middle > 1.0 - OUTER_SHARE {
            area[1] += strip;
        }
    }
    if (area[0] - area[1]).abs() < MIN_DIFFERENCE * area[0].max(area[1]) {
        return None;
    }
    let drawn_side = sleeve.first_drawn_side();
    Some(if area[0] < area[1] {
        drawn_side
    } else {
        drawn_side.other()
    })
}

/// Returns the distances of the notches on a segment from its beginning or its end \[m\].
fn notches(part: &LabeledPanel, segment: &RoleSegment, from_start: bool) -> Vec<f64> {
    let whole = part.features.length(&segment.edges);
    let mut before = 0.0;
    let mut found = vec![];
    for edge in &segment.edges {
        let length = part.features.edges[*edge].length;
        for (_, at) in part.features.notches.iter().filter(|(e, _)| e == edge) {
            let from = before + at * length;
            found.push(if from_start { from } else { whole - from });
        }
        before += length;
    }
    found.sort_by(f64::total_cmp);
    found.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    found.truncate(MAX_NOTCHES);
    found
}

/// Counts the distances of `a` that have their like in `b`.
fn common(a: &[f64], b: &[f64]) -> usize {
    a.iter()
        .filter(|x| b.iter().any(|y| (*x - y).abs() <= NOTCH_TOLERANCE_M))
        .count()
}
