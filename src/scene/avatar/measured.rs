//! Measures taken on a body, by the rules that a form's are made by.

use super::limb::Limb;
use super::{Avatar, slice};
use std::collections::BTreeMap;

/// Depth of the thigh's girth under the crotch \[m\].
const THIGH: f64 = 0.02;
/// Steps in which the largest girth of the calf and the least of the ankle are looked for.
const STEPS: usize = 24;

impl Avatar {
    /// Returns the girths of the body \[m\], named as in a form: `bust_m`; those of parts that it
    /// has. Of two limbs, the mean.
    pub fn girths(&self) -> BTreeMap<String, f64> {
        let mut girths = BTreeMap::new();
        for (name, landmark) in [
            ("bust_m", "bust_point_l"),
            ("waist_m", "waist_front"),
            ("hip_m", "hip_front"),
        ] {
            let level = self.landmarks.get(landmark).map(|p| p.y);
            girths.insert(name, level.and_then(|y| self.girth_at(y)));
        }
        girths.insert("neck_m", self.neck_girth());
        girths.insert("thigh_m", self.thigh_girth());
        let arm = [Limb::ArmLeft, Limb::ArmRight];
        let leg = [Limb::LegLeft, Limb::LegRight];
        for (name, limbs, [from, to]) in [
            ("upper_arm_m", arm, [0.5, 0.5]),
            ("elbow_m", arm, [1.0, 1.0]),
            ("wrist_m", arm, [2.0, 2.0]),
            ("knee_m", leg, [1.0, 1.0]),
        ] {
            girths.insert(name, self.mean_girth(limbs, [from, to], f64::max));
        }
        girths.insert("calf_m", self.mean_girth(leg, [1.1, 1.6], f64::max));
        girths.insert("ankle_m", self.mean_girth(leg, [1.8, 2.0], f64::min));
        let known = girths.into_iter();
        known
            .filter_map(|(name, girth)| Some((name.to_owned(), girth?)))
            .collect()
    }

    /// The least level girth above the sides of the neck.
    fn neck_girth(&self) -> Option<f64> {
        let side = self.landmarks.get("neck_side_l")?.y;
        let [low, high] = self.heights();
        let reach = 0.05 * (high - low);
        let girths = (0..=STEPS).filter_map(|k| {
            let y = side + reach * k as f64 / STEPS as f64;
            self.girth_at(y)
        });
        girths.min_by(f64::total_cmp)
    }

    /// The level girth of a thigh.
    fn thigh_girth(&self) -> Option<f64> {
        let crotch = self.landmarks.get("crotch")?.y;
        self.landmarks.get("knee_l")?;
        slice::leg_girth(&self.surface, crotch - THIGH)
    }

    /// The mean over two limbs of the girth between two places, counted in joints from the trunk,
    /// normal to the line from the first joint to the last but for the last one.
    fn mean_girth(
        &self,
        limbs: [Limb; 2],
        [from, to]: [f64; 2],
        choose: fn(f64, f64) -> f64,
    ) -> Option<f64> {
        let girths = limbs.map(|limb| {
            let [a, b, c] = self.limb(limb)?.joints;
            let direction = if from > 1.0 { c - b } else { c - a };
            let places = (0..=STEPS).map(|k| from + (to - from) * k as f64 / STEPS as f64);
            let girths = places.filter_map(|at| {
                let point = a + (b - a) * at.min(1.0) + (c - b) * (at - 1.0).max(0.0);
                slice::girth_across(&self.surface, &point, &direction)
            });
            girths.reduce(choose)
        });
        let [left, right] = girths;
        left.zip(right).map(|(left, right)| 0.5 * (left + right))
    }
}
