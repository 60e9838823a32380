//! The left leg: a tube from under the crotch to the ankle, and a foot on the floor.

use super::limb::LimbAxis;
use super::proportions::LegMeasures;
use super::tube::{Frame, Oval, along, steps};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Longest edge along the leg on a body of 1.68 m \[m\].
const STEP: f64 = 0.014;
/// Depth under the crotch at which the thigh is measured, and the leg is a tube of its own, on a
/// body of 1.68 m \[m\].
pub(super) const THIGH_DROP: f64 = 0.030;
/// Distance between the thigh and the middle there, likewise \[m\].
const THIGH_GAP: f64 = 0.010;
/// Distance of the inner side of an ankle from the middle \[m\].
const ANKLE_GAP: f64 = 0.125;
/// Heights of hip joint, knee, ankle and instep over the body's height; lengths of the foot and of
/// its width at the ball likewise.
const HIP_JOINT: f64 = 0.518;
const KNEE: f64 = 0.278;
const ANKLE: f64 = 0.076;
const INSTEP: f64 = 0.050;
const FOOT: f64 = 0.150;
const BALL: f64 = 0.054;
/// Radius of the bend at the front of the ankle, likewise.
const FILLET: f64 = 0.010;

/// Rings of a leg from the thigh on, the point that closes them, and the axis.
#[derive(Debug)]
pub(super) struct Leg {
    pub(super) rings: Vec<Vec<Vector3<f64>>>,
    pub(super) tip: Vector3<f64>,
    pub(super) axis: LimbAxis,
}

/// The lower part of a leg, from which the foot grows \[m\].
struct Ankle {
    center: Vector3<f64>,
    half: [f64; 2],
    height: f64,
}

impl Leg {
    /// `crotch` and `middle_z`: height of the crotch and z of the middle of the thigh \[m\].
    pub(super) fn new(
        measures: &LegMeasures,
        [crotch, middle_z]: [f64; 2],
        columns: usize,
    ) -> Self {
        let height = measures.height;
        let scale = height / super::torso::HEIGHT;
        let thigh_y = crotch - THIGH_DROP * scale;
        let thigh = Oval::of_girth(measures.thigh, 0.90, 2.1, columns);
        let ankle = Oval::of_girth(measures.ankle, 0.78, 2.1, columns);
        let top = Vector3::new(THIGH_GAP * scale + thigh.half[0], thigh_y, middle_z);
        let bottom = Vector3::new(
            ANKLE_GAP + ankle.half[0],
            ANKLE * height,
            middle_z - 0.030 * scale,
        );
        let on_line = |y: f64, z: f64| {
            let share = (top.y - y) / (top.y - bottom.y);
            Vector3::new(top.x + share * (bottom.x - top.x), y, z)
        };
        let knee = on_line(KNEE * height, middle_z + 0.004 * scale);
        let hip = on_line(HIP_JOINT * height, middle_z);
        let girths = girths(measures, [top.y, knee.y, bottom.y]);
        let centers = [[-top.y, top.z], [-knee.y, knee.z], [-bottom.y, bottom.z]];
        let calf = 0.3 * bottom.y + 0.7 * knee.y;
        let knots = [-top.y, -knee.y, -calf, -bottom.y];
        let ring = |down: &f64| {
            let center = |down: f64| on_line(-down, along(&centers, down));
            let direction = center(*down + 0.005) - center(*down - 0.005);
            let frame = Frame::normal_to(direction, center(*down));
            let share = (down + top.y) / (top.y - bottom.y);
            let aspect = along(&[[0.0, 0.90], [0.5, 0.96], [0.7, 0.94], [1.0, 0.78]], share);
            Oval::of_girth(along(&girths, *down), aspect, 2.1, columns).ring(&frame, columns)
        };
        let mut rings: Vec<_> = steps(&knots, STEP * scale).iter().map(ring).collect();
        let ankle = Ankle {
            center: bottom,
            half: ankle.half,
            height,
        };
        let tip = ankle.foot(&mut rings, columns);
        Self {
            rings,
            tip,
            axis: LimbAxis {
                joints: [hip, knee, bottom],
                points: vec![hip, knee, bottom],
                radii: [measures.thigh, measures.knee, measures.ankle]
                    .map(|girth| girth / TAU)
                    .to_vec(),
            },
        }
    }
}

