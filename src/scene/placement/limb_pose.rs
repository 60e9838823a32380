//! An arm or a leg as what is rolled about it sees it: a straight tube.

use crate::scene::Avatar;
use crate::scene::avatar::{Limb, LimbAxis};
use nalgebra::{Rotation3, Vector3};

/// Room left between an arm and a sleeve at the start \[m\].
const CLEARANCE: f64 = 0.01;
/// Distance from the axis of an arm at which cloth clears a hand \[m\].
const HAND: f64 = 0.046;
/// A sleeve starts at this angle from the body where that has no arms \[rad\]: so that it clears
/// the sides.
const SPREAD: f64 = 0.7;
/// Tip of the left shoulder of a garment without a body \[m\].
const NO_BODY: Vector3<f64> = Vector3::new(0.19, 1.37, 0.0);
/// Distance from the joint of the shoulder beyond which an arm is apart from the trunk \[m\].
const BESIDE_TRUNK: f64 = 0.1;
/// Steps along an arm at which it is looked at \[m\].
const STEP: f64 = 0.02;

/// The straight line that is nearest to the middle of a limb, as far as what is rolled about it
/// reaches.
#[derive(Clone, Copy, Debug)]
pub(super) struct LimbPose {
    /// Point of the line beside the tip of the shoulder, or the joint of the hip \[m\].
    pub(super) top: Vector3<f64>,
    /// Direction down the limb, of length 1.
    pub(super) direction: Vector3<f64>,
    /// Distance from the line at which cloth clears the limb \[m\].
    pub(super) radius: f64,
    /// Distances at `top` and at the lower end between which a straight line clears all of the limb
    /// beyond the trunk, and a hand below \[m\].
    pub(super) line: [f64; 2],
}

impl LimbPose {
    /// The pose of an arm for a sleeve of this length from the shoulder down \[m\].
    pub(super) fn of(avatar: Option<&Avatar>, limb: Limb, length: f64) -> Self {
        let (side, name) = match limb {
            Limb::ArmRight => (-1.0, "shoulder_tip_r"),
            _ => (1.0, "shoulder_tip_l"),
        };
        let tip = avatar.and_then(|avatar| avatar.landmarks.get(name).copied());
        let tip = tip.unwrap_or_else(|| NO_BODY.component_mul(&Vector3::new(side, 1.0, 1.0)));
        match avatar.and_then(|avatar| avatar.limb(limb)) {
            Some(axis) => {
                let pose = Self::along(axis, &tip, length);
                Self {
                    line: [pose.line[0], pose.line[1].max(HAND)],
                    ..pose
                }
            }
            None => Self {
                top: tip,
                direction: Vector3::new(side * SPREAD.sin(), -SPREAD.cos(), 0.0),
                radius: CLEARANCE,
                line: [CLEARANCE; 2],
            },
        }
    }

    /// The pose of the stretch of a limb of this length \[m\] from beside `point` on, for what is
    /// further down than it is long: a cuff, which is narrower than a sleeve or a leg.
    pub(super) fn beside(
        avatar: &Avatar,
        limb: Limb,
        point: &Vector3<f64>,
        length: f64,
    ) -> Option<Self> {
        let axis = avatar.limb(limb)?;
        let start = nearest(axis, point);
        if start < length {
            return None;
        }
        let end = (start + length).min(axis.length());
        let pose = Self::between(axis, point, [start.min(end - 2.0 * STEP), end]);
        let is_over_hand = start + length > axis.length() + CLEARANCE;
        let least = if is_over_hand { HAND } else { 0.0 };
        Some(Self {
            radius: pose.radius.max(least),
            line: [pose.line[0], pose.line[1].max(least)],
            ..pose
        })
    }

    fn along(axis: &LimbAxis, tip: &Vector3<f64>, length: f64) -> Self {
        let (joint, upper) = axis.at(0.0);
        let first = upper.dot(&(tip - joint));
        let end = (first + length).clamp(STEP, axis.length());
        Self::between(axis, tip, [BESIDE_TRUNK.min(0.5 * end), end])
    }

