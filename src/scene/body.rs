//! Bodies that cloth is draped on: an avatar, or a body whose signed distance is a formula.

use super::avatar::{Avatar, BodySample};
use crate::fault::{Fault, SceneCode};
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A body that cloth is draped on.
#[derive(Clone, Debug)]
pub enum Body {
    /// A closed surface with its distance field.
    Avatar(Arc<Avatar>),
    /// A body whose distance is a formula.
    Analytic(Analytic),
}

/// A body whose signed distance is a formula. Lengths in meters, directions of any length but zero.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Analytic {
    /// All points within `r` of `c`.
    Sphere {
        /// Center.
        c: [f64; 3],
        /// Radius.
        r: f64,
    },
    /// All points within `r` of the line from `a` to `b`, ends rounded.
    Capsule {
        /// One end of the line.
        a: [f64; 3],
        /// Its other end, not the same.
        b: [f64; 3],
        /// Radius.
        r: f64,
    },
    /// All points within `r` of an endless line.
    Cylinder {
        /// A point of the line.
        c: [f64; 3],
        /// Its direction.
        axis: [f64; 3],
        /// Radius.
        r: f64,
    },
    /// All points behind a plane.
    HalfSpace {
        /// A point of the plane.
        c: [f64; 3],
        /// The way out.
        normal: [f64; 3],
    },
}

impl Body {
    /// The signed distance at `p` with its first two derivatives, or `None` where it is too far
    /// away to matter.
    pub fn sample(&self, p: &Vector3<f64>) -> Option<BodySample> {
        match self {
            Self::Avatar(avatar) => avatar.sample(p),
            Self::Analytic(analytic) => Some(analytic.sample(p)),
        }
    }

    /// The exact signed distance of the surface at `p` \[m\], negative inside.
    pub fn exact_distance(&self, p: &Vector3<f64>) -> f64 {
        match self {
            Self::Avatar(avatar) => avatar.exact_distance(p),
            Self::Analytic(analytic) => analytic.sample(p).distance,
        }
    }

    /// The direction out of the body at `p`, however far it is; none on the surface of an avatar.
    pub fn outward(&self, p: &Vector3<f64>) -> Option<Vector3<f64>> {
        match self {
            Self::Avatar(avatar) => avatar.outward(p),
            Self::Analytic(analytic) => Some(analytic.sample(p).normal),
        }
    }

    /// The avatar, if it is one.
    pub fn avatar(&self) -> Option<&Arc<Avatar>> {
        match self {
            Self::Avatar(avatar) => Some(avatar),
            Self::Analytic(_) => None,
        }
    }
}

impl Analytic {
    /// The signed distance at `p` with its first two derivatives.
    ///
    /// At the center of a sphere and on the axis of a capsule or cylinder the normal is any one.
    pub fn sample(&self, p: &Vector3<f64>) -> BodySample {
        match *self {
            Self::Sphere { c, r } => round(p - Vector3::from(c), r, Matrix3::identity()),
            Self::Capsule { a, b, r } => {
                let (a, along) = (Vector3::from(a), Vector3::from(b) - Vector3::from(a));
                let t = (p - a).dot(&along) / along.norm_squared();
                if (0.0..=1.0).contains(&t) {
                    about_line(p - a, along, r)
                } else {
                    round(p - a - along * t.clamp(0.0, 1.0), r, Matrix3::identity())
                }
            }
            Self::Cylinder { c, axis, r } => about_line(p - Vector3::from(c), axis.into(), r),
            Self::HalfSpace { c, normal } => {
                let normal = Vector3::from(normal).normalize();
                BodySample {
                    distance: normal.dot(&(p - Vector3::from(c))),
                    normal,
                    curvature: Matrix3::zeros(),
                }
            }
        }
    }
}

