//! Friction between layers of cloth that sticks and slips, as on the body (`contact/body.rs`).
//!
//! Two features that touch are tied at their closest points by a tangential spring that gives way
//! at μ N (P. A. Cundall, O. D. L. Strack, "A discrete numerical model for granular assemblies",
//! Géotechnique 29(1), 1979): energy k/2 |u|² up to the slip s = μ N / k, μ N (|u| - s/2) beyond.
//! N, the closest points and the tangent plane are those of the last accepted step (lagged), so
//! that within a step friction has an energy.
//!
//! # Limitations
//! Features that come to touch are tied without tension. What a pair held is lost when it parts:
//! where a vertex leaves a triangle for the next, the new pair holds as much once the layers have
//! slid on by s, some micrometers.

use super::candidates::FeaturePair;
use super::coupling::add_blocks;
use super::law::respond;
use super::proximity::{Features, Proximity};
use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::contact::layer;
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Slip of one step that is more than rounding \[m\].
const SLIP_FELT: f64 = 1e-7;

/// Friction of the pairs that touched in the accepted shape.
#[derive(Clone, Debug)]
pub(super) struct LayerFriction {
    /// Coefficient of the cloth at each particle; that of a pair is the least of its corners.
    coefficient: Vec<f64>,
    /// By their pairs, ascending.
    ties: Vec<Tie>,
    active: ActiveElements,
}

/// The spring between two features that touch.
#[derive(Clone, Copy, Debug)]
struct Tie {
    features: Features,
    corners: [usize; 4],
    /// Of the corners, in the vector between the points that it ties.
    coefficients: [f64; 4],
    normal: Vector3<f64>,
    /// Axes that turn with the features.
    axes: Matrix3<f64>,
    /// By how much it was drawn out already, less the vector between the points that it tied \[m\].
    offset: Vector3<f64>,
    /// \[N/m\]
    stiffness: f64,
    /// Largest force: μ N \[N\].
    limit: f64,
    /// True if the last step slipped: then the next is taken to slip on.
    slipping: bool,
}

impl Tie {
    fn key(&self) -> ([usize; 4], Features) {
        (self.corners, self.features)
    }

    /// Returns the vector between the points that it ties \[m\].
    fn between(&self, x: &[Vector3<f64>]) -> Vector3<f64> {
        let terms = self.corners.iter().zip(self.coefficients);
        terms.map(|(&i, c)| x[i] * c).sum()
    }

    /// Returns by how much it is drawn out \[m\].
    fn give(&self, x: &[Vector3<f64>]) -> Vector3<f64> {
        tangential(&(self.between(x) + self.offset), &self.normal)
    }

    fn energy(&self, x: &[Vector3<f64>]) -> f64 {
        let (length, slip) = (self.give(x).norm(), self.limit / self.stiffness);
        if length <= slip {
            0.5 * self.stiffness * length * length
        } else {
            self.limit * (length - 0.5 * slip)
        }
    }

    /// Returns the force on the first feature \[N\].
    fn force(&self, x: &[Vector3<f64>]) -> Vector3<f64> {
        let give = self.give(x);
        let length = give.norm();
        if self.stiffness * length <= self.limit {
            give * -self.stiffness
        } else {
            give * (-self.limit / length)
        }
    }

    /// Returns the second derivative of the energy by the vector between the tied points \[N/m\].
    fn second_derivative(&self, x: &[Vector3<f64>]) -> Matrix3<f64> {
        let give = self.give(x);
        let length = give.norm();
        let plane = Matrix3::identity() - self.normal * self.normal.transpose();
        let sticks = self.stiffness * length <= self.limit && !self.slipping;
        if length == 0.0 || sticks {
            return plane * self.stiffness;
        }
        let along = give / length;
        (plane - along * along.transpose()) * (self.limit / length)
    }
}

fn tangential(v: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
    v - normal * normal.dot(v)
}

/// Adds the second derivative of the energy of a tie to `hessian`: `block` by the vector between
/// the points that it ties.
fn add_tie(tie: &Tie, block: &Matrix3<f64>, sparsity: &Sparsity, hessian: &mut BlockMatrix) {
    let c = tie.coefficients;
    let of_ends = |i: usize, j: usize| block * (c[i] * c[j]);
    // The bound of `add_pair`.
    let bound = |i: usize| block * (2.0 * c[i].abs());
    add_blocks((sparsity, hessian), &tie.corners, of_ends, bound);
}

