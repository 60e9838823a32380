//! Matrices and vectors of Newton's method, as both minimizers need them.

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::model::system::System;
use nalgebra::{Matrix3, Vector3};
use seamster_cholesky::{Cholesky, FactorMemory, OutOfMemory};

/// Scratch memory of Newton's method on one system.
pub(crate) struct NewtonWorkspace {
    pub(crate) sparsity: Sparsity,
    pub(crate) hessian: BlockMatrix,
    pub(crate) cholesky: Cholesky,
    /// Negative gradient of the objective \[N\].
    pub(crate) force: Vec<Vector3<f64>>,
    /// Newton step \[m\].
    pub(crate) step: Vec<Vector3<f64>>,
    /// Positions that a line search tries \[m\].
    pub(crate) trial: Vec<Vector3<f64>>,
}

impl NewtonWorkspace {
    /// Lays out the matrices of `system`.
    ///
    /// # Errors
    /// [`OutOfMemory`] if there is none for the factor.
    pub(crate) fn new(system: &mut System<'_>) -> Result<Self, OutOfMemory> {
        let sparsity = system.bind();
        let count = system.particle_count();
        Ok(Self {
            hessian: BlockMatrix::zeros(&sparsity),
            cholesky: sparsity.cholesky(FactorMemory::default())?,
            sparsity,
            force: vec![Vector3::zeros(); count],
            step: vec![Vector3::zeros(); count],
            trial: vec![Vector3::zeros(); count],
        })
    }

    /// Lays the matrices out anew, for couplings that have come.
    ///
    /// # Errors
    /// [`OutOfMemory`] if there is none for the factor; the matrices are then of no use.
    pub(crate) fn lay_out(&mut self, system: &mut System<'_>) -> Result<(), OutOfMemory> {
        self.sparsity = system.bind();
        self.hessian = BlockMatrix::zeros(&self.sparsity);
        self.cholesky = self.sparsity.cholesky(self.cholesky.take_memory())?;
        Ok(())
    }

    /// Solves for the step by the last factor.
    pub(crate) fn solve(&mut self) {
        self.step.copy_from_slice(&self.force);
        self.cholesky.solve(&mut self.step);
    }

    /// Returns the decrease of the objective per share of the step \[J\].
    pub(crate) fn slope(&self) -> f64 {
        self.step
            .iter()
            .zip(&self.force)
            .map(|(d, f)| d.dot(f))
            .sum()
    }

    /// Returns the furthest that the step moves any particle \[m\].
    pub(crate) fn max_displacement(&self) -> f64 {
        self.step
            .iter()
            .map(Vector3::norm_squared)
            .fold(0.0, f64::max)
            .sqrt()
    }
}

/// Adds `weight` of each particle's mass to its diagonal block of `matrix`.
pub(crate) fn add_inertia(
    matrix: &mut BlockMatrix,
    sparsity: &Sparsity,
    mass: &[f64],
    weight: impl Fn(f64) -> f64,
) {
    for (i, &mass) in mass.iter().enumerate() {
        matrix.add_diagonal(sparsity.diagonal(i), &(Matrix3::identity() * weight(mass)));
    }
}