impl Analytic {
    /// Returns its faults: numbers that are not finite, no radius, no direction; each under
    /// `pointer`.
    pub fn check(&self, pointer: &str) -> Vec<Fault> {
        let mut faults = Vec::new();
        let mut tell = |wrong: bool, field: &str, detail: &str| {
            if wrong {
                let pointer = format!("{pointer}/{field}");
                faults.push(Fault::new(SceneCode::Body, pointer, detail));
            }
        };
        let infinite = |p: &[f64; 3]| !p.iter().all(|c| c.is_finite());
        let (points, direction, radius) = match self {
            Self::Sphere { c, r } => ([("c", c), ("c", c)], None, Some(r)),
            Self::Capsule { a, b, r } => {
                let along = [0, 1, 2].map(|k| b[k] - a[k]);
                ([("a", a), ("b", b)], Some(("b", along)), Some(r))
            }
            Self::Cylinder { c, axis, r } => {
                ([("c", c), ("axis", axis)], Some(("axis", *axis)), Some(r))
            }
            Self::HalfSpace { c, normal } => (
                [("c", c), ("normal", normal)],
                Some(("normal", *normal)),
                None,
            ),
        };
        let points = if points[0].0 == points[1].0 {
            &points[..1]
        } else {
            &points[..]
        };
        for &(field, p) in points {
            tell(infinite(p), field, "a coordinate is not a finite number");
        }
        if let Some((field, d)) = direction {
            let square: f64 = d.iter().map(|c| c * c).sum();
            tell(square == 0.0, field, "it has no direction: its length is 0");
        }
        if let Some(&r) = radius {
            tell(
                !(r > 0.0 && r.is_finite()),
                "r",
                "the radius is not above 0",
            );
        }
        faults
    }
}

/// The distance from an endless line less `r`; `from` begins anywhere on the line.
fn about_line(from: Vector3<f64>, along: Vector3<f64>, r: f64) -> BodySample {
    let along = along.normalize();
    let across = Matrix3::identity() - along * along.transpose();
    round(across * from, r, across)
}

/// The distance `|from|` less `r`, where `across` projects on the directions in which the surface
/// is round.
fn round(from: Vector3<f64>, r: f64, across: Matrix3<f64>) -> BodySample {
    let length = from.norm();
    let normal = if length > 0.0 {
        from / length
    } else {
        across.column(across.diagonal().imax()).normalize()
    };
    BodySample {
        distance: length - r,
        normal,
        curvature: (across - normal * normal.transpose()) / length.max(f64::MIN_POSITIVE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODIES: [Analytic; 4] = [
        Analytic::Sphere {
            c: [0.1, 0.2, -0.1],
            r: 0.3,
        },
        Analytic::Capsule {
            a: [0.0, 0.0, -1.0],
            b: [0.2, 0.1, 1.0],
            r: 0.12,
        },
        Analytic::Cylinder {
            c: [0.1, 0.0, 0.0],
            axis: [1.0, 2.0, 0.5],
            r: 0.2,
        },
        Analytic::HalfSpace {
            c: [0.0, 0.1, 0.0],
            normal: [0.3, 2.0, 0.0],
        },
    ];

    /// Central differences of step h are off by h²/6 times a third derivative, here below 100, plus
    /// rounding / h.
    #[test]
    fn normals_and_curvatures_are_derivatives_of_the_distance() {
        let points = [
            [0.5, 0.3, 0.2],
            [-0.4, 0.1, 0.9],
            [0.3, 0.2, 1.4],
            [0.2, -0.3, -1.3],
        ];
        let h = 1e-5;
        for body in BODIES {
            for p in points.map(Vector3::from) {
                let here = body.sample(&p);
                assert!((here.normal.norm() - 1.0).abs() < 1e-14, "{body:?}");
                for axis in 0..3 {
                    let step = Vector3::ith(axis, h);
                    let [fore, aft] = [p + step, p - step].map(|p| body.sample(&p));
                    let slope = (fore.distance - aft.distance) / (2.0 * h);
                    assert!((slope - here.normal[axis]).abs() < 2e-9, "{body:?}");
                    let bend = (fore.normal - aft.normal) / (2.0 * h);
                    assert!(
                        (bend - here.curvature.column(axis)).norm() < 1e-8,
                        "{body:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn distances_of_known_points() {
        let capsule = Analytic::Capsule {
            a: [0.0; 3],
            b: [0.0, 0.0, 1.0],
            r: 0.25,
        };
        for (p, distance) in [
            ([0.5, 0.0, 0.5], 0.25),
            ([0.0, 0.0, 2.0], 0.75),
            ([0.0, 0.0, 0.5], -0.25),
        ] {
            assert!((capsule.sample(&p.into()).distance - distance).abs() < 1e-15);
        }
    }
}
