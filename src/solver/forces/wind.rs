//! Wind (P11): the force of moving air on each triangle, both sides of which it meets.
//!
//! With v the velocity of the air less that of the triangle, n its normal and A its area, as it
//! lies, `F = ρ/2 A (c_n |v·n| (v·n) n + c_t |v_t| v_t)`, `v_t` the part of v along the cloth:
//! pressure drag on the component across the cloth (the cross-flow principle) and friction along
//! it. Each corner has a third. S. F. Hoerner, "Fluid-Dynamic Drag" (1965): 1.17 for a square plate
//! across the flow; a plate along the flow has 0.074 Re^(-1/5) a side (Prandtl), both sides
//! together 0.012 for half a meter at 5 m/s.
//!
//! # Limitations
//! Cloth does not shelter cloth, and the body does not shelter it either; the air does not feel the
//! cloth.
//!
//! # Energy
//! The force follows the cloth, so it is not conservative. Since the last accepted shape x0 it has
//! done the work (f(x0) + f(x))·(x - x0) / 2 along the straight way, to third order; less that is
//! the energy here. At x0 its gradient is -f exactly and its second derivative the symmetric part
//! of -df/dx, so that Newton's steps, which start there, find the shape where the true forces
//! balance. The antisymmetric part, as large where cloth streams in the wind, goes into the step by
//! `linalg/nonsymmetric.rs`.

use crate::scene::Wind;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Density of air at 20 °C and 101 325 Pa \[kg/m³\].
const AIR_DENSITY: f64 = 1.204;
/// Drag coefficient of cloth across the flow.
const ACROSS: f64 = 1.17;
/// Friction coefficient along the cloth, of both sides together.
const ALONG: f64 = 0.012;

