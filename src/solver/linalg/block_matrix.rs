//! Sparsity of the Hessian, and the symmetric matrix of 3 x 3 blocks laid out after it.

use nalgebra::{Matrix3, Vector3};
use seamster_cholesky::{Cholesky, FactorMemory, OutOfMemory};

/// Lower triangle of a symmetric block matrix, column by column, rows ascending: the diagonal block
/// comes first in each column.
#[derive(Clone, Debug)]
pub(crate) struct Sparsity {
    column_start: Vec<usize>,
    rows: Vec<usize>,
}

impl Sparsity {
    /// Returns the sparsity in which the particles of each pair act on each other, and each on
    /// itself.
    pub(crate) fn from_pairs(particle_count: usize, mut pairs: Vec<(usize, usize)>) -> Self {
        // (column, row) with column <= row: the lower triangle.
        for pair in &mut pairs {
            *pair = (pair.0.min(pair.1), pair.0.max(pair.1));
        }
        pairs.extend((0..particle_count).map(|i| (i, i)));
        pairs.sort_unstable();
        pairs.dedup();
        let mut column_start = vec![0; particle_count + 1];
        for &(column, _) in &pairs {
            column_start[column + 1] += 1;
        }
        for column in 0..particle_count {
            column_start[column + 1] += column_start[column];
        }
        Self {
            column_start,
            rows: pairs.into_iter().map(|(_, row)| row).collect(),
        }
    }

    /// Returns the number of particles.
    pub(crate) fn particle_count(&self) -> usize {
        self.column_start.len() - 1
    }

    /// Lays out the factor of a matrix of this sparsity in `memory`, or more.
    ///
    /// # Errors
    /// [`OutOfMemory`] if there is none.
    pub(crate) fn cholesky(&self, memory: FactorMemory) -> Result<Cholesky, OutOfMemory> {
        Cholesky::new((&self.column_start, &self.rows), memory)
    }

    /// Lays out the factor of a matrix of this sparsity, whose particles are some of those that
    /// `whole` factors, in the order of that.
    ///
    /// # Errors
    /// [`OutOfMemory`] if there is none.
    pub(crate) fn cholesky_within(
        &self,
        whole: &Cholesky,
        particles: &[usize],
        memory: FactorMemory,
    ) -> Result<Cholesky, OutOfMemory> {
        whole.restricted((&self.column_start, &self.rows), particles, memory)
    }

    /// Returns the number of blocks stored.
    pub(crate) fn block_count(&self) -> usize {
        self.rows.len()
    }

    /// Returns the place of the block of particles `a` and `b`.
    pub(crate) fn slot(&self, a: usize, b: usize) -> Slot {
        self.find(a, b)
            .expect("every pair that a force couples was declared by it")
    }

    /// Returns the place of the block of particles `a` and `b`, if there is one.
    pub(crate) fn find(&self, a: usize, b: usize) -> Option<Slot> {
        let (column, row) = (a.min(b), a.max(b));
        let start = self.column_start[column];
        let rows = &self.rows[start..self.column_start[column + 1]];
        let offset = rows.binary_search(&row).ok()?;
        Some(Slot {
            index: start + offset,
            transposed: a < b,
        })
    }

    /// Returns the index of the diagonal block of particle `i`.
    pub(crate) fn diagonal(&self, i: usize) -> usize {
        self.column_start[i]
    }

    /// Returns the blocks of one column: row and index.
    pub(crate) fn column(&self, column: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        (self.column_start[column]..self.column_start[column + 1]).map(|k| (self.rows[k], k))
    }
}

/// Place of the block of two particles, and whether it is stored there transposed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slot {
    index: usize,
    transposed: bool,
}

/// A symmetric matrix of 3 x 3 blocks.
#[derive(Clone, Debug)]
pub(crate) struct BlockMatrix {
    pub(crate) blocks: Vec<Matrix3<f64>>,
}

impl BlockMatrix {
    pub(crate) fn zeros(sparsity: &Sparsity) -> Self {
        Self {
            blocks: vec![Matrix3::zeros(); sparsity.block_count()],
        }
    }

    /// Returns the block of a slot.
    #[cfg(test)]
    pub(crate) fn get(&self, slot: Slot) -> Matrix3<f64> {
        let block = self.blocks[slot.index];
        if slot.transposed {
            block.transpose()
        } else {
            block
        }
    }

    pub(crate) fn clear(&mut self) {
        self.blocks.fill(Matrix3::zeros());
    }

    /// Adds `block`, the derivative of the first particle's force by the second's position, to the
    /// slot of the two.
    #[inline]
    pub(crate) fn add(&mut self, slot: Slot, block: &Matrix3<f64>) {
        if slot.transposed {
            self.blocks[slot.index] += block.transpose();
        } else {
            self.blocks[slot.index] += block;
        }
    }

    /// Adds to a diagonal block by its position.
    #[inline]
    pub(crate) fn add_diagonal(&mut self, index: usize, block: &Matrix3<f64>) {
        self.blocks[index] += block;
    }

    /// Removes fixed particles from the system: their rows and columns become those of the
    /// identity.
    pub(crate) fn constrain(&mut self, sparsity: &Sparsity, is_fixed: &[bool]) {
        for column in 0..sparsity.particle_count() {
            for (row, k) in sparsity.column(column) {
                if is_fixed[row] || is_fixed[column] {
                    self.blocks[k] = if row == column {
                        Matrix3::identity()
                    } else {
                        Matrix3::zeros()
                    };
                }
            }
        }
    }

    /// Removes one coordinate of every particle from the system, likewise.
    pub(crate) fn constrain_axis(&mut self, sparsity: &Sparsity, axis: usize) {
        for column in 0..sparsity.particle_count() {
            for (row, k) in sparsity.column(column) {
                let block = &mut self.blocks[k];
                block.row_mut(axis).fill(0.0);
                block.column_mut(axis).fill(0.0);
                block[(axis, axis)] = if row == column { 1.0 } else { 0.0 };
            }
        }
    }

    /// Returns `x` times the matrix times `x`.
    pub(crate) fn quadratic_form(&self, sparsity: &Sparsity, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        for column in 0..sparsity.particle_count() {
            for (row, k) in sparsity.column(column) {
                let term = x[row].dot(&(self.blocks[k] * x[column]));
                sum += if row == column { term } else { 2.0 * term };
            }
        }
        sum
    }
}
