//! The left arm: a tube from the shoulder to the tip of a mitten.

use super::limb::LimbAxis;
use super::proportions::ArmMeasures;
use super::tube::{Frame, Oval, along, steps};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Longest edge along the arm on a body of 1.68 m \[m\].
const STEP: f64 = 0.012;
/// Length of the arm from the shoulder joint on that belongs to the blend into the torso, on a body
/// of 1.68 m \[m\].
const BLEND: f64 = 0.066;
/// Share of the upper arm in the arm's length.
const UPPER: f64 = 0.56;

/// Rings of an arm beyond the blend, the point that closes them, and the axis.
#[derive(Debug)]
pub(super) struct Arm {
    pub(super) rings: Vec<Vec<Vector3<f64>>>,
    pub(super) tip: Vector3<f64>,
    pub(super) axis: LimbAxis,
}

/// The place of an arm on a torso \[m\].
#[derive(Clone, Copy, Debug)]
pub(super) struct ArmRoot {
    /// Tip of the shoulder.
    pub(super) tip: Vector3<f64>,
    /// Point under the arm at which its lower side and the torso's part.
    pub(super) armpit: Vector3<f64>,
    /// Angle from the vertical \[rad\].
    pub(super) angle: f64,
    /// Body height over 1.68 m.
    pub(super) scale: f64,
}

impl Arm {
    pub(super) fn new(root: &ArmRoot, measures: &ArmMeasures, columns: usize) -> Self {
        let (sin, cos) = root.angle.sin_cos();
        let direction = Vector3::new(sin, -cos, 0.0);
        let outward = Vector3::new(cos, sin, 0.0);
        let start = BLEND * root.scale;
        // the lower side passes through the armpit half way along the blend
        let radius = 1.03 * measures.upper_arm / TAU;
        let shoulder = root.armpit + outward * radius - direction * (0.5 * start);
        let upper = elbow_distance(shoulder - root.tip, direction, UPPER * measures.length);
        let fore = (1.0 - UPPER) * measures.length;
        let joints = [0.0, upper, upper + fore].map(|s| shoulder + direction * s);
        let axis = LimbAxis {
            joints,
            points: joints.to_vec(),
            radii: [measures.upper_arm, measures.elbow, measures.wrist]
                .map(|girth| girth / TAU)
                .to_vec(),
        };
        let profile = Profile::new(start, [upper, fore], measures, root.scale);
        let ring = |s: &f64| {
            let frame = Frame {
                center: shoulder + direction * *s,
                outward,
                forward: Vector3::z(),
            };
            profile.oval(*s, columns).ring(&frame, columns)
        };
        Self {
            rings: profile.steps(root.scale).iter().map(ring).collect(),
            tip: shoulder + direction * profile.end,
            axis,
        }
    }
}

/// Returns the distance of the elbow along `direction` from a shoulder joint that is `offset` from
/// the shoulder's tip, for the elbow to be `length` from the tip \[m\].
fn elbow_distance(offset: Vector3<f64>, direction: Vector3<f64>, length: f64) -> f64 {
    let half = offset.dot(&direction);
    let rest = half * half - offset.norm_squared() + length * length;
    -half + rest.max(0.0).sqrt()
}

/// Girth and shape along an arm, by the distance from the shoulder joint \[m\].
struct Profile {
    girths: Vec<[f64; 2]>,
    aspects: Vec<[f64; 2]>,
    /// Distances at which the hand begins to close and at which it ends \[m\].
    rounding: f64,
    end: f64,
}

impl Profile {
    fn new(start: f64, [upper, fore]: [f64; 2], measures: &ArmMeasures, scale: f64) -> Self {
        let wrist = upper + fore;
        let hand = 0.182 * scale;
        let palm = 0.190 * scale.max(0.8 * measures.wrist / 0.155);
        Self {
            girths: vec![
                [start, 1.06 * measures.upper_arm],
                [0.5 * upper, measures.upper_arm],
                [upper, measures.elbow],
                [upper + 0.22 * fore, 1.03 * measures.elbow],
                [wrist, measures.wrist],
                [wrist + 0.42 * hand, palm],
                [wrist + 0.70 * hand, 0.86 * palm],
                [wrist + hand, 0.66 * palm],
            ],
            aspects: vec![
                [start, 0.90],
                [upper, 0.95],
                [upper + 0.22 * fore, 0.92],
                [wrist, 0.74],
                [wrist + 0.42 * hand, 0.40],
                [wrist + hand, 0.36],
            ],
            rounding: wrist + 0.78 * hand,
            end: wrist + hand,
        }
    }

    fn oval(&self, s: f64, columns: usize) -> Oval {
        let close = ((s - self.rounding) / (self.end - self.rounding)).max(0.0);
        let girth = along(&self.girths, s) * (1.0 - close * close).max(0.0).sqrt();
        Oval::of_girth(girth, along(&self.aspects, s), 2.1, columns)
    }

    fn steps(&self, scale: f64) -> Vec<f64> {
        let mut knots: Vec<f64> = self.girths[..5].iter().map(|knot| knot[0]).collect();
        knots.push(self.rounding);
        let mut all = steps(&knots, STEP * scale);
        // evenly round to the end
        all.extend((1..6).map(|i| {
            let angle = FRAC_PI_2 * f64::from(i) / 6.0;
            self.rounding + (self.end - self.rounding) * angle.sin()
        }));
        all
    }
}
