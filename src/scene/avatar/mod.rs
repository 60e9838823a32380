//! The body that a garment is draped on: its surface, its landmarks and its signed distance.

mod arm;
mod cache;
mod enclose;
mod exact;
mod field;
mod figure;
mod form;
mod half_mesh;
mod head;
mod hull;
mod lattice;
mod leg;
mod limb;
mod mannequin;
mod measured;
mod measures;
mod node_distances;
mod own;
mod proportions;
mod rings;
mod section;
mod slice;
mod source;
mod spline;
mod surface;
mod tips;
mod torso;
mod tree;
mod tube;
mod winding;

pub use cache::AvatarCache;
pub use field::BodySample;
pub use form::{DressForm, Limbs, Pose, Sex};
pub use head::is_head;
pub use limb::{Limb, LimbAxis};
pub use own::{
    BodyFormat, BodyImport, BodyImportOptions, BodyUnits, FileAxis, OwnBody, import_body,
};
pub use source::BodySource;
pub use surface::TriangleMesh;
pub use tips::Tips;

use crate::fault::Faults;
use exact::ExactDistance;
use field::DistanceField;
use hull::hull;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Distance outside the surface up to which the smooth distance is offered \[m\]: more than cloth,
/// its thickness and one Newton move.
const REACH: f64 = 0.04;
/// Spacing of the grid of distances about a dress form \[m\]: about the edges of its mesh, so that
/// its facets are not resolved but smoothed.
const SPACING: f64 = 0.009;
/// The same about a body from a file \[m\], whose details are its own: errors go with its square.
const OWN_SPACING: f64 = 0.006;

/// A closed body with what is needed to place and drape on it: y up, facing +z, its left at +x,
/// floor at y = 0 \[m\].
///
/// Made by [`Avatar::from_surface`]; the surface is not to be changed afterwards, since the
/// distances belong to it.
#[derive(Clone, Debug)]
pub struct Avatar {
    /// Name for a person.
    pub name: String,
    /// Its surface.
    pub surface: TriangleMesh,
    /// Named points of the body \[m\], named as in [`LANDMARKS`].
    pub landmarks: BTreeMap<String, Vector3<f64>>,
    limbs: BTreeMap<Limb, LimbAxis>,
    exact: ExactDistance,
    field: DistanceField,
}

/// The landmarks that every avatar has; `_l` is the body's left (+x).
pub const LANDMARKS: [&str; 23] = [
    "armpit_l",
    "armpit_r",
    "bust_back",
    "bust_front",
    "bust_point_l",
    "bust_point_r",
    "bust_side_l",
    "bust_side_r",
    "crotch",
    "hip_back",
    "hip_front",
    "hip_side_l",
    "hip_side_r",
    "neck_back",
    "neck_front",
    "neck_side_l",
    "neck_side_r",
    "shoulder_tip_l",
    "shoulder_tip_r",
    "waist_back",
    "waist_front",
    "waist_side_l",
    "waist_side_r",
];

impl Avatar {
    /// An avatar of a closed surface.
    ///
    /// # Errors
    /// `avatar/...` with pointers into `/surface`: no triangles, indices or coordinates that are
    /// none, triangles without area, a surface that is open, not two-sided or inside out, or larger
    /// than the limits.
    pub fn from_surface(
        name: &str,
        surface: TriangleMesh,
        landmarks: BTreeMap<String, Vector3<f64>>,
    ) -> Result<Self, Faults> {
        Faults(surface.check()).or(())?;
        let exact = ExactDistance::new(&surface);
        let field = DistanceField::new((&surface, &exact), REACH, SPACING);
        Ok(Self {
            name: name.to_owned(),
            surface,
            landmarks,
            limbs: BTreeMap::new(),
            exact,
            field,
        })
    }

