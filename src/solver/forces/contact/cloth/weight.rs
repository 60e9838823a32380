//! The cloth area over which two features press each other apart, with its derivative.
//!
//! Parallel edges have no closest points; the vertices at their ends act for them. So edges act
//! less the nearer they are to parallel, by a smooth step of the squared sine of their angle. Its
//! derivative is part of the force: areas that stay as they are within a step make the energy jump
//! from step to step, and where edges turn in contact the steps then go round in circles for ever.

use super::FeaturePair;
use super::proximity::Features;
use nalgebra::Vector3;

/// Sine squared of the angle between edges from which on they act in full.
const NOT_PARALLEL: f64 = 1e-2;

/// The area over which a pair presses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    /// The area \[m²\].
    pub(super) area: f64,
    /// Its derivative by the positions of the four corners \[m\].
    pub(super) slope: [Vector3<f64>; 4],
}

impl Weight {
    /// Returns the weight of `pair` at `x`, whose vertices stand for `area` each \[m²\].
    pub(super) fn of(pair: &FeaturePair, area: &[f64], x: &[Vector3<f64>]) -> Self {
        let [a, b, c, d] = pair.corners.map(|i| area[i]);
        match pair.features {
            Features::VertexTriangle => Self::fixed(a),
            Features::Edges => Self::of_edges(0.5 * (a + b).min(c + d), &pair.gather(x)),
        }
    }

    fn fixed(area: f64) -> Self {
        Self {
            area,
            slope: [Vector3::zeros(); 4],
        }
    }

    /// Returns the weight of edges of the first two and the last two corners, which is `area` where
    /// they are far from parallel.
    fn of_edges(area: f64, corners: &[Vector3<f64>; 4]) -> Self {
        let (d, e) = (corners[1] - corners[0], corners[3] - corners[2]);
        let (dd, ee, de) = (d.norm_squared(), e.norm_squared(), d.dot(&e));
        let lengths = dd * ee;
        let sine_squared = d.cross(&e).norm_squared() / lengths.max(f64::MIN_POSITIVE);
        let share = sine_squared / NOT_PARALLEL;
        if share >= 1.0 || lengths == 0.0 {
            return Self::fixed(area * share.min(1.0));
        }
        let of_share = area * 6.0 * share * (1.0 - share);
        let of_sine = -2.0 * de / lengths * of_share / NOT_PARALLEL;
        let by_d = (e - d * (de / dd)) * of_sine;
        let by_e = (d - e * (de / ee)) * of_sine;
        Self {
            area: area * share * share * (3.0 - 2.0 * share),
            slope: [-by_d, by_d, -by_e, by_e],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{THICKNESS, contact, two_sheets};
    use super::*;
    use crate::solver::forces::Potential;

    /// Edges at an angle, of other lengths than 1.
    fn edges(angle: f64) -> [Vector3<f64>; 4] {
        let v = Vector3::new;
        [
            v(0.1, -0.2, 0.0),
            v(2.1, -0.2, 0.1),
            v(0.5, -0.7, 0.3),
            v(0.5 + 3.0 * angle.cos(), -0.7 + 3.0 * angle.sin(), 0.4),
        ]
    }

    #[test]
    fn edges_act_less_the_nearer_they_are_to_parallel() {
        let areas = [0.0, 0.03, 0.06, 0.12, 0.8].map(|angle| {
            let mut corners = edges(angle);
            for corner in &mut corners {
                corner.z = 0.0;
            }
            Weight::of_edges(2.0, &corners).area
        });
        assert!(areas.is_sorted());
        assert!(areas[0] < 1e-12 && areas[4] == 2.0);
    }

    #[test]
    fn the_slope_is_the_derivative_of_the_area() {
        let step = 1e-6;
        for angle in [0.02, 0.05, 0.08, 0.5] {
            let corners = edges(angle);
            let weight = Weight::of_edges(2.0, &corners);
            for (i, slope) in weight.slope.iter().enumerate() {
                for axis in 0..3 {
                    let at = |by: f64| {
                        let mut moved = corners;
                        moved[i][axis] += by;
                        Weight::of_edges(2.0, &moved).area
                    };
                    let difference = (at(step) - at(-step)) / (2.0 * step);
                    // The third derivative is below 2 / (0.1 length)³, and differences round to
                    // 4e-16 / step.
                    assert!(
                        (slope[axis] - difference).abs() < 1e-8,
                        "{angle} {i} {axis}"
                    );
                }
            }
        }
    }

    /// Nearly parallel edges among them: an energy of what was accepted would jump from step to
    /// step, and a search that must lower it would never end.
    #[test]
    fn the_energy_is_one_of_the_positions_alone() {
        let nearly_parallel = |p| {
            let turn = nalgebra::Rotation3::new(Vector3::new(0.004, 0.003, 0.05));
            turn * p + Vector3::new(0.0013, 0.0021, 0.6 * THICKNESS)
        };
        let (surface, x) = two_sheets([3, 2], nearly_parallel);
        let mut contact = contact(surface);
        contact.accept(&x);
        let mut force = vec![Vector3::zeros(); x.len()];
        contact.add_force(&x, &mut force);
        for (i, force) in force.iter().enumerate() {
            let mut along = |by: f64| {
                let mut moved = x.clone();
                moved[i] += force.normalize() * by;
                contact.energy(&moved)
            };
            let slope = (along(-1e-8) - along(1e-8)) / 2e-8;
            // Differences of energies of about 1e-6 J round at 1e-22 J.
            let off = (slope - force.norm()).abs();
            assert!(
                off.is_nan() || off < 1e-6 * force.norm() + 1e-12,
                "{i}: {off}"
            );
        }
        let turned = x
            .iter()
            .map(|p| p + Vector3::new(-p.y, p.x, 0.0) * (0.02 * p.z / THICKNESS));
        let turned = turned.collect::<Vec<_>>();
        let before = contact.energy(&turned);
        contact.accept(&turned);
        assert!(before > 0.0 && contact.energy(&turned) == before);
    }
}
