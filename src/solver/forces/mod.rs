//! The force terms, one file each: an energy, its force and its second derivative on particle positions.

pub(crate) mod bending;
pub(crate) mod contact;
pub(crate) mod fibre;
pub(crate) mod gravity;
pub(crate) mod membrane;
pub(crate) mod pair;
pub(crate) mod sewing;
pub(crate) mod spring;
pub(crate) mod wind;

pub(crate) use crate::solver::forces::bending::{BendForce, BendPatch};
pub(crate) use crate::solver::forces::fibre::FibreForce;
pub(crate) use crate::solver::forces::gravity::Gravity;
pub(crate) use crate::solver::forces::membrane::{ContinuumForce, Membrane};
pub(crate) use crate::solver::forces::pair::{Link, Stencil};
pub(crate) use crate::solver::forces::sewing::SewingForce;
pub(crate) use crate::solver::forces::spring::{Spring, SpringForce};
pub(crate) use crate::solver::forces::wind::WindForce;

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Vector3;

/// One term of the energy of a garment.
///
/// `x` are particle positions \[m\]. Energies are in joules, forces in newtons, second derivatives in newtons per metre.
pub(crate) trait Force {
    /// The name that reports call it by.
    fn name(&self) -> &'static str;

    /// Appends every pair of particles that act on each other through it.
    fn couple(&self, pairs: &mut Vec<(usize, usize)>);

    /// Looks up where its second derivatives go.
    fn bind(&mut self, sparsity: &Sparsity);

    /// Energy \[J\].
    fn energy(&mut self, x: &[Vector3<f64>]) -> f64;

    /// Adds the negative gradient of the energy to `force` \[N\].
    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]);

    /// Adds the second derivative of the energy with the share `convexity` of what may give it negative eigenvalues left out:
    /// all of it at 1, where none is left, nothing at 0.
    fn add_hessian(&mut self, x: &[Vector3<f64>], convexity: f64, hessian: &mut BlockMatrix);

    /// Adds to each particle a bound on the row sum of its second derivatives in the rest shape \[N/m\]:
    /// what limits an explicit step, and what rounding is measured by.
    fn add_stiffness(&self, stiffness: &mut [f64]);

    /// Whether it has no energy: its derivative is not symmetric.
    fn is_skew(&self) -> bool {
        false
    }

    /// Adds to `out` the skew part of the negative derivative of such a force at `x`, times `d`.
    fn add_skew(&self, _x: &[Vector3<f64>], _d: &[Vector3<f64>], _out: &mut [Vector3<f64>]) {}

    /// Told of every accepted shape: what is lagged, or has no energy but from there, is taken anew.
    fn accept(&mut self, _x: &[Vector3<f64>]) {}

    /// Told how the particles move \[m/s\] and what time it is \[s\]: for forces that depend on either.
    fn set_motion(&mut self, _velocity: &[Vector3<f64>], _time: f64) {}

    /// Has it act, while `taut`, as stiffly as it does in any shape like the one at hand: what yields under pressure does not.
    fn set_taut(&mut self, _taut: bool) {}

    /// Adds itself to `stencil` if links and pushes are all that it is; false, and nothing added, if not.
    fn add_to_stencil(&self, _stencil: &mut Stencil) -> bool {
        false
    }
}

#[cfg(test)]
mod tests;
