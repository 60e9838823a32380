//! The ends of a body, head, hands and feet, and what a closed curve about it goes round: those
//! that it parts from the others.

use super::linking::passes;
use crate::scene::{Avatar, is_head};
use nalgebra::Vector3;
use std::fmt;

/// Distance at which a path that leaves the body ends \[m\]: beyond any cloth.
const FAR: f64 = 50.0;
/// Place of the joint between the tip of the shoulder and the armpit, as a share of the way.
const JOINT: f64 = 0.4;
/// Place of a leg's middle between the middle and the side of the hip, as a share of the way.
const LEG: f64 = 0.5;

/// Number of ends of a body.
const ENDS: usize = 5;

/// Parts of the body that an opening of a garment goes round.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Encircled {
    /// Nothing: the opening is beside the body, or in the cloth.
    Nothing,
    /// The neck, or the head.
    Neck,
    /// The left arm.
    LeftArm,
    /// The right arm.
    RightArm,
    /// The left leg.
    LeftLeg,
    /// The right leg.
    RightLeg,
    /// The trunk, with the legs on one side and head and arms on the other.
    Trunk,
    /// Both arms, as the edge of an open jacket does.
    BothArms,
    /// The head and the left arm, over the right shoulder or under it.
    NeckAndLeftArm,
    /// The head and the right arm.
    NeckAndRightArm,
    /// Parts of the body that no opening is for, or one of them more than once.
    Other,
}

impl fmt::Display for Encircled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nothing => "nothing",
            Self::Neck => "the neck",
            Self::LeftArm => "the left arm",
            Self::RightArm => "the right arm",
            Self::LeftLeg => "the left leg",
            Self::RightLeg => "the right leg",
            Self::Trunk => "the trunk",
            Self::BothArms => "both arms",
            Self::NeckAndLeftArm => "the neck and the left arm",
            Self::NeckAndRightArm => "the neck and the right arm",
            Self::Other => "parts of the body that do not go through one opening",
        })
    }
}

/// Paths from the middle of a body out of each of its ends: head, left and right arm, left and
/// right leg.
#[derive(Clone, Debug)]
pub(super) struct BodyEnds {
    paths: [Vec<Vector3<f64>>; ENDS],
    has_arms: bool,
    has_legs: bool,
    /// Height of the top of a body without a head \[m\].
    headless_top: Option<f64>,
}

impl BodyEnds {
    /// Returns the ends of a body; none if it lacks landmarks. Limbs that it does not have are
    /// where those of a body would be.
    pub(super) fn new(avatar: &Avatar) -> Option<Self> {
        let at = |name: &str| avatar.landmarks.get(name).copied();
        let middle = |a: &str, b: &str| Some((at(a)? + at(b)?) * 0.5);
        let hub = middle("waist_front", "waist_back")?;
        let chest = middle("armpit_l", "armpit_r")?;
        let neck = middle("neck_front", "neck_back")?;
        let arm = |side: &str, x: f64| {
            let joint = at(&format!("shoulder_joint_{side}")).or_else(|| {
                let tip = at(&format!("shoulder_tip_{side}"))?;
                Some(tip + (at(&format!("armpit_{side}"))? - tip) * JOINT)
            })?;
            let joints = ["elbow", "wrist"].map(|name| at(&format!("{name}_{side}")));
            // Level where the body has none: beside whatever hangs from the shoulders.
            Some(path(&[hub, chest, joint], &joints, Vector3::x() * x))
        };
        let leg = |side: &str| {
            let joint = at(&format!("hip_joint_{side}")).or_else(|| {
                let side = at(&format!("hip_side_{side}"))?;
                let crotch = at("crotch")?;
                Some(Vector3::new(
                    LEG * side.x,
                    crotch.y.max(0.5 * side.y),
                    side.z,
                ))
            })?;
            let joints = ["knee", "ankle"].map(|name| at(&format!("{name}_{side}")));
            Some(path(&[hub, joint], &joints, -Vector3::y()))
        };
        let [foot, top] = avatar.heights();
        let above_neck = top - at("neck_side_l").map_or(neck.y, |side| side.y);
        Some(Self {
            paths: [
                path(&[hub, neck], &[], Vector3::y()),
                arm("l", 1.0)?,
                arm("r", -1.0)?,
                leg("l")?,
                leg("r")?,
            ],
            has_arms: at("elbow_l").is_some(),
            has_legs: at("knee_l").is_some(),
            headless_top: (!is_head(above_neck, top - foot)).then_some(top),
        })
    }

    /// Returns true if the body has what `encircled` says, so that cloth is kept on it.
    pub(super) fn has(&self, encircled: Encircled) -> bool {
        match encircled {
            Encircled::Nothing | Encircled::Other => false,
            Encircled::Neck | Encircled::Trunk => true,
            Encircled::LeftArm
            | Encircled::RightArm
            | Encircled::BothArms
            | Encircled::NeckAndLeftArm
            | Encircled::NeckAndRightArm => self.has_arms,
            Encircled::LeftLeg | Encircled::RightLeg => self.has_legs,
        }
    }

