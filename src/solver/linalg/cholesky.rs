//! Cholesky factors of block matrices.

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::linalg::ordering;
use nalgebra::Vector3;
use seamster_cholesky::{Cholesky, NotPositiveDefinite, OutOfMemory};

/// The factor of a symmetric positive definite block matrix.
pub(crate) struct BlockCholesky {
    cholesky: Cholesky,
    values: Vec<f64>,
    right_side: Vec<f64>,
}

impl BlockCholesky {
    /// Orders (nested dissection) and analyzes the sparsity.
    pub(crate) fn new(sparsity: &Sparsity) -> Result<Self, OutOfMemory> {
        let (column_start, rows) = scalar_pattern(sparsity);
        let (size, stored) = (column_start.len() - 1, rows.len());
        let order = ordering::order(sparsity);
        let order: Vec<usize> = order
            .iter()
            .flat_map(|&i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect();
        let cholesky = Cholesky::new(column_start, rows, Some(&order))?;
        Ok(Self {
            cholesky,
            values: vec![0.0; stored],
            right_side: vec![0.0; size],
        })
    }

    /// Returns the count of numbers stored in the factor.
    pub(crate) fn factor_len(&self) -> usize {
        self.cholesky.factor_len()
    }

    /// Factors `matrix`.
    pub(crate) fn factorize(
        &mut self,
        sparsity: &Sparsity,
        matrix: &BlockMatrix,
    ) -> Result<(), NotPositiveDefinite> {
        self.gather(sparsity, matrix);
        self.cholesky.factorize(&self.values)
    }

    /// Solves with the last factor: `x` holds the right side and becomes the solution.
    pub(crate) fn solve(&mut self, x: &mut [Vector3<f64>]) {
        for (scalar, vector) in self.right_side.chunks_exact_mut(3).zip(x.iter()) {
            scalar.copy_from_slice(vector.as_slice());
        }
        self.cholesky.solve(&mut self.right_side);
        for (vector, scalar) in x.iter_mut().zip(self.right_side.chunks_exact(3)) {
            vector.copy_from_slice(scalar);
        }
    }

    fn gather(&mut self, sparsity: &Sparsity, matrix: &BlockMatrix) {
        let mut k = 0;
        for column in 0..sparsity.particle_count() {
            for c in 0..3 {
                for (row, slot) in sparsity.column(column) {
                    let block = &matrix.blocks[slot];
                    let first = if row == column { c } else { 0 };
                    for r in first..3 {
                        self.values[k] = block[(r, c)];
                        k += 1;
                    }
                }
            }
        }
    }
}

/// Returns column starts and rows of the lower triangle, number by number, in the order in which
/// [`BlockCholesky::gather`] walks it.
fn scalar_pattern(sparsity: &Sparsity) -> (Vec<usize>, Vec<usize>) {
    let mut column_start = vec![0];
    let mut rows = Vec::with_capacity(9 * sparsity.block_count());
    for column in 0..sparsity.particle_count() {
        for c in 0..3 {
            for (row, _) in sparsity.column(column) {
                let first = if row == column { c } else { 0 };
                rows.extend((first..3).map(|r| 3 * row + r));
            }
            column_start.push(rows.len());
        }
    }
    (column_start, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector, Matrix3};

    #[test]
    fn solution_matches_a_dense_factor() {
        let sparsity = Sparsity::from_pairs(4, vec![(0, 1), (2, 1), (3, 0), (2, 3)]);
        let mut matrix = BlockMatrix::zeros(&sparsity);
        let mut dense = DMatrix::<f64>::zeros(12, 12);
        let mut seed = 1.0_f64;
        for (a, b) in [(0, 1), (2, 1), (3, 0), (2, 3)] {
            let block = Matrix3::from_fn(|_, _| {
                seed = (seed * 16807.0) % 2_147_483_647.0;
                seed / 2_147_483_647.0 - 0.5
            });
            matrix.add(sparsity.slot(a, b), &block);
            dense.view_mut((3 * a, 3 * b), (3, 3)).copy_from(&block);
            dense
                .view_mut((3 * b, 3 * a), (3, 3))
                .copy_from(&block.transpose());
        }
        for i in 0..4 {
            matrix.add_diagonal(sparsity.diagonal(i), &(Matrix3::identity() * 6.0));
            for r in 0..3 {
                dense[(3 * i + r, 3 * i + r)] = 6.0;
            }
        }
        let right: Vec<_> = (0..4)
            .map(|i| Vector3::new(f64::from(i), 1.0, -2.0))
            .collect();
        let mut solution = right.clone();
        let mut cholesky = BlockCholesky::new(&sparsity).expect("small");
        cholesky
            .factorize(&sparsity, &matrix)
            .expect("diagonally dominant");
        cholesky.solve(&mut solution);
        let exact = dense
            .clone()
            .lu()
            .solve(&DVector::from_iterator(
                12,
                right.iter().flat_map(|v| v.iter().copied()),
            ))
            .expect("regular");
        for (i, v) in solution.iter().enumerate() {
            for r in 0..3 {
                // Condition number below 10 (Gershgorin), so a few hundred units of rounding are
                // ample.
                assert!((v[r] - exact[3 * i + r]).abs() < 1e-13);
            }
        }
        assert!(
            (matrix.quadratic_form(&sparsity, &solution)
                - solution
                    .iter()
                    .zip(&right)
                    .map(|(x, b)| x.dot(b))
                    .sum::<f64>())
            .abs()
                < 1e-12
        );
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        let sparsity = Sparsity::from_pairs(1, vec![]);
        let mut matrix = BlockMatrix::zeros(&sparsity);
        matrix.add_diagonal(0, &Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0)));
        assert!(
            BlockCholesky::new(&sparsity)
                .expect("small")
                .factorize(&sparsity, &matrix)
                .is_err()
        );
    }
}