/// Girths by depth (minus the height), from the thigh to the ankle \[m\].
fn girths(measures: &LegMeasures, [top, knee, bottom]: [f64; 3]) -> Vec<[f64; 2]> {
    let below = |share: f64| share * (knee - bottom) - knee;
    let dent = measures.knee.min(measures.calf) * 0.985;
    vec![
        [-top, measures.thigh],
        [
            -0.5 * (top + knee),
            0.52 * measures.thigh + 0.48 * measures.knee * 1.06,
        ],
        [-knee, measures.knee],
        [below(0.10), dent],
        [below(0.30), measures.calf],
        [
            below(0.75),
            0.15 * measures.calf + 0.85 * measures.ankle * 1.03,
        ],
        [below(1.0), measures.ankle],
    ]
}

impl Ankle {
    /// Adds the rings of the foot; returns the point at its tip.
    ///
    /// Heel: planes that turn about a pivot at the front of the ankle, from level to upright. Their
    /// depth from the pivot is that of a quarter of a superellipse, so that it stands flat. Then
    /// upright planes to the toes.
    fn foot(&self, rings: &mut Vec<Vec<Vector3<f64>>>, columns: usize) -> Vector3<f64> {
        let fillet = FILLET * self.height;
        let rise = INSTEP * self.height + fillet;
        let pivot = Vector3::new(
            self.center.x,
            rise,
            self.center.z + 0.98 * self.half[1] + fillet,
        );
        let back = 2.18 * self.half[1] + fillet;
        let narrow = 0.031 * self.height / super::torso::HEIGHT;
        let mut add = |center: Vector3<f64>, up: Vector3<f64>, half: [f64; 2]| {
            let frame = Frame {
                center,
                outward: Vector3::x(),
                forward: up,
            };
            let oval = Oval {
                half,
                exponent: 2.35,
            };
            rings.push(oval.ring(&frame, columns));
        };
        for i in 0..=10 {
            let share = f64::from(i) / 10.0;
            let (sin, cos) = (FRAC_PI_2 * share).sin_cos();
            let depth = ((cos / back).powi(4) + (sin / rise).powi(4)).powf(-0.25);
            let away = Vector3::new(0.0, -sin, -cos);
            let wide = 1.06 * self.half[0] + share * (narrow - 1.06 * self.half[0]);
            let middle = 0.5 * (depth + fillet);
            add(pivot + away * middle, -away, [wide, 0.5 * (depth - fillet)]);
        }
        let length = FOOT * self.height - back;
        let ball = 0.5 * BALL * self.height;
        let instep = rise - fillet;
        let heights = [
            [0.0, instep],
            [0.4, 0.78 * instep],
            [0.75, 0.46 * instep],
            [1.0, 0.38 * instep],
        ];
        let widths = [[0.0, narrow], [0.62, ball], [1.0, 0.86 * ball]];
        let round = 0.82;
        let even = (1..=9).map(|i| round * f64::from(i) / 9.0);
        let closing =
            (1..6).map(|i| round + (1.0 - round) * (FRAC_PI_2 * f64::from(i) / 6.0).sin());
        for share in even.chain(closing) {
            let close = ((share - round) / (1.0 - round)).max(0.0);
            let shrink = (1.0 - close * close).sqrt();
            let high = 0.5 * along(&heights, share);
            let center = Vector3::new(pivot.x, high, pivot.z + share * length);
            add(
                center,
                Vector3::y(),
                [along(&widths, share) * shrink, high * shrink],
            );
        }
        Vector3::new(pivot.x, 0.5 * along(&heights, 1.0), pivot.z + length)
    }
}
