//! The zones of the body that cloth is beside.

use crate::scene::{Avatar, Limb, LimbAxis};
use nalgebra::Vector3;

/// Distance from the skin of an arm up to which cloth is beside it, and within the width of the
/// shoulders \[m\].
const BESIDE_ARM: f64 = 0.12;
const CLOSE_TO_ARM: f64 = 0.03;
/// Steps along an arm \[m\].
const STEP: f64 = 0.02;
/// Distance from the joint of the shoulder at which the arm begins \[m\].
const FIRST: f64 = 0.05;

/// Levels of the trunk, and the landmarks at their heights.
const LEVELS: [(Zone, &str); 5] = [
    (Zone::Neck, "neck_side_l"),
    (Zone::Shoulders, "shoulder_tip_l"),
    (Zone::Bust, "bust_front"),
    (Zone::Waist, "waist_front"),
    (Zone::Hip, "hip_front"),
];

/// A zone of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Zone {
    Neck,
    Shoulders,
    Bust,
    Waist,
    Hip,
    LeftArm,
    RightArm,
    LeftLeg,
    RightLeg,
}

impl Zone {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Neck => "neck",
            Self::Shoulders => "shoulders",
            Self::Bust => "bust",
            Self::Waist => "waist",
            Self::Hip => "hip",
            Self::LeftArm => "left arm",
            Self::RightArm => "right arm",
            Self::LeftLeg => "left leg",
            Self::RightLeg => "right leg",
        }
    }
}

/// Returns the zone of the body that a point of cloth is beside: an arm, a leg, or the level of the
/// trunk that is nearest in height.
pub(super) fn of(avatar: &Avatar, p: &Vector3<f64>) -> Zone {
    let arms = [
        (Limb::ArmLeft, Zone::LeftArm),
        (Limb::ArmRight, Zone::RightArm),
    ];
    let mut arms = arms.into_iter();
    let is_near = |limb| {
        let axis = avatar.limb(limb);
        axis.is_some_and(|axis| is_beside(avatar, axis, p))
    };
    if let Some((_, zone)) = arms.find(|(limb, _)| is_near(*limb)) {
        return zone;
    }
    let height = |landmark: &str| avatar.landmarks.get(landmark).map(|at| at.y);
    if height("crotch").is_some_and(|crotch| p.y < crotch) {
        return if p.x > 0.0 {
            Zone::LeftLeg
        } else {
            Zone::RightLeg
        };
    }
    let off = |(_, landmark): &(Zone, &str)| {
        height(landmark).map_or(f64::INFINITY, |at| (p.y - at).abs())
    };
    let nearest = LEVELS.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.map_or(Zone::Waist, |(zone, _)| zone)
}

fn is_beside(avatar: &Avatar, axis: &LimbAxis, p: &Vector3<f64>) -> bool {
    let mut along = FIRST;
    let mut nearest = (f64::INFINITY, 0.0);
    while along <= axis.length() {
        let distance = (p - axis.at(along).0).norm();
        if distance < nearest.0 {
            nearest = (distance, along);
        }
        along += STEP;
    }
    let tip = avatar.landmarks.get("shoulder_tip_l");
    let is_outside = tip.is_some_and(|tip| p.x.abs() > tip.x);
    let most = if is_outside { BESIDE_ARM } else { CLOSE_TO_ARM };
    nearest.0 < axis.radius(nearest.1) + most
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DressForm, Limbs};

    #[test]
    fn points_on_the_skin_are_in_their_zones() {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: true,
                legs: true,
            }),
            ..DressForm::default()
        };
        let avatar = form.build().expect("a body");
        for (landmark, expected) in [
            ("neck_side_r", Zone::Neck),
            ("bust_point_l", Zone::Bust),
            ("bust_back", Zone::Bust),
            ("waist_side_r", Zone::Waist),
            ("hip_side_l", Zone::Hip),
        ] {
            assert_eq!(
                of(&avatar, &avatar.landmarks[landmark]),
                expected,
                "{landmark}"
            );
        }
        for (limb, expected) in [
            (Limb::ArmLeft, Zone::LeftArm),
            (Limb::ArmRight, Zone::RightArm),
            (Limb::LegLeft, Zone::LeftLeg),
            (Limb::LegRight, Zone::RightLeg),
        ] {
            let axis = avatar.limb(limb).expect("a limb");
            let along = 0.6 * axis.length();
            let p = axis.at(along).0 + Vector3::z() * axis.radius(along);
            assert_eq!(of(&avatar, &p), expected);
        }
    }
}
