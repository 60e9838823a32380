//! The body that a garment is draped on.

use crate::fault::Faults;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A closed body with what is needed to place and drape on it: y up, facing +z, its left at +x, floor at y = 0 \[m\].
#[derive(Clone, Debug)]
pub struct Avatar {
    /// Name for a person.
    pub name: String,
    /// Its surface.
    pub surface: TriangleMesh,
    /// Named points of the body \[m\], named as in `LANDMARKS`.
    pub landmarks: BTreeMap<String, Vector3<f64>>,
}

/// A closed surface of triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// \[m\]; `#V`.
    pub vertices: Vec<Vector3<f64>>,
    /// `#T`.
    pub triangles: Vec<[usize; 3]>,
}

/// The signed distance of a body at a point, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodySample {
    /// Negative inside \[m\].
    pub distance: f64,
    /// Gradient of the distance: the outward normal, of length about 1.
    pub normal: Vector3<f64>,
    /// Second derivative \[1/m\].
    pub curvature: Matrix3<f64>,
}

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
}

impl DressForm {
    /// Makes the avatar.
    ///
    /// # Errors
    /// Measurements outside what a person has, each with its pointer (`/height_m`).
    pub fn build(&self) -> Result<Avatar, Faults> {
        unreachable!()
    }
}

impl Avatar {
    /// The smooth signed distance at `p`, or `None` further than `reach` outside.
    pub fn sample(&self, _p: &Vector3<f64>) -> Option<BodySample> {
        None
    }

    /// The exact signed distance of the surface at `p` \[m\], negative inside.
    pub fn exact_distance(&self, _p: &Vector3<f64>) -> f64 {
        0.0
    }
}

impl Default for DressForm {
    /// A woman of 1.68 m in a size M (EN 13402-3: bust 90-98).
    fn default() -> Self {
        Self {
            height_m: 1.68,
            bust_m: 0.92,
            waist_m: 0.74,
            hip_m: 0.98,
        }
    }
}