    /// The pose of the part of a limb between two distances from its joint \[m\], the second of
    /// them the larger one and within its length.
    pub(super) fn between(axis: &LimbAxis, tip: &Vector3<f64>, [start, end]: [f64; 2]) -> Self {
        let count = ((end - start) / STEP).ceil();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the length of an arm over a step"
        )]
        let alongs = (0..=count as usize).map(|k| start + (end - start) * k as f64 / count);
        let middles: Vec<_> = alongs
            .map(|along| (axis.at(along).0, axis.radius(along)))
            .collect();
        let direction = (middles[middles.len() - 1].0 - middles[0].0).normalize();
        let mean = middles.iter().map(|(p, _)| p).sum::<Vector3<f64>>() / middles.len() as f64;
        let off = |p: &Vector3<f64>| {
            let from = p - mean;
            (from - direction * direction.dot(&from)).norm()
        };
        let reach = || {
            middles
                .iter()
                .map(|(p, radius)| off(p) + radius + CLEARANCE)
        };
        let radius = reach().fold(0.0, f64::max);
        let last = (middles.len() - 1) as f64;
        let at_end = |(k, reach): (usize, f64)| radius - (radius - reach) * last / k as f64;
        let end_radius = reach().enumerate().skip(1).map(at_end).fold(0.0, f64::max);
        let top = mean + direction * direction.dot(&(tip - mean));
        let down = |p: &Vector3<f64>| (p - top).dot(&direction);
        let [first, end] = [0, middles.len() - 1].map(|k| down(&middles[k].0));
        Self {
            top,
            direction,
            radius,
            line: [
                radius + (radius - end_radius) * first / (end - first),
                end_radius,
            ],
        }
    }

    /// The turn that takes the upright axis onto the limb's.
    pub(super) fn tilt(&self) -> Rotation3<f64> {
        tilt(&self.direction)
    }
}

/// Returns how far along an axis its point is that is nearest to another one \[m\], within a step.
fn nearest(axis: &LimbAxis, point: &Vector3<f64>) -> f64 {
    let distance = |along: f64| (axis.at(along).0 - point).norm();
    let mut nearest = 0.0;
    let mut along = STEP;
    while along <= axis.length() {
        if distance(along) < distance(nearest) {
            nearest = along;
        }
        along += STEP;
    }
    nearest
}

/// Returns the turn that takes the upright axis onto one that leads down along `direction`.
pub(super) fn tilt(direction: &Vector3<f64>) -> Rotation3<f64> {
    let upright = -Vector3::y();
    Rotation3::rotation_between(&upright, direction)
        .unwrap_or_else(|| Rotation3::new(Vector3::z() * std::f64::consts::PI))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arm that hangs to its elbow and from there points 45 degrees forward.
    fn bent() -> LimbAxis {
        let forward = Vector3::new(0.0, -1.0, 1.0).normalize();
        let [shoulder, elbow] = [1.4, 1.1].map(|y| Vector3::new(0.2, y, 0.0));
        let joints = [shoulder, elbow, elbow + forward * 0.25];
        LimbAxis {
            joints,
            points: joints.to_vec(),
            radii: vec![0.05, 0.045, 0.03],
        }
    }

    #[test]
    fn a_short_sleeve_is_about_the_upper_arm_alone() {
        let tip = Vector3::new(0.2, 1.42, 0.01);
        let pose = LimbPose::along(&bent(), &tip, 0.2);
        assert!((pose.direction + Vector3::y()).norm() < 1e-12);
        assert!((pose.top - Vector3::new(0.2, 1.42, 0.0)).norm() < 1e-12);
        assert!((pose.tilt() * -Vector3::y() - pose.direction).norm() < 1e-12);
    }

    #[test]
    fn a_long_sleeve_clears_all_of_a_bent_arm() {
        let axis = bent();
        let pose = LimbPose::along(&axis, &Vector3::new(0.2, 1.4, 0.0), 0.6);
        assert!(pose.direction.z > 0.2 && pose.direction.x.abs() < 1e-12);
        // From where the arm is apart from the trunk on.
        for k in 10..=55 {
            let along = 0.01 * f64::from(k);
            let from = axis.at(along).0 - pose.top;
            let off = (from - pose.direction * pose.direction.dot(&from)).norm();
            // The middle moves by half a step between two looks at most.
            assert!(off + axis.radius(along) + CLEARANCE <= pose.radius + 0.5 * STEP);
        }
    }
}