/// The force of wind on all triangles.
pub(crate) struct WindForce {
    wind: Wind,
    triangles: Vec<[usize; 3]>,
    /// Velocity of the air now \[m/s\].
    air: Vector3<f64>,
    /// Velocity of each particle \[m/s\]; none while nothing moves.
    velocity: Vec<Vector3<f64>>,
    /// The shape that work is counted from, and the forces there.
    accepted: Vec<Vector3<f64>>,
    accepted_force: Vec<Vector3<f64>>,
    scratch: Vec<Vector3<f64>>,
    slots: Vec<[Slot; 6]>,
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl WindForce {
    /// Returns the force of the mean of `wind` on `triangles` of particles, its work counted from
    /// `start` \[m\].
    pub(crate) fn new(wind: Wind, triangles: Vec<[usize; 3]>, start: &[Vector3<f64>]) -> Self {
        let mut force = Self {
            wind,
            triangles,
            air: wind.velocity,
            velocity: Vec::new(),
            accepted: Vec::new(),
            accepted_force: vec![Vector3::zeros(); start.len()],
            scratch: vec![Vector3::zeros(); start.len()],
            slots: Vec::new(),
        };
        force.accept(start);
        force
    }

    /// Returns the velocity of the air relative to a triangle.
    fn relative(&self, triangle: &[usize; 3]) -> Vector3<f64> {
        if self.velocity.is_empty() {
            return self.air;
        }
        let [a, b, c] = triangle.map(|v| self.velocity[v]);
        self.air - (a + b + c) / 3.0
    }

    /// Returns the derivative of a third of the force on triangle `t` by each of its corners.
    fn third_by_corner(&self, t: &[usize; 3], x: &[Vector3<f64>]) -> [Matrix3<f64>; 3] {
        let by_area = drag_by_area(&area(t, x), &self.relative(t));
        // A corner moved by d changes the area vector by half of (the edge across from it) x d.
        [0, 1, 2].map(|i| {
            let edge = x[t[(i + 2) % 3]] - x[t[(i + 1) % 3]];
            by_area * edge.cross_matrix() * (0.5 / 3.0)
        })
    }

    fn add(&self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        for triangle in &self.triangles {
            let third = drag(&area(triangle, x), &self.relative(triangle)) / 3.0;
            for &particle in triangle {
                force[particle] += third;
            }
        }
    }
}

/// Returns half the cross product of two edges: the normal times the area \[m²\].
fn area(triangle: &[usize; 3], x: &[Vector3<f64>]) -> Vector3<f64> {
    let [p, q, r] = triangle.map(|v| x[v]);
    (q - p).cross(&(r - p)) * 0.5
}

/// Returns the force on a triangle of area vector `a` in air that passes it at `v` \[N\].
fn drag(a: &Vector3<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    let square = a.norm_squared();
    if square < f64::MIN_POSITIVE {
        return Vector3::zeros();
    }
    let through = v.dot(a);
    let along = v - a * (through / square);
    let across = a * (ACROSS * through.abs() * through / square);
    (across + along * (ALONG * square.sqrt() * along.norm())) * (0.5 * AIR_DENSITY)
}

/// Returns the derivative of [`drag`] by the area vector \[N/m²\].
fn drag_by_area(a: &Vector3<f64>, v: &Vector3<f64>) -> Matrix3<f64> {
    let square = a.norm_squared();
    if square < f64::MIN_POSITIVE {
        return Matrix3::zeros();
    }
    let size = square.sqrt();
    let n = a / size;
    let (through, flat) = (v.dot(&n), Matrix3::identity() - n * n.transpose());
    // a s|s| / |a|² with s = v·a, by a.
    let across = n * v.transpose() * (2.0 * through.abs())
        + (Matrix3::identity() - n * n.transpose() * 2.0) * (through * through.abs());
    let t = flat * v;
    let speed = t.norm();
    let mut along = t * n.transpose() * speed;
    if speed > 0.0 {
        // |t| t by t, and t = v - (v·n) n by a, times |a|.
        let turned = -(n * t.transpose() + flat * through);
        along += (Matrix3::identity() * speed + t * t.transpose() / speed) * turned;
    }
    (across * ACROSS + along * ALONG) * (0.5 * AIR_DENSITY)
}

impl Potential for WindForce {
    fn kind(&self) -> TermKind {
        TermKind::Wind
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        for t in &self.triangles {
            pairs.extend(PAIRS.iter().map(|&(i, j)| (t[i], t[j])));
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.slots = self
            .triangles
            .iter()
            .map(|t| PAIRS.map(|(i, j)| sparsity.slot(t[i], t[j])))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut here = std::mem::take(&mut self.scratch);
        here.fill(Vector3::zeros());
        self.add(x, &mut here);
        let mut sum = 0.0;
        for i in 0..x.len() {
            sum -= 0.5 * (self.accepted_force[i] + here[i]).dot(&(x[i] - self.accepted[i]));
        }
        self.scratch = here;
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.add(x, force);
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        // Its eigenvalues have both signs: without it the rest is convex.
        let kept = 1.0 - hessian_modification;
        if kept <= 0.0 {
            return;
        }
        for (t, slots) in self.triangles.iter().zip(&self.slots) {
            let third = self.third_by_corner(t, x);
            for (&(i, j), &slot) in PAIRS.iter().zip(slots) {
                hessian.add(slot, &((third[j] + third[i].transpose()) * (-0.5 * kept)));
            }
        }
    }

    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {}

    fn is_conservative(&self) -> bool {
        false
    }

    fn add_antisymmetric_product(
        &self,
        x: &[Vector3<f64>],
        d: &[Vector3<f64>],
        out: &mut [Vector3<f64>],
    ) {
        for t in &self.triangles {
            let third = self.third_by_corner(t, x);
            let moved = t.map(|v| d[v]);
            // All corners have the same force, so that rows of its derivative are alike and columns
            // are those of the corners.
            let rows = third[0] * moved[0] + third[1] * moved[1] + third[2] * moved[2];
            let sum = moved[0] + moved[1] + moved[2];
            for (&particle, third) in t.iter().zip(&third) {
                out[particle] -= (rows - third.tr_mul(&sum)) * 0.5;
            }
        }
    }

    fn accept(&mut self, x: &[Vector3<f64>]) -> bool {
        self.accepted.clear();
        self.accepted.extend_from_slice(x);
        let mut here = std::mem::take(&mut self.accepted_force);
        here.fill(Vector3::zeros());
        self.add(x, &mut here);
        self.accepted_force = here;
        false
    }

    fn set_motion(&mut self, velocity: &[Vector3<f64>], time: f64) {
        self.velocity.clear();
        self.velocity.extend_from_slice(velocity);
        self.air = self.wind.at(time);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    const WIND: Wind = Wind {
        velocity: Vector3::new(2.0, -1.0, 5.0),
        gust: 0.0,
    };

    /// Two triangles that share an edge, off any plane and of unlike sizes.
    fn shape() -> Vec<Vector3<f64>> {
        [
            [0.0, 0.1, 0.0],
            [1.0, 0.0, 0.3],
            [0.1, 0.8, -0.2],
            [1.2, 1.3, 0.4],
        ]
        .map(Vector3::from)
        .to_vec()
    }

    fn on_shape(wind: Wind) -> WindForce {
        WindForce::new(wind, vec![[0, 1, 2], [1, 3, 2]], &shape())
    }

    fn net(force: &mut WindForce, x: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let mut sum = vec![Vector3::zeros(); x.len()];
        force.add_force(x, &mut sum);
        sum
    }

    fn moved(i: usize, by: f64) -> Vec<Vector3<f64>> {
        let mut x = shape();
        x[i / 3][i % 3] += by;
        x
    }

    /// Central differences of step 1e-5 are off by h² times third derivatives of order 100, and
    /// rounding over h: 1e-8 of the largest number.
    #[test]
    fn at_the_accepted_shape_it_is_the_gradient_of_its_energy() {
        let (x, h) = (shape(), 1e-5);
        let mut force = on_shape(WIND);
        let f = net(&mut force, &x);
        for i in 0..3 * x.len() {
            let slope = (force.energy(&moved(i, h)) - force.energy(&moved(i, -h))) / (2.0 * h);
            assert!((slope + f[i / 3][i % 3]).abs() < 1e-7, "{i}");
        }
    }

    #[test]
    fn its_second_derivative_and_its_antisymmetric_part_make_up_that_of_the_force() {
        let (n, h) = (12, 1e-5);
        let mut force = on_shape(WIND);
        let differences = DMatrix::from_fn(n, n, |row, column| {
            let at =
                |by: f64, force: &mut WindForce| net(force, &moved(column, by))[row / 3][row % 3];
            let mut force = on_shape(WIND);
            -(at(h, &mut force) - at(-h, &mut force)) / (2.0 * h)
        });
        let symmetric = (&differences + differences.transpose()) * 0.5;
        let mut pairs = Vec::new();
        force.add_coupled_pairs(&mut pairs);
        let sparsity = Sparsity::from_pairs(4, pairs);
        force.bind(&sparsity);
        let mut blocks = BlockMatrix::zeros(&sparsity);
        force.add_hessian(&shape(), 0.0, &mut blocks);
        for column in 0..4 {
            for (row, slot) in sparsity.column(column) {
                let expected = symmetric.fixed_view::<3, 3>(3 * row, 3 * column);
                let apart = (blocks.blocks[slot] - expected).amax();
                assert!(apart < 1e-7, "{row} {column}: {apart}");
            }
        }
        let antisymmetric = (&differences - differences.transpose()) * 0.5;
        assert!(antisymmetric.amax() > 0.1, "nothing is tested");
        for column in 0..n {
            let mut unit = vec![Vector3::zeros(); 4];
            unit[column / 3][column % 3] = 1.0;
            let mut product = vec![Vector3::zeros(); 4];
            force.add_antisymmetric_product(&shape(), &unit, &mut product);
            for row in 0..n {
                assert!((product[row / 3][row % 3] - antisymmetric[(row, column)]).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn a_square_across_the_flow_has_the_drag_of_a_plate() {
        let corners = [[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];
        let x: Vec<_> = corners.map(|[x, y]| Vector3::new(x, y, 0.0)).to_vec();
        let wind = Wind {
            velocity: Vector3::new(0.0, 0.0, -6.0),
            gust: 0.0,
        };
        let mut force = WindForce::new(wind, vec![[0, 1, 2], [0, 2, 3]], &x);
        let total: Vector3<f64> = net(&mut force, &x).iter().sum();
        // Hoerner: 1.17 times half ρ v² times the area.
        let drag = 1.17 * 0.5 * 1.204 * 36.0 * 0.25;
        assert!((total - Vector3::new(0.0, 0.0, -drag)).norm() < 1e-14 * drag);
    }

    #[test]
    fn it_is_linear_in_the_area_and_the_same_from_either_side() {
        let force = net(&mut on_shape(WIND), &shape());
        let grown: Vec<_> = shape().iter().map(|p| p * 3.0).collect();
        let mut turned = on_shape(WIND);
        turned.triangles = vec![[1, 0, 2], [3, 1, 2]];
        let larger = net(&mut on_shape(WIND), &grown);
        let back = net(&mut turned, &shape());
        for ((f, larger), back) in force.iter().zip(&larger).zip(&back) {
            assert!((larger - f * 9.0).norm() < 1e-13 * larger.norm());
            assert!((back - f).norm() < 1e-13 * back.norm());
        }
    }

    #[test]
    fn cloth_that_moves_with_the_air_feels_nothing() {
        let mut force = on_shape(WIND);
        force.set_motion(&[WIND.velocity; 4], 3.0);
        assert!(net(&mut force, &shape()).iter().all(|f| f.norm() == 0.0));
        // and against still air it is dragged back
        let mut still = on_shape(Wind {
            velocity: Vector3::zeros(),
            gust: 0.3,
        });
        assert!(net(&mut still, &shape()).iter().all(|f| f.norm() == 0.0));
        still.set_motion(&[Vector3::new(0.0, 0.0, 1.0); 4], 3.0);
        let total: Vector3<f64> = net(&mut still, &shape()).iter().sum();
        assert!(total.z < 0.0);
    }
}
