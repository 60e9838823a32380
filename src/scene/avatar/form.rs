//! A tailor's dress form from a few measurements.

use super::torso::{BUST_ANGLE, Scale, Torso, share};
use super::{Avatar, TriangleMesh, rings, slice};
use crate::fault::{Fault, Faults};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};
use utoipa::ToSchema;

/// Rounds of fitting the sections to the measurements; each one leaves a few per cent of the error before.
const ROUNDS: usize = 12;
/// Error of a measurement at which fitting ends \[m\].
const CLOSE: f64 = 2e-5;
/// Parameter of the torso below its shoulders, and steps to it in looking for them.
const SHOULDER_END: f64 = 14.0;
const SHOULDER_STEPS: usize = 2000;

/// Measurements that a dress form is made from \[m\].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct DressForm {
    /// Floor to crown.
    pub height_m: f64,
    /// Girth of the bust.
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
}

impl Default for DressForm {
    /// A woman of 1.68 m in a size M (EN 13402-3: bust 90-98).
    fn default() -> Self {
        Self {
            height_m: 1.68,
            bust_m: 0.92,
            waist_m: 0.74,
            hip_m: 0.98,
            neck_m: None,
            shoulder_m: None,
        }
    }
}

impl DressForm {
    /// Makes the avatar: a closed, smooth torso from the top of the neck to below the crotch, without arms and legs,
    /// whose level girths at bust, waist and hip are those asked for, within 1 mm.
    ///
    /// # Errors
    /// `avatar/measurement`: measurements outside what a person has, each with its pointer (`/height_m`).
    pub fn build(&self) -> Result<Avatar, Faults> {
        Faults(self.check()).or(())?;
        let (torso, surface) = self.fit();
        let mut avatar = Avatar::from_surface("dress form", surface, BTreeMap::new())?;
        for (name, point) in landmarks(&torso, self.height_m) {
            let on_surface = avatar.nearest_point(&point);
            avatar.landmarks.insert(name, on_surface);
        }
        Ok(avatar)
    }

    /// Girth of the neck as given, or what height and bust make likely (0.36 m in a size M).
    fn neck(&self) -> f64 {
        self.neck_m
            .unwrap_or(0.14 * self.height_m + 0.13 * self.bust_m)
    }

    /// Width of the shoulders as given, or what height and bust make likely (0.38 m in a size M).
    fn shoulder(&self) -> f64 {
        self.shoulder_m
            .unwrap_or(0.176 * self.height_m + 0.09 * self.bust_m)
    }

    pub(crate) fn check(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        let mut within = |pointer: &str, value: f64, [least, most]: [f64; 2]| {
            // so written that a NaN is a fault
            if !(least..=most).contains(&value) {
                let detail = format!("{value} m is not the measurement of a person");
                let fix = format!("give metres, {least} to {most} here");
                faults.push(Fault::new("avatar/measurement", pointer, detail).fix(fix));
            }
        };
        within("/height_m", self.height_m, [1.30, 2.10]);
        within("/bust_m", self.bust_m, [0.68, 1.60]);
        within("/waist_m", self.waist_m, [0.50, 1.60]);
        within("/hip_m", self.hip_m, [0.70, 1.70]);
        within("/neck_m", self.neck(), [0.26, 0.56]);
        within("/shoulder_m", self.shoulder(), [0.28, 0.56]);
        if faults.is_empty() {
            faults = self.check_proportions();
        }
        faults
    }

