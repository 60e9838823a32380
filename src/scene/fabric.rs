//! Fabrics: coefficients of one cloth, with their sources.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Coefficients of one cloth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Fabric {
    /// Name for a person.
    pub name: String,
    /// Mass per area \[kg/m²\].
    pub density_kg_m2: f64,
    /// \[m\]
    pub thickness_m: f64,
    /// Stretch modulus along the warp: force per width and strain \[N/m\].
    pub stretch_warp_n_m: f64,
    /// Stretch modulus along the weft \[N/m\].
    pub stretch_weft_n_m: f64,
    /// Shear modulus: force per width and radian \[N/m\].
    pub shear_n_m: f64,
    /// Bending rigidity of a strip cut along the warp \[N m\].
    pub bending_warp_n_m: f64,
    /// Bending rigidity of a strip cut along the weft \[N m\].
    pub bending_weft_n_m: f64,
    /// Coulomb coefficient against the body.
    pub friction: f64,
    /// Share of critical damping.
    pub damping_ratio: f64,
    /// Where the figures come from.
    pub source: String,
}

/// The fabrics that ship with the service, by id.
pub fn library() -> BTreeMap<String, Fabric> {
    BTreeMap::new()
}

impl Fabric {
    /// What is implausible about it, under `pointer`.
    pub fn check(&self, _pointer: &str) -> Vec<crate::fault::Fault> {
        Vec::new()
    }
}
