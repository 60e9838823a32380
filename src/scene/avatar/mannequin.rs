//! The avatar of a dress form: its surface, with limbs if it has any, and its landmarks.

use super::figure::Figure;
use super::form::{DressForm, shoulder_line};
use super::torso::{BUST_ANGLE, Torso, share};
use super::{Avatar, TriangleMesh, slice};
use crate::fault::Faults;
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

impl DressForm {
    /// Makes the avatar: a closed, smooth torso from the top of the neck to below the crotch,
    /// whose level girths at bust, waist and hip are those asked for, within 3 mm, with the limbs
    /// that are asked for.
    ///
    /// # Errors
    /// `avatar/measurement`: measurements outside what a person has, each with its pointer
    /// (`/height_m`).
    pub fn build(&self) -> Result<Avatar, Faults> {
        Faults(self.check()).or(())?;
        let (torso, surface) = self.fit();
        let limbs = self.limbs.unwrap_or_default();
        let figure = (limbs.arms || limbs.legs).then(|| Figure::new(self, &torso));
        let surface = figure
            .as_ref()
            .map_or(surface, |figure| figure.surface.clone());
        let mut avatar = Avatar::from_surface("dress form", surface, BTreeMap::new())?;
        for (name, point) in side_landmarks(&torso, self) {
            let on_surface = avatar.nearest_point(&point);
            avatar.add_pair(name, on_surface);
        }
        let middle = middle_landmarks(&avatar.surface, self);
        avatar.landmarks.extend(middle);
        if let Some(figure) = figure {
            figure.describe(&mut avatar);
        }
        Ok(avatar)
    }
}

/// The landmarks that come in pairs: names without `_l`, and points on the left, near enough to the
/// mesh to be put onto it.
fn side_landmarks(torso: &Torso, form: &DressForm) -> [(&'static str, Vector3<f64>); 7] {
    let height = form.height_m;
    let waist = form.value("waist_height_m") / height;
    let at = |share: f64, angle: f64| {
        let section = torso.section(torso.parameter(share * height));
        let [x, z] = section.point(angle);
        Vector3::new(x, section.y, z)
    };
    let [neck, tip] = shoulder_line(torso).map(|[x, y, z]| Vector3::new(x, y, z));
    [
        ("neck_side", neck),
        ("shoulder_tip", tip),
        ("armpit", at(share::ARMPIT, FRAC_PI_2)),
        ("bust_point", at(share::BUST, BUST_ANGLE)),
        ("bust_side", at(share::BUST, FRAC_PI_2)),
        ("waist_side", at(waist, FRAC_PI_2)),
        ("hip_side", at(share::HIP, FRAC_PI_2)),
    ]
}

/// The landmarks in the middle; `crotch` is the lowest one.
fn middle_landmarks(surface: &TriangleMesh, form: &DressForm) -> BTreeMap<String, Vector3<f64>> {
    let height = form.height_m;
    let waist = form.value("waist_height_m") / height;
    let mut found = BTreeMap::new();
    for (name, front, back) in [
        ("neck", share::NECK_FRONT, share::NECK_BACK),
        ("bust", share::BUST, share::BUST),
        ("waist", waist, waist),
        ("hip", share::HIP, share::HIP),
    ] {
        for (end, share, which) in [("back", back, 0), ("front", front, 1)] {
            if let Some(z) = slice::middle(surface, share * height) {
                let point = Vector3::new(0.0, share * height, z[which]);
                found.insert(format!("{name}_{end}"), point);
            }
        }
    }
    let in_middle = surface.vertices.iter().filter(|v| v.x == 0.0);
    let lowest = in_middle.min_by(|a, b| a.y.total_cmp(&b.y));
    found.extend(lowest.map(|v| ("crotch".to_owned(), *v)));
    found
}
