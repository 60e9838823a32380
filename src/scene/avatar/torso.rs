//! The smooth torso of a dress form: horizontal sections along a spline.

use super::section::{Bump, Section};
use super::spline::weights;

/// Height of the person that the rows are written for \[m\].
pub(super) const HEIGHT: f64 = 1.68;

/// Heights of the measured places, as shares of the body height.
///
/// Near those of the CC0 `MakeHuman` woman of 1.68 m (bust 0.735, waist 0.651, hip 0.488, neck side
/// 0.851, crotch 0.460), with the waist lowered to where a tailor ties it and the hip 20 cm below
/// it.
pub(super) mod share {
    pub(in super::super) const NECK: f64 = 0.868;
    pub(in super::super) const BUST: f64 = 0.726;
    pub(in super::super) const WAIST: f64 = 0.629;
    pub(in super::super) const HIP: f64 = 0.508;
    pub(in super::super) const ARMPIT: f64 = 0.764;
    pub(in super::super) const NECK_FRONT: f64 = 0.812;
    pub(in super::super) const NECK_BACK: f64 = 0.852;
}

/// Polar angles from +z towards +x at which bust and seat stand out \[rad\].
pub(super) const BUST_ANGLE: f64 = 0.68;
pub(super) const SEAT_ANGLE: f64 = 2.55;

/// Control rows from the top of the neck to the bottom \[m\]: y, half width, z of the widest line,
/// z of the front, z of the back, exponent. Drawn for this project; the surface is their cubic
/// B-spline, so it stays within them.
const ROWS: [[f64; 6]; 35] = [
    [1.500, 0.000, 0.018, 0.018, 0.018, 2.1],
    [1.500, 0.028, 0.018, 0.046, -0.011, 2.1],
    [1.494, 0.050, 0.017, 0.068, -0.035, 2.1],
    [1.476, 0.056, 0.014, 0.070, -0.043, 2.1],
    [1.455, 0.056, 0.010, 0.065, -0.048, 2.1],
    [1.437, 0.059, 0.006, 0.061, -0.055, 2.1],
    [1.424, 0.069, 0.001, 0.060, -0.064, 2.1],
    [1.414, 0.088, -0.004, 0.062, -0.073, 2.1],
    [1.404, 0.115, -0.008, 0.065, -0.081, 2.1],
    [1.394, 0.142, -0.011, 0.068, -0.088, 2.15],
    [1.383, 0.167, -0.012, 0.073, -0.095, 2.2],
    [1.367, 0.184, -0.012, 0.079, -0.101, 2.25],
    [1.344, 0.188, -0.010, 0.086, -0.107, 2.3],
    [1.317, 0.183, -0.007, 0.092, -0.111, 2.35],
    [1.287, 0.174, -0.004, 0.097, -0.113, 2.35],
    [1.255, 0.165, 0.000, 0.101, -0.112, 2.3],
    [1.220, 0.158, 0.003, 0.103, -0.107, 2.3],
    [1.180, 0.150, 0.005, 0.102, -0.098, 2.25],
    [1.140, 0.141, 0.007, 0.099, -0.087, 2.2],
    [1.100, 0.133, 0.009, 0.096, -0.076, 2.2],
    [1.060, 0.128, 0.010, 0.094, -0.069, 2.2],
    [1.020, 0.135, 0.009, 0.097, -0.074, 2.2],
    [0.980, 0.149, 0.006, 0.102, -0.088, 2.2],
    [0.940, 0.162, 0.002, 0.105, -0.101, 2.25],
    [0.900, 0.172, -0.001, 0.105, -0.111, 2.3],
    [0.860, 0.178, -0.004, 0.101, -0.116, 2.3],
    [0.820, 0.180, -0.006, 0.096, -0.115, 2.3],
    [0.780, 0.178, -0.006, 0.092, -0.108, 2.3],
    [0.745, 0.173, -0.006, 0.088, -0.101, 2.3],
    [0.715, 0.165, -0.006, 0.082, -0.095, 2.3],
    [0.693, 0.150, -0.006, 0.071, -0.084, 2.3],
    [0.680, 0.125, -0.006, 0.057, -0.069, 2.25],
    [0.674, 0.090, -0.006, 0.038, -0.050, 2.2],
    [0.672, 0.048, -0.006, 0.017, -0.029, 2.1],
    [0.672, 0.000, -0.006, -0.006, -0.006, 2.1],
];

/// Height of the waist in the rows \[m\].
pub(super) const WAIST_Y: f64 = share::WAIST * HEIGHT;

/// Half widths of a torso with arms, in place of those of the rows of these heights \[m\]: without
/// the stumps of arms.
const WITH_ARMS: [[f64; 2]; 8] = [
    [1.367, 0.181],
    [1.344, 0.178],
    [1.317, 0.170],
    [1.287, 0.161],
    [1.255, 0.155],
    [1.220, 0.152],
    [1.180, 0.147],
    [1.140, 0.140],
];

/// Kinds of torsos.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Shape {
    /// No bust.
    pub(super) men: bool,
    /// Arms grow from it.
    pub(super) arms: bool,
}

/// By how much the sections are wider than the rows say, at the measured places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    pub(super) height: f64,
    pub(super) neck: f64,
    pub(super) shoulder: f64,
    pub(super) bust: f64,
    pub(super) waist: f64,
    pub(super) hip: f64,
    /// By how much the waist is higher, before the height's scale \[m\].
    pub(super) waist_shift: f64,
}

