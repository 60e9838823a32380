//! Sleeveless top: front and back of a shell without darts, a round neckline, hem at the high hip.
//!
//! Both pieces lie face up, so the right of the front is the wearer's left, and the right of the back the right. The
//! height 0 is that of the side of the neck.

use super::body::Body;
use super::curve::{Point, fair, joined, mirrored};
use super::garment::Draft;
use super::piece::{Piece, Style};

const BUST_EASE: f64 = 70.0;
/// The armhole is deeper than the armscye by this \[mm\].
const ARMHOLE_EASE: f64 = 8.0;
/// The neckline is wider than the neck by this on each side, along the shoulder's level.
const NECK_WIDENING: f64 = 20.0;
/// The shoulder ends this far inside its tip.
const SHOULDER_INSET: f64 = 30.0;
/// The side seam comes in by this at the waist, and the hem goes out by that.
const WAIST_SHAPING: f64 = 8.0;
const HEM_WIDENING: f64 = 10.0;
const BELOW_WAIST: f64 = 145.0;
/// The hem is lower at the centre than at the side by this.
const HEM_CURVE: f64 = 8.0;

/// What the front does otherwise than the back.
struct Shape {
    name: &'static str,
    /// Depth of the neckline below the side of the neck.
    neck_depth: f64,
    /// Half the width between the armholes, at their narrowest.
    half_across: f64,
    /// Vertices of the lower part of the armhole that are notched: one in front, two in the back.
    notches: &'static [usize],
    origin: Point,
}

/// All pieces.
pub(crate) fn draft(body: &Body) -> Style {
    let front = Shape {
        name: "FRONT",
        // The pit of the neck lies lower than its side by its half width and 10 mm.
        neck_depth: body.half_neck + 10.0 + 24.0,
        half_across: body.half_back - 30.0,
        notches: &[5],
        origin: [0.0, 0.0],
    };
    let back = Shape {
        name: "BACK",
        neck_depth: body.neck_rise + 25.0,
        half_across: body.half_back - 24.0,
        notches: &[4, 5],
        origin: [650.0, 0.0],
    };
    Style {
        name: "SLEEVELESS TOP",
        pieces: vec![piece(body, &front), piece(body, &back)],
    }
}

/// Seams and placements.
pub(crate) fn garment() -> Draft {
    let (front, back) = ("front", "back");
    Draft {
        seams: vec![
            ("shoulder-left", (front, 1, 2), (back, 0, 7)),
            ("shoulder-right", (front, 0, 7), (back, 1, 2)),
            ("side-left", (front, 3, 4), (back, 6, 5)),
            ("side-right", (front, 6, 5), (back, 3, 4)),
        ],
        placements: vec![(front, "torso_front"), (back, "torso_back")],
    }
}

/// Corners: 0, 1 neckline; 2 shoulder, 3 underarm and 4 hem on the right; 5 hem, 6 underarm and 7 shoulder on the left.
fn piece(body: &Body, shape: &Shape) -> Piece {
    let quarter = (body.bust + BUST_EASE) / 4.0;
    let slope = body.shoulder_slope;
    let on_shoulder = |x: f64| [x, -(x - body.half_neck) * slope];
    let neck = on_shoulder(body.half_neck + NECK_WIDENING);
    let tip = on_shoulder(body.half_shoulders - SHOULDER_INSET);
    let underarm = [
        quarter,
        -(body.neck_rise + body.armscye_depth + ARMHOLE_EASE),
    ];
    let waist_level = -(body.neck_rise + body.nape_to_waist);
    let waist = [quarter - WAIST_SHAPING, waist_level];
    let hem = [quarter + HEM_WIDENING, waist_level - BELOW_WAIST];

    let neckline = fair([0.0, -shape.neck_depth], [1.0, 0.0], neck, [slope, 1.0]);
    // Narrowest in the middle of the armhole.
    let across = [shape.half_across, f64::midpoint(tip[1], underarm[1])];
    let upper = fair(tip, [-slope, -1.0], across, [0.0, -1.0]);
    let lower = fair(across, [0.0, -1.0], underarm, [1.0, 0.0]);
    let side = side_seam(underarm, waist, hem);
    let spread = (hem[0] - waist[0]) / BELOW_WAIST;
    let hemline = fair(
        hem,
        [-1.0, -spread / 2.0],
        [0.0, hem[1] - HEM_CURVE],
        [-1.0, 0.0],
    );

    let notches = armhole_notches(&lower, shape.notches);
    let armhole = joined(upper, &lower);
    Piece {
        name: shape.name,
        runs: vec![
            joined(mirrored(&neckline), &neckline),
            vec![neck, tip],
            armhole.clone(),
            side.clone(),
            joined(hemline.clone(), &mirrored(&hemline)),
            mirrored(&side),
            mirrored(&armhole),
            mirrored(&[neck, tip]),
        ],
        notches: [notches, vec![waist, [-waist[0], waist[1]]]].concat(),
        grain: [[0.0, -450.0], [0.0, -200.0]],
        origin: shape.origin,
    }
}

/// In to the waist and out over the hip, smooth at the waist.
fn side_seam(underarm: Point, waist: Point, hem: Point) -> Vec<Point> {
    let upper = fair(underarm, [-0.08, -1.0], waist, [0.0, -1.0]);
    let lower = fair(waist, [0.0, -1.0], hem, [0.2, -1.0]);
    joined(upper, &lower)
}

fn armhole_notches(lower: &[Point], at: &[usize]) -> Vec<Point> {
    let both_sides = |i: &usize| [lower[*i], [-lower[*i][0], lower[*i][1]]];
    at.iter().flat_map(both_sides).collect()
}
