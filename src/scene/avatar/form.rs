//! A tailor's dress form from a few measurements.

use super::torso::{Scale, Shape, Torso, share};
use super::{TriangleMesh, rings, slice};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Rounds of fitting the sections to the measurements; each one leaves a few per cent of the error
/// before.
const ROUNDS: usize = 12;
/// Error of a measurement at which fitting ends \[m\].
const CLOSE: f64 = 2e-5;
/// Parameter of the torso below its shoulders, and steps to it in looking for them.
const SHOULDER_END: f64 = 14.0;
const SHOULDER_STEPS: usize = 2000;

/// Body that a dress form is shaped after.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sex {
    /// A woman's, with a bust.
    #[default]
    Women,
    /// A man's: `bust_m` is the girth of the chest.
    Men,
}

/// Angle of the arms from the vertical.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Pose {
    /// 40 degrees.
    #[default]
    A,
    /// 90 degrees.
    T,
    /// 12 degrees.
    I,
}

/// Parts of the body that a dress form has besides the torso.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Limbs {
    /// Arms with mittens for hands.
    #[serde(default)]
    pub arms: bool,
    /// Legs with feet on the floor.
    #[serde(default)]
    pub legs: bool,
}

/// Measurements that a dress form is made from \[m\].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct DressForm {
    /// Floor to crown.
    pub height_m: f64,
    /// Girth of the bust, of the chest of men.
    pub bust_m: f64,
    /// Girth of the waist.
    pub waist_m: f64,
    /// Girth of the hip.
    pub hip_m: f64,
    /// Girth of the neck, level, half way up the stump; from height and bust where not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub neck_m: Option<f64>,
    /// Width between the shoulder tips; from height and bust where not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shoulder_m: Option<f64>,
    /// Body that it is shaped after.
    #[serde(default, skip_serializing_if = "is_default")]
    pub sex: Sex,
    /// Angle of the arms.
    #[serde(default, skip_serializing_if = "is_default")]
    pub pose: Pose,
    /// Parts besides the torso; where not given, those that panels of the garment start near.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limbs: Option<Limbs>,
    /// Height of the waist above the floor; from the height where not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub waist_height_m: Option<f64>,
    /// Height of the crotch above the floor; from the height where not given, as all below.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inside_leg_m: Option<f64>,
    /// Girth of the thigh, 3 cm under the crotch on a body of 1.68 m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thigh_m: Option<f64>,
    /// Girth of the knee.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub knee_m: Option<f64>,
    /// Largest girth between knee and ankle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calf_m: Option<f64>,
    /// Girth above the ankle bones.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ankle_m: Option<f64>,
    /// Tip of the shoulder to elbow to wrist.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arm_length_m: Option<f64>,
    /// Girth of the arm half way from the shoulder joint to the elbow.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper_arm_m: Option<f64>,
    /// Girth of the elbow.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub elbow_m: Option<f64>,
    /// Girth of the wrist.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wrist_m: Option<f64>,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Default for DressForm {
    /// A woman of 1.68 m in a size M (EN 13402-3: bust 90-98).
    fn default() -> Self {
        Self::new(1.68, 0.92, 0.74, 0.98)
    }
}

impl DressForm {
    /// The torso of a woman of these measures \[m\], the others from them.
    pub const fn new(height_m: f64, bust_m: f64, waist_m: f64, hip_m: f64) -> Self {
        Self {
            height_m,
            bust_m,
            waist_m,
            hip_m,
            neck_m: None,
            shoulder_m: None,
            sex: Sex::Women,
            pose: Pose::A,
            limbs: None,
            waist_height_m: None,
            inside_leg_m: None,
            thigh_m: None,
            knee_m: None,
            calf_m: None,
            ankle_m: None,
            arm_length_m: None,
            upper_arm_m: None,
            elbow_m: None,
            wrist_m: None,
        }
    }

    fn shape(&self) -> Shape {
        let limbs = self.limbs.unwrap_or_default();
        Shape {
            men: self.sex == Sex::Men,
            arms: limbs.arms,
        }
    }