/// Sections along a parameter from 0 (top) to [`Torso::END`] (bottom).
#[derive(Clone, Debug)]
pub(super) struct Torso {
    /// y, half width, z of the widest line, depth before it, depth behind it, exponent; a row more
    /// at each end.
    rows: Vec<[f64; 6]>,
    scale: Scale,
    shape: Shape,
}

impl Torso {
    /// Largest parameter.
    pub(super) const END: f64 = (ROWS.len() - 1) as f64;

    pub(super) fn new(scale: Scale, shape: Shape) -> Self {
        let rows = ROWS.iter().map(|row| shape.adapt(*row));
        let mut rows: Vec<_> = rows.map(|row| scale.apply(&row)).collect();
        // the rows go on mirrored beyond each pole, which makes it round and its tangent plane
        // level
        let beyond =
            |[y, half, centre, front, back, n]: [f64; 6]| [y, -half, centre, -front, -back, n];
        rows.insert(0, beyond(rows[1]));
        rows.push(beyond(rows[rows.len() - 2]));
        Self { rows, scale, shape }
    }

    fn row(&self, t: f64) -> [f64; 6] {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to the number of rows"
        )]
        let cell = (t.clamp(0.0, Self::END) as usize).min(self.rows.len() - 4);
        let weights = weights(t - cell as f64);
        let mut row = [0.0; 6];
        for (weight, control) in weights.iter().zip(&self.rows[cell..]) {
            for (sum, value) in row.iter_mut().zip(control) {
                *sum += weight * value;
            }
        }
        row
    }

    /// Returns its size against size M, as the mean of its measured scales.
    pub(super) fn size(&self) -> f64 {
        let Scale {
            height,
            bust,
            waist,
            hip,
            ..
        } = self.scale;
        0.25 * (height + bust + waist + hip)
    }

    /// The section at a parameter strictly between the poles.
    pub(super) fn section(&self, t: f64) -> Section {
        let [y, half_width, centre, front, back, exponent] = self.row(t);
        Section {
            y,
            half_width,
            centre,
            front,
            back,
            exponent,
            bumps: self.bumps(y),
        }
    }

    /// The point (y, z) of the middle at a pole or anywhere between \[m\].
    pub(super) fn middle(&self, t: f64) -> [f64; 2] {
        let row = self.row(t);
        [row[0], row[2]]
    }

    /// The parameter of the section at height `y`, found by halving.
    pub(super) fn parameter(&self, y: f64) -> f64 {
        let (mut above, mut below) = (0.0, Self::END);
        for _ in 0..60 {
            let t = 0.5 * (above + below);
            if self.row(t)[0] > y {
                above = t;
            } else {
                below = t;
            }
        }
        0.5 * (above + below)
    }

    fn bumps(&self, y: f64) -> [Bump; 2] {
        let bell = |at: f64, spread: f64| {
            let off = (y / self.scale.height - at) / spread;
            (-0.5 * off * off).exp()
        };
        let bust = if self.shape.men {
            Bump {
                height: 0.006 * self.scale.bust * bell(1.245, 0.060),
                angle: BUST_ANGLE,
                spread: 0.45,
            }
        } else {
            Bump {
                height: 0.030 * self.scale.bust * bell(1.212, 0.046),
                angle: BUST_ANGLE,
                spread: 0.35,
            }
        };
        let seat_height = if self.shape.men { 0.012 } else { 0.018 };
        let seat = Bump {
            height: seat_height * self.scale.hip * bell(0.838, 0.055),
            angle: SEAT_ANGLE,
            spread: 0.42,
        };
        [bust, seat]
    }
}

impl Shape {
    /// The row of such a torso in size M.
    fn adapt(self, mut row: [f64; 6]) -> [f64; 6] {
        let with_arms = WITH_ARMS.iter().find(|[y, _]| *y == row[0]);
        if let (true, Some([_, half])) = (self.arms, with_arms) {
            row[1] = *half;
        }
        row
    }
}

impl Scale {
    /// Height of a row \[m\]; the waist's shift is felt from hip to bust.
    fn height_of(&self, y: f64) -> f64 {
        let end = if y > WAIST_Y { 1.220 } else { 0.860 };
        let share = ((end - y) / (end - WAIST_Y)).clamp(0.0, 1.0);
        let moved = share * share * (3.0 - 2.0 * share) * self.waist_shift;
        (y + moved) * self.height
    }

    /// The row of a body of this scale, with depths in place of z.
    fn apply(&self, &[y, half, centre, front, back, exponent]: &[f64; 6]) -> [f64; 6] {
        let depth = self.between(y, 0.5 * (self.neck + self.bust));
        [
            self.height_of(y),
            half * self.between(y, self.shoulder),
            centre * depth,
            (front - centre) * depth,
            (centre - back) * depth,
            exponent,
        ]
    }

    /// The scale at the height of a row: a cubic between the measured places, level at each, so
    /// that none shows as a roll.
    fn between(&self, y: f64, shoulder: f64) -> f64 {
        let places = [
            (1.437, self.neck),
            (1.368, shoulder),
            (1.220, self.bust),
            (1.060, self.waist),
            (0.860, self.hip),
        ];
        let first = places[0];
        let last = places[places.len() - 1];
        if y >= first.0 {
            return first.1;
        }
        places
            .windows(2)
            .find(|pair| y >= pair[1].0)
            .map_or(last.1, |pair| {
                let s = (pair[0].0 - y) / (pair[0].0 - pair[1].0);
                pair[0].1 + s * s * (3.0 - 2.0 * s) * (pair[1].1 - pair[0].1)
            })
    }
}
