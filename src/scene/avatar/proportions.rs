//! Measures of a dress form that are not given, from those that are.
//!
//! The shares lie between those of two CC0 bodies of `MakeHuman`, a woman of 1.68 m and a man of
//! 1.78 m, and common size tables where those bodies are thin (ankle, wrist).

use super::form::{DressForm, Sex};
use super::measures;

/// Measures of an arm \[m\].
#[derive(Clone, Copy, Debug)]
pub(super) struct ArmMeasures {
    /// Tip of the shoulder to elbow to wrist.
    pub(super) length: f64,
    pub(super) upper_arm: f64,
    pub(super) elbow: f64,
    pub(super) wrist: f64,
}

/// Measures of a leg \[m\].
#[derive(Clone, Copy, Debug)]
pub(super) struct LegMeasures {
    /// Height of the body.
    pub(super) height: f64,
    pub(super) inside: f64,
    pub(super) thigh: f64,
    pub(super) knee: f64,
    pub(super) calf: f64,
    pub(super) ankle: f64,
}

impl DressForm {
    /// Returns the measure of this field as given.
    pub(super) fn given(&self, field: &str) -> Option<f64> {
        match field {
            "height_m" => Some(self.height_m),
            "bust_m" => Some(self.bust_m),
            "waist_m" => Some(self.waist_m),
            "hip_m" => Some(self.hip_m),
            "neck_m" => self.neck_m,
            "shoulder_m" => self.shoulder_m,
            "waist_height_m" => self.waist_height_m,
            "inside_leg_m" => self.inside_leg_m,
            "thigh_m" => self.thigh_m,
            "knee_m" => self.knee_m,
            "calf_m" => self.calf_m,
            "ankle_m" => self.ankle_m,
            "arm_length_m" => self.arm_length_m,
            "upper_arm_m" => self.upper_arm_m,
            "elbow_m" => self.elbow_m,
            "wrist_m" => self.wrist_m,
            _ => None,
        }
    }

    /// Returns the measure of this field, as given or as the others make it likely \[m\].
    pub(super) fn value(&self, field: &str) -> f64 {
        self.given(field)
            .unwrap_or_else(|| measures::clamp(self, field, self.derived(field)))
    }

    fn derived(&self, field: &str) -> f64 {
        let (height, bust, hip) = (self.height_m, self.bust_m, self.hip_m);
        let men = self.sex == Sex::Men;
        match field {
            // 0.36 m in a women's size M
            "neck_m" if men => 0.14 * height + 0.145 * bust,
            "neck_m" => 0.14 * height + 0.13 * bust,
            // 0.37 m in a women's size M
            "shoulder_m" if men => 0.175 * height + 0.10 * bust,
            "shoulder_m" => 0.170 * height + 0.09 * bust,
            "waist_height_m" => super::torso::share::WAIST * height,
            "inside_leg_m" if men => 0.466 * height,
            "inside_leg_m" => 0.460 * height,
            "thigh_m" => 0.565 * hip,
            "knee_m" => 0.12 * height + 0.145 * hip,
            "calf_m" => 0.12 * height + 0.152 * hip,
            "ankle_m" => 0.10 * height + 0.045 * hip,
            "arm_length_m" => 0.335 * height,
            "upper_arm_m" => 0.31 * bust,
            "elbow_m" => 0.06 * height + 0.16 * bust,
            "wrist_m" => 0.06 * height + 0.06 * bust,
            _ => f64::NAN,
        }
    }

    pub(super) fn arm_measures(&self) -> ArmMeasures {
        ArmMeasures {
            length: self.value("arm_length_m"),
            upper_arm: self.value("upper_arm_m"),
            elbow: self.value("elbow_m"),
            wrist: self.value("wrist_m"),
        }
    }

    pub(super) fn leg_measures(&self) -> LegMeasures {
        LegMeasures {
            height: self.height_m,
            inside: self.value("inside_leg_m"),
            thigh: self.value("thigh_m"),
            knee: self.value("knee_m"),
            calf: self.value("calf_m"),
            ankle: self.value("ankle_m"),
        }
    }
}
