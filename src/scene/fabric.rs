//! Fabrics: coefficients of one cloth, with their sources.

use crate::fault::{FabricCode, Fault};
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
    /// Coulomb coefficient against the body and other cloth: of two fabrics the smaller one counts.
    pub friction: f64,
    /// Share of critical damping.
    pub damping_ratio: f64,
    /// Source of the figures.
    pub source: String,
}

/// Names and bounds of what a cloth may have; a decade or more beyond anything worn.
type Bounds = [(&'static str, fn(&Fabric) -> f64, [f64; 2]); 9];

/// From the lightest veil to heavy leather, from a loose knit to a sheet of film.
const BOUNDS: Bounds = [
    ("density_kg_m2", |f| f.density_kg_m2, [0.002, 5.0]),
    ("thickness_m", |f| f.thickness_m, [1e-5, 0.02]),
    ("stretch_warp_n_m", |f| f.stretch_warp_n_m, [0.5, 1e7]),
    ("stretch_weft_n_m", |f| f.stretch_weft_n_m, [0.5, 1e7]),
    ("shear_n_m", |f| f.shear_n_m, [0.05, 1e6]),
    ("bending_warp_n_m", |f| f.bending_warp_n_m, [1e-9, 0.1]),
    ("bending_weft_n_m", |f| f.bending_weft_n_m, [1e-9, 0.1]),
    ("friction", |f| f.friction, [0.0, 2.0]),
    ("damping_ratio", |f| f.damping_ratio, [0.0, 1.0]),
];

/// Force per width at which the extension of cloth is measured \[N/m\]: 500 gf/cm (KES-FB1, S.
/// Kawabata, The Standardization and Analysis of Hand Evaluation, 1980). Round a trunk it presses
/// with 3 kPa, about as much as is borne all day.
const KES_LOAD: f64 = 490.3325;
/// Most that any cloth gives \[-\]: a knit has pulled its loops straight there, which the linear
/// law of its modulus does not know.
const MOST_GIVEN: f64 = 0.5;

impl Fabric {
    /// The extension that cloth gives in wear, as a share of its length, at an angle from its warp
    /// \[rad\]: that at 490 N/m, at most a half.
    pub fn extension(&self, from_warp: f64) -> f64 {
        let (sin, cos) = from_warp.sin_cos();
        let (warp, weft) = (cos * cos, sin * sin);
        let compliance = warp * warp / self.stretch_warp_n_m
            + weft * weft / self.stretch_weft_n_m
            + warp * weft / self.shear_n_m;
        (KES_LOAD * compliance).min(MOST_GIVEN)
    }

    /// Returns the faults of the coefficients: each outside its bounds, or not finite, under
    /// `pointer`.
    pub fn check(&self, pointer: &str) -> Vec<Fault> {
        BOUNDS
            .iter()
            .filter_map(|(field, get, [least, most])| {
                let value = get(self);
                // so written that a NaN is a fault
                (!(least..=most).contains(&&value)).then(|| {
                    let detail = format!("{field} of {value} is not that of a cloth");
                    Fault::new(
                        FabricCode::Coefficient,
                        format!("{pointer}/{field}"),
                        detail,
                    )
                    .fix(format!("give {least} to {most}; mind the unit in the name"))
                })
            })
            .collect()
    }
}

/// The fabrics that ship with the service, by id.
pub fn library() -> BTreeMap<String, Fabric> {
    serde_json::from_str(include_str!("fabrics.json"))
        .expect("the file is part of the program, and a test reads it")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_fabric_is_plausible() {
        let library = library();
        assert_eq!(library.len(), 13);
        for (id, fabric) in &library {
            assert_eq!(fabric.check(""), [], "{id}");
            assert!(
                id.chars()
                    .all(|c| c == '-' || c.is_ascii_lowercase() || c.is_ascii_digit())
            );
            assert!(!fabric.source.is_empty() && !fabric.name.is_empty(), "{id}");
        }
    }

    /// A cloth hangs over a length c = (B / (g W))^(1/3) (Peirce 1930): 1 to 6 cm for anything
    /// worn.
    #[test]
    fn bending_length_of_every_shipped_fabric_is_that_of_cloth() {
        for (id, fabric) in library() {
            for bending in [fabric.bending_warp_n_m, fabric.bending_weft_n_m] {
                let length = (bending / (9.80665 * fabric.density_kg_m2)).cbrt();
                assert!((0.01..0.06).contains(&length), "{id}: {length} m");
            }
        }
    }

    /// Cloth is less dense than its fibers (about 1500 kg/m3) and more than a loose pile.
    #[test]
    fn bulk_density_of_every_shipped_fabric_is_that_of_cloth() {
        for (id, fabric) in library() {
            let bulk = fabric.density_kg_m2 / fabric.thickness_m;
            assert!((80.0..1500.0).contains(&bulk), "{id}: {bulk} kg/m3");
        }
    }

    /// Cotton poplin: 3 % and 8 % at 500 gf/cm, as its source says; along the bias as its shear
    /// lets it.
    #[test]
    fn extension_is_that_of_the_source_along_the_threads_and_greater_on_the_bias() {
        let poplin = library().remove("cotton-poplin").expect("a shipped fabric");
        let right_angle = std::f64::consts::FRAC_PI_2;
        assert!((poplin.extension(0.0) - 0.03).abs() < 1e-4);
        assert!((poplin.extension(right_angle) - 0.08).abs() < 1e-4);
        assert!(poplin.extension(0.5 * right_angle) > 0.08);
        let rib = library().remove("rib-knit").expect("a shipped fabric");
        assert!((rib.extension(0.0) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn each_coefficient_that_no_cloth_has_is_named() {
        let good = library().remove("denim-11oz").expect("a shipped fabric");
        let bad = Fabric {
            density_kg_m2: 324.0,
            thickness_m: f64::NAN,
            shear_n_m: -1.0,
            stretch_warp_n_m: f64::INFINITY,
            ..good
        };
        let pointers: Vec<_> = bad
            .check("/fabrics/own")
            .into_iter()
            .map(|f| f.pointer)
            .collect();
        let fields = [
            "density_kg_m2",
            "thickness_m",
            "stretch_warp_n_m",
            "shear_n_m",
        ];
        assert_eq!(
            pointers,
            fields.map(|field| format!("/fabrics/own/{field}"))
        );
    }

    #[test]
    fn unknown_coefficient_is_refused() {
        let mut json = serde_json::to_value(&library()["linen"]).expect("plain data");
        json["streching"] = 1.0.into();
        assert!(serde_json::from_value::<Fabric>(json).is_err());
    }
}