    /// The torso that meets the measurements, and its mesh.
    pub(super) fn fit(&self) -> (Torso, TriangleMesh) {
        let height = self.height_m / super::torso::HEIGHT;
        let mut scale = Scale {
            height,
            neck: 1.0,
            shoulder: 1.0,
            bust: 1.0,
            waist: 1.0,
            hip: 1.0,
            waist_shift: self.value("waist_height_m") / height - super::torso::WAIST_Y,
        };
        let shape = self.shape();
        let waist = self.value("waist_height_m") / self.height_m;
        let [neck, shoulder] = ["neck_m", "shoulder_m"].map(|field| self.value(field));
        let mut torso = Torso::new(scale, shape);
        let mut surface = rings::mesh(&torso);
        for _ in 0..ROUNDS {
            let girth =
                |share: f64| slice::girth(&surface, share * self.height_m).unwrap_or(f64::NAN);
            let [_, tip] = shoulder_line(&torso);
            let pairs = [
                (&mut scale.neck, neck, girth(share::NECK)),
                (&mut scale.shoulder, shoulder, 2.0 * tip[0]),
                (&mut scale.bust, self.bust_m, girth(share::BUST)),
                (&mut scale.waist, self.waist_m, girth(waist)),
                (&mut scale.hip, self.hip_m, girth(share::HIP)),
            ];
            let mut worst = 0.0_f64;
            for (scale, asked, found) in pairs {
                *scale *= asked / found;
                worst = worst.max((asked - found).abs());
            }
            if worst < CLOSE {
                break;
            }
            torso = Torso::new(scale, shape);
            surface = rings::mesh(&torso);
        }
        (torso, surface)
    }
}

/// Returns the points at which the outline seen from the front turns from neck to shoulder and from
/// shoulder to arm, its slope passing 45 degrees: (x, y) and z of the widest line \[m\].
pub(super) fn shoulder_line(torso: &Torso) -> [[f64; 3]; 2] {
    let steps = 0..SHOULDER_STEPS;
    let point = |i: usize| {
        let t = SHOULDER_END * (i + 1) as f64 / SHOULDER_STEPS as f64;
        let section = torso.section(t);
        [section.half_width, section.y, section.centre]
    };
    let outward = |i: &usize| {
        let (here, next) = (point(*i), point(i + 1));
        next[0] - here[0] > here[1] - next[1]
    };
    // the top of the neck is level too: begin where its outline stands upright
    let upright = steps.clone().find(|i| !outward(i)).unwrap_or(0);
    let neck = (upright..steps.end).find(outward).unwrap_or(upright);
    let tip = (neck..steps.end).find(|i| !outward(i)).unwrap_or(neck);
    [point(neck), point(tip)]
}

#[cfg(test)]
mod tests {
    use super::super::LANDMARKS;
    use super::*;

    const fn form(height_m: f64, bust_m: f64, waist_m: f64, hip_m: f64) -> DressForm {
        DressForm::new(height_m, bust_m, waist_m, hip_m)
    }

    /// The smallest to the largest of EN 13402-3 and of people, slim, round, and of uncommon
    /// proportions.
    const FORMS: [DressForm; 7] = [
        form(1.68, 0.92, 0.74, 0.98),
        form(1.50, 0.76, 0.58, 0.82),
        form(1.84, 0.80, 0.62, 0.88),
        form(1.60, 1.10, 0.94, 1.12),
        form(1.72, 1.40, 1.30, 1.44),
        form(1.64, 0.90, 0.86, 0.90),
        form(1.64, 0.88, 0.66, 1.12),
    ];

    #[test]
    fn girths_are_those_asked_for_within_a_millimeter() {
        for form in FORMS {
            let (_, surface) = form.fit();
            for (share, asked) in [
                (share::NECK, form.value("neck_m")),
                (share::BUST, form.bust_m),
                (share::WAIST, form.waist_m),
                (share::HIP, form.hip_m),
            ] {
                let girth = slice::girth(&surface, share * form.height_m).expect("a slice");
                assert!(
                    (girth - asked).abs() < 1e-3,
                    "{girth} for {asked} of {form:?}"
                );
            }
        }
    }