/// Returns axes that turn with the triangle, or with the two edges, of a pair.
fn axes(pair: &FeaturePair, x: &[Vector3<f64>]) -> Matrix3<f64> {
    let [p, a, b, c] = pair.gather(x);
    let (along, other) = match pair.features {
        Features::VertexTriangle => (b - a, c - a),
        Features::Edges => (a - p, c - b),
    };
    let unit = |v: Vector3<f64>| v.try_normalize(0.0).unwrap_or_default();
    let (along, normal) = (unit(along), unit(along.cross(&other)));
    Matrix3::from_columns(&[along, normal.cross(&along), normal])
}

impl LayerFriction {
    /// Returns the friction of cloth with these coefficients at its particles.
    pub(super) fn new(coefficient: Vec<f64>) -> Self {
        Self {
            coefficient,
            ties: vec![],
            active: ActiveElements::default(),
        }
    }

    /// Lets only those ties act that have a particle of `moving`.
    pub(super) fn narrow(&mut self, moving: Option<&[bool]>) {
        let ties = &self.ties;
        self.active.narrow(moving, ties.len(), |k, moving| {
            let corners = ties[k].corners.iter();
            corners.copied().any(|i| moving.get(i) == Some(&true))
        });
    }

    /// Returns the energy of the ties that act \[J\].
    pub(super) fn energy(&self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.active.for_each(self.ties.len(), |k| {
            sum += self.ties[k].energy(x);
        });
        sum
    }

    /// Adds the forces of the ties that act.
    pub(super) fn add_force(&self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.active.for_each(self.ties.len(), |k| {
            let tie = &self.ties[k];
            let held = tie.force(x);
            for (&i, c) in tie.corners.iter().zip(tie.coefficients) {
                if let Some(force) = force.get_mut(i) {
                    *force += held * c;
                }
            }
        });
    }

    /// Adds the second derivative of the energy of the ties that act.
    pub(super) fn add_hessian(
        &self,
        x: &[Vector3<f64>],
        sparsity: &Sparsity,
        hessian: &mut BlockMatrix,
    ) {
        self.active.for_each(self.ties.len(), |k| {
            let tie = &self.ties[k];
            add_tie(tie, &tie.second_derivative(x), sparsity, hessian);
        });
    }

    /// Begins to take `x` as an accepted shape.
    pub(super) fn renew<'a>(&'a mut self, x: &'a [Vector3<f64>]) -> Renewal<'a> {
        Renewal {
            ties: Vec::with_capacity(self.ties.len()),
            friction: self,
            x,
            slipped: false,
        }
    }
}

/// The ties of a newly accepted shape, of which the pairs that touch are told one by one.
pub(super) struct Renewal<'a> {
    friction: &'a mut LayerFriction,
    x: &'a [Vector3<f64>],
    ties: Vec<Tie>,
    slipped: bool,
}

impl Renewal<'_> {
    /// Ties a pair that touches, drawn out as far as it was and the step has drawn it, but no
    /// further than it holds.
    pub(super) fn tie(&mut self, pair: &FeaturePair, proximity: &Proximity) {
        let coefficients = pair.corners.map(|i| self.friction.coefficient[i]);
        let coefficient = coefficients.into_iter().fold(f64::INFINITY, f64::min);
        let pressure = respond(proximity.distance(), pair.thickness).pressure;
        let mut tie = Tie {
            features: pair.features,
            corners: pair.corners,
            coefficients: proximity.coefficients,
            normal: proximity.normal(),
            axes: axes(pair, self.x),
            offset: Vector3::zeros(),
            stiffness: pair.weight * layer::TANGENTIAL,
            limit: coefficient * pair.weight * pressure,
            slipping: false,
        };
        if tie.limit == 0.0 {
            return;
        }
        let before = &self.friction.ties;
        if let Ok(k) = before.binary_search_by_key(&tie.key(), Tie::key) {
            let before = &before[k];
            // As the features turn, so does what was between them: that is no slip.
            let turned = tie.axes * before.axes.tr_mul(&before.offset);
            let give = tangential(&(before.between(self.x) + turned), &tie.normal);
            let (length, slip) = (give.norm(), tie.limit / tie.stiffness);
            tie.slipping = length > slip;
            self.slipped |= length > slip + SLIP_FELT;
            tie.offset = give * if tie.slipping { slip / length } else { 1.0 };
        }
        tie.offset -= tie.between(self.x);
        self.ties.push(tie);
    }

    /// Takes the ties in place of those before; returns true if any slipped.
    pub(super) fn finish(mut self) -> bool {
        self.ties.sort_unstable_by_key(Tie::key);
        self.friction.ties = self.ties;
        self.slipped
    }
}