    /// Returns true if some of `curve` is where a body without a head would have one.
    pub(super) fn reaches_a_missing_head(&self, curve: &[Vector3<f64>]) -> bool {
        let top = self.headless_top;
        top.is_some_and(|top| curve.iter().any(|p| p.y > top))
    }

    /// Returns what the closed polygon `curve` goes round.
    pub(super) fn encircled(&self, curve: &[Vector3<f64>]) -> Encircled {
        let passes = self.paths.each_ref().map(|path| passes(path, curve));
        // As many ends are on one side as are not on the other: the side of fewer ends names it.
        let mut sides = passes.to_vec();
        sides.sort_unstable();
        sides.dedup();
        let [low, high] = match sides[..] {
            [_] => return Encircled::Nothing,
            [low, high] if high - low == 1 => [low, high],
            _ => return Encircled::Other,
        };
        let is_in = |side: i32| passes.map(|passes| passes == side);
        let count = |side: [bool; ENDS]| side.iter().filter(|is_in| **is_in).count();
        let side = [is_in(low), is_in(high)]
            .into_iter()
            .min_by_key(|side| count(*side));
        named(side.unwrap_or_default())
    }
}

/// Returns the path through `trunk` and the joints of a limb, then on out of its end, in the
/// direction of its last bone or, without one, in `direction`.
fn path(
    trunk: &[Vector3<f64>],
    joints: &[Option<Vector3<f64>>],
    direction: Vector3<f64>,
) -> Vec<Vector3<f64>> {
    let mut path = trunk.to_vec();
    path.extend(joints.iter().flatten());
    let direction = match path[..] {
        [.., a, b] if path.len() > trunk.len() => (b - a).normalize(),
        _ => direction,
    };
    let last = path[path.len() - 1];
    path.push(last + direction * FAR);
    path
}

/// Returns the name of a set of at most two ends: head, left and right arm, left and right leg.
fn named(ends: [bool; ENDS]) -> Encircled {
    match ends {
        [true, false, false, false, false] => Encircled::Neck,
        [false, true, false, false, false] => Encircled::LeftArm,
        [false, false, true, false, false] => Encircled::RightArm,
        [false, false, false, true, false] => Encircled::LeftLeg,
        [false, false, false, false, true] => Encircled::RightLeg,
        [false, false, false, true, true] => Encircled::Trunk,
        [false, true, true, false, false] => Encircled::BothArms,
        [true, true, false, false, false] => Encircled::NeckAndLeftArm,
        [true, false, true, false, false] => Encircled::NeckAndRightArm,
        _ => Encircled::Other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::DressForm;
    use std::f64::consts::TAU;

    /// A circle about `center` across `axis` \[m\].
    fn circle(center: Vector3<f64>, axis: Vector3<f64>, radius: f64) -> Vec<Vector3<f64>> {
        let across = axis.cross(&Vector3::z()).normalize();
        let other = across.cross(&axis).normalize();
        let point = |i: i32| {
            let (sin, cos) = (TAU * f64::from(i) / 50.0).sin_cos();
            center + (across * cos + other * sin) * radius
        };
        (0..50).map(point).collect()
    }

    #[test]
    fn circles_about_the_parts_of_a_body_are_told_apart() {
        let avatar = DressForm::default().build().expect("a body");
        let ends = BodyEnds::new(&avatar).expect("landmarks");
        let at = |name: &str| avatar.landmarks[name];
        let up = Vector3::y();
        let on_axis = |y: f64| Vector3::new(0.0, y, 0.0);
        let neck = circle(on_axis(at("neck_side_l").y), up, 0.1);
        assert_eq!(ends.encircled(&neck), Encircled::Neck);
        for height in ["waist_front", "bust_front", "hip_front"] {
            let round = circle(on_axis(at(height).y), up, 0.3);
            assert_eq!(ends.encircled(&round), Encircled::Trunk, "{height}");
        }
        for (side, x, arm) in [
            ("l", 1.0, Encircled::LeftArm),
            ("r", -1.0, Encircled::RightArm),
        ] {
            let outward = Vector3::x() * x;
            let armhole = circle(at(&format!("shoulder_tip_{side}")), outward, 0.12);
            assert_eq!(ends.encircled(&armhole), arm);
        }
        let crotch = at("crotch").y;
        for (x, leg) in [(0.12, Encircled::LeftLeg), (-0.12, Encircled::RightLeg)] {
            let knee = Vector3::new(x, 0.5 * crotch, 0.0);
            assert_eq!(ends.encircled(&circle(knee, up, 0.1)), leg);
        }
    }

    #[test]
    fn what_is_beside_the_body_or_twice_round_it_is_told() {
        let avatar = DressForm::default().build().expect("a body");
        let ends = BodyEnds::new(&avatar).expect("landmarks");
        let up = Vector3::y();
        let beside = circle(Vector3::new(0.0, 1.0, 1.0), up, 0.2);
        assert_eq!(ends.encircled(&beside), Encircled::Nothing);
        let waist = circle(
            Vector3::new(0.0, avatar.landmarks["waist_front"].y, 0.0),
            up,
            0.3,
        );
        let mut twice = waist.clone();
        twice.extend(waist.iter().map(|p| p * 1.01));
        assert_eq!(ends.encircled(&twice), Encircled::Other);
    }
}