    #[test]
    fn every_form_is_closed_fine_and_symmetric() {
        for form in FORMS {
            let (_, surface) = form.fit();
            assert_eq!(surface.check(), [], "{form:?}");
            let count = surface.triangles.len();
            assert!((5_000..=18_000).contains(&count), "{count} of {form:?}");
            // a closed surface without handles (Euler)
            assert_eq!(surface.vertices.len(), count / 2 + 2);
            let mirror: f64 = surface.vertices.iter().map(|v| v.x).sum();
            assert!(mirror.abs() < 1e-9);
        }
    }

    #[test]
    fn own_neck_and_shoulders_are_met() {
        let form = DressForm {
            neck_m: Some(0.40),
            shoulder_m: Some(0.42),
            ..DressForm::default()
        };
        let (torso, surface) = form.fit();
        let girth = slice::girth(&surface, share::NECK * form.height_m).expect("a slice");
        assert!((girth - 0.40).abs() < 1e-3, "{girth}");
        let [_, tip] = shoulder_line(&torso);
        assert!((2.0 * tip[0] - 0.42).abs() < 1e-3, "{tip:?}");
    }

    #[test]
    fn every_landmark_is_on_the_surface_on_its_side() {
        let avatar = DressForm::default().build().expect("size M");
        assert!(avatar.landmarks.keys().map(String::as_str).eq(LANDMARKS));
        for (name, p) in &avatar.landmarks {
            assert!(avatar.exact_distance(p).abs() < 1e-9, "{name}");
            let side = [("_l", 1.0), ("_r", -1.0)]
                .iter()
                .find(|(end, _)| name.ends_with(end))
                .map_or(0.0, |(_, side)| *side);
            assert!(
                p.x * side > 0.0 || (side == 0.0 && p.x.abs() < 1e-6),
                "{name} {p}"
            );
        }
        let at = |name: &str| avatar.landmarks[name];
        assert!(at("bust_front").z > at("bust_back").z + 0.15);
        let (neck, tip) = (at("neck_side_l"), at("shoulder_tip_l"));
        let slope = ((neck.y - tip.y) / (tip.x - neck.x)).atan().to_degrees();
        assert!((15.0..30.0).contains(&slope), "shoulders slope by {slope}");
    }

    #[test]
    fn the_waist_is_the_narrowest_place_of_a_usual_form() {
        let form = DressForm::default();
        let (_, surface) = form.fit();
        let girth = |y: f64| slice::girth(&surface, y).expect("a slice");
        let waist = share::WAIST * form.height_m;
        for off in [-0.15, -0.10, -0.05, 0.05, 0.10, 0.15] {
            assert!(girth(waist + off) > girth(waist), "{off}");
        }
    }

    #[test]
    fn every_measurement_that_no_person_has_is_named() {
        let pointers = |form: DressForm| -> Vec<String> {
            let faults = form.build().expect_err("refused");
            assert!(faults.0.iter().all(|f| f.fix.is_some()));
            faults.0.into_iter().map(|f| f.pointer).collect()
        };
        let centimeters = form(168.0, 92.0, 74.0, 98.0);
        let all = ["/height_m", "/bust_m", "/waist_m", "/hip_m"];
        assert_eq!(pointers(centimeters), all);
        assert_eq!(pointers(form(1.68, 0.92, 1.25, 0.98)), ["/waist_m"; 2]);
        assert_eq!(pointers(form(1.68, f64::NAN, 0.74, 0.98)), ["/bust_m"]);
        let narrow = DressForm {
            shoulder_m: Some(-0.4),
            ..DressForm::default()
        };
        assert_eq!(pointers(narrow), ["/shoulder_m"]);
    }

    #[test]
    fn a_misspelt_measurement_is_refused() {
        let json =
            r#"{"height_m":1.68,"bust_m":0.92,"waist_m":0.74,"hip_m":0.98,"neckline_m":0.3}"#;
        assert!(serde_json::from_str::<DressForm>(json).is_err());
    }
}