    fn check_proportions(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        let mut ratio = |pointer: &str,
                         [name, base]: [&str; 2],
                         [value, of]: [f64; 2],
                         [least, most]: [f64; 2]| {
            if !(least * of..=most * of).contains(&value) {
                let detail =
                    format!("a {name} of {value} m does not go with a {base} of {of:.3} m");
                let fix = format!(
                    "give {:.3} to {:.3} m, or change the {base}",
                    least * of,
                    most * of
                );
                faults.push(Fault::new("avatar/measurement", pointer, detail).fix(fix));
            }
        };
        ratio(
            "/waist_m",
            ["waist", "hip"],
            [self.waist_m, self.hip_m],
            [0.55, 1.20],
        );
        ratio(
            "/waist_m",
            ["waist", "bust"],
            [self.waist_m, self.bust_m],
            [0.55, 1.15],
        );
        ratio(
            "/hip_m",
            ["hip", "bust"],
            [self.hip_m, self.bust_m],
            [0.75, 1.40],
        );
        ratio(
            "/bust_m",
            ["bust", "height"],
            [self.bust_m, self.height_m],
            [0.42, 0.95],
        );
        ratio(
            "/neck_m",
            ["neck", "bust"],
            [self.neck(), self.bust_m],
            [0.28, 0.52],
        );
        ratio(
            "/shoulder_m",
            ["shoulder", "bust"],
            [self.shoulder(), self.bust_m],
            [0.28, 0.55],
        );
        faults
    }

    /// The torso that meets the measurements, and its mesh.
    fn fit(&self) -> (Torso, TriangleMesh) {
        let height = self.height_m / super::torso::HEIGHT;
        let mut scale = Scale {
            height,
            neck: 1.0,
            shoulder: 1.0,
            bust: 1.0,
            waist: 1.0,
            hip: 1.0,
        };
        let mut torso = Torso::new(scale);
        let mut surface = rings::mesh(&torso);
        for _ in 0..ROUNDS {
            let girth =
                |share: f64| slice::girth(&surface, share * self.height_m).unwrap_or(f64::NAN);
            let [_, tip] = shoulder_line(&torso);
            let pairs = [
                (&mut scale.neck, self.neck(), girth(share::NECK)),
                (&mut scale.shoulder, self.shoulder(), 2.0 * tip[0]),
                (&mut scale.bust, self.bust_m, girth(share::BUST)),
                (&mut scale.waist, self.waist_m, girth(share::WAIST)),
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
            torso = Torso::new(scale);
            surface = rings::mesh(&torso);
        }
        (torso, surface)
    }
}

/// Where the outline seen from the front turns from neck to shoulder and from shoulder to arm: its slope passes
/// 45 degrees there; (x, y) and z of the widest line \[m\].
fn shoulder_line(torso: &Torso) -> [[f64; 3]; 2] {
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

/// The landmarks of a form, near enough to its mesh to be put onto it.
fn landmarks(torso: &Torso, height: f64) -> Vec<(String, Vector3<f64>)> {
    let mut found = Vec::new();
    let mut pair = |name: &str, p: Vector3<f64>| {
        found.push((format!("{name}_l"), p));
        found.push((format!("{name}_r"), Vector3::new(-p.x, p.y, p.z)));
    };
    let section = |share: f64| torso.section(torso.parameter(share * height));
    let at = |share: f64, angle: f64| {
        let [x, z] = section(share).point(angle);
        Vector3::new(x, share * height, z)
    };
    for (name, share) in [
        ("bust", share::BUST),
        ("waist", share::WAIST),
        ("hip", share::HIP),
    ] {
        pair(&format!("{name}_side"), at(share, FRAC_PI_2));
    }
    for (name, [x, y, z]) in ["neck_side", "shoulder_tip"]
        .into_iter()
        .zip(shoulder_line(torso))
    {
        pair(name, Vector3::new(x, y, z));
    }
    pair("armpit", at(share::ARMPIT, FRAC_PI_2));
    pair("bust_point", at(share::BUST, BUST_ANGLE));
    for (name, share, angle) in [
        ("bust_front", share::BUST, 0.0),
        ("bust_back", share::BUST, PI),
        ("waist_front", share::WAIST, 0.0),
        ("waist_back", share::WAIST, PI),
        ("hip_front", share::HIP, 0.0),
        ("hip_back", share::HIP, PI),
        ("neck_front", share::NECK_FRONT, 0.0),
        ("neck_back", share::NECK_BACK, PI),
    ] {
        let mut point = at(share, angle);
        point.x = 0.0;
        found.push((name.to_owned(), point));
    }
    let [y, z] = torso.middle(Torso::END);
    found.push(("crotch".to_owned(), Vector3::new(0.0, y, z)));
    found
}