    /// An avatar of a closed surface that may cross itself: its distances are those of the outside.
    ///
    /// # Errors
    /// As [`Avatar::from_surface`], and `avatar/crossing` if it crosses itself in too many places.
    fn from_crossing_surface(
        name: &str,
        surface: TriangleMesh,
        landmarks: BTreeMap<String, Vector3<f64>>,
    ) -> Result<Self, Faults> {
        Faults(surface.check()).or(())?;
        let (exact, field) = match hull(&surface)? {
            None => {
                let exact = ExactDistance::new(&surface);
                let field = DistanceField::new((&surface, &exact), REACH, OWN_SPACING);
                (exact, field)
            }
            Some(hull) => {
                let outside = hull.surface.clone();
                let exact = ExactDistance::of_hull(hull);
                let field = DistanceField::new((&outside, &exact), REACH, OWN_SPACING);
                (exact, field)
            }
        };
        Ok(Self {
            name: name.to_owned(),
            surface,
            landmarks,
            limbs: BTreeMap::new(),
            exact,
            field,
        })
    }

    /// Returns true if the surface crosses itself, so that not all of it is the outside.
    pub fn crosses_itself(&self) -> bool {
        self.exact.is_hull()
    }

    /// Returns the axis of a limb, if the body has it and it is known.
    pub fn limb(&self, limb: Limb) -> Option<&LimbAxis> {
        self.limbs.get(&limb)
    }

    /// Adds the landmarks `name_l` at `left` and `name_r` opposite to it.
    fn add_pair(&mut self, name: &str, left: Vector3<f64>) {
        let right = Vector3::new(-left.x, left.y, left.z);
        self.landmarks.insert(format!("{name}_l"), left);
        self.landmarks.insert(format!("{name}_r"), right);
    }

    /// The smooth signed distance at `p` \[m\] with its first two derivatives, or `None` further
    /// than 4 cm outside.
    ///
    /// One twice continuously differentiable function, the cubic spline through exact distances on
    /// a grid, lowered where the surface would stand out of it by more than 0.1 mm: the three
    /// results are exact derivatives of each other, and the value differs from
    /// [`Avatar::exact_distance`] by some tenths of a millimeter at most where the surface is
    /// smooth on the scale of the grid (9 mm).
    pub fn sample(&self, p: &Vector3<f64>) -> Option<BodySample> {
        self.field.sample(p)
    }

    /// The smooth signed distance of [`Avatar::sample`] alone \[m\]; infinite where that is `None`.
    pub fn distance(&self, p: &Vector3<f64>) -> f64 {
        self.field.distance(p).unwrap_or(f64::INFINITY)
    }

    /// The exact signed distance of the surface at `p` \[m\], negative inside.
    pub fn exact_distance(&self, p: &Vector3<f64>) -> f64 {
        self.exact.signed(p)
    }

    /// The direction from the surface to a point outside of it, or out to the surface from inside,
    /// however far; none on the surface.
    pub fn outward(&self, p: &Vector3<f64>) -> Option<Vector3<f64>> {
        let from_surface = p - self.nearest_point(p);
        (from_surface * self.exact_distance(p).signum()).try_normalize(0.0)
    }

    /// The point of the surface nearest to `p` \[m\].
    pub fn nearest_point(&self, p: &Vector3<f64>) -> Vector3<f64> {
        self.exact.nearest(p)
    }

    /// Its tips: what stands out of it with a curvature above `sharpness` \[1/m\]; none if nothing
    /// does.
    pub fn tips(&self, sharpness: f64) -> Option<Tips> {
        Tips::new(&self.surface, &self.field, sharpness)
    }

    /// Length of a tape laid round the torso at height `y`, round both legs under the crotch: the
    /// perimeter of the convex hull of the slice \[m\].
    pub fn girth_at(&self, y: f64) -> Option<f64> {
        slice::girth(&self.surface, y)
    }

    /// Lowest and highest point of the surface \[m\].
    pub fn heights(&self) -> [f64; 2] {
        self.exact.bounds().map(|corner| corner.y)
    }

    /// Bounds of the torso at height `y`, of the legs under the crotch \[m\]: `[[min x, max x],
    /// [min z, max z]]`.
    pub fn section_bounds(&self, y: f64) -> Option<[[f64; 2]; 2]> {
        slice::bounds(&self.surface, y)
    }

    /// Length of a tape laid round a limb normal to its axis, at a length along the axis \[m\].
    pub fn limb_girth(&self, limb: Limb, along: f64) -> Option<f64> {
        let (point, direction) = self.limb(limb)?.at(along);
        let plane = slice::Plane::normal_to(direction, point);
        slice::girth_around(&self.surface, &plane)
    }
}

#[cfg(test)]
mod figure_tests;
#[cfg(test)]
mod tests;
