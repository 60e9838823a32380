//! Sparse Cholesky factors of symmetric positive definite matrices in f64: one symbolic
//! factorization, many numeric ones in the same memory.
//!
//! A crate of its own because faer is generic: used from a large crate, its kernels are compiled
//! again with every change of that crate, and at that crate's optimization level.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// The sparsity of a matrix, its ordering, and the memory for its factor.
pub struct Cholesky {
    column_start: Vec<usize>,
    rows: Vec<usize>,
    symbolic: SymbolicCholesky<usize>,
    factor: Vec<f64>,
    memory: MemBuffer,
}

/// The matrix is not positive definite to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotPositiveDefinite;

/// There is no memory for the factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfMemory;

impl Cholesky {
    /// Analyzes the lower triangle of a matrix: the rows of column `j` are
    /// `rows[column_start[j]..column_start[j + 1]]`, ascending. Columns are eliminated as `order`
    /// lists them; approximate minimum degree if it is absent.
    ///
    /// # Errors
    /// [`OutOfMemory`] if the factor does not fit.
    ///
    /// # Panics
    /// If `column_start` and `rows` are not such a triangle, or `order` does not list every column
    /// once.
    pub fn new(
        column_start: Vec<usize>,
        rows: Vec<usize>,
        order: Option<&[usize]>,
    ) -> Result<Self, OutOfMemory> {
        let size = column_start.len() - 1;
        let pattern = SymbolicSparseColMatRef::new_checked(size, size, &column_start, None, &rows);
        let parameters = CholeskySymbolicParams::default();
        let place = order.map(inverse);
        let ordering = match (order, &place) {
            (Some(order), Some(place)) => {
                SymmetricOrdering::Custom(PermRef::new_checked(order, place, size))
            }
            _ => SymmetricOrdering::Amd,
        };
        let symbolic = factorize_symbolic_cholesky(pattern, Side::Lower, ordering, parameters)
            .map_err(|_| OutOfMemory)?;
        let scratch = symbolic
            .factorize_numeric_llt_scratch::<f64>(Par::Seq, faer::Spec::default())
            .or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        let memory = MemBuffer::try_new(scratch).map_err(|_| OutOfMemory)?;
        Ok(Self {
            factor: vec![0.0; symbolic.len_val()],
            column_start,
            rows,
            symbolic,
            memory,
        })
    }

    /// Returns the count of numbers stored in the factor.
    pub fn factor_len(&self) -> usize {
        self.factor.len()
    }

    /// Factors the matrix of these values, which lie as `rows` given to [`Cholesky::new`].
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] if a pivot is not positive; the factor is then of no use.
    pub fn factorize(&mut self, values: &[f64]) -> Result<(), NotPositiveDefinite> {
        let size = self.column_start.len() - 1;
        let pattern =
            SymbolicSparseColMatRef::new_checked(size, size, &self.column_start, None, &self.rows);
        self.symbolic
            .factorize_numeric_llt(
                &mut self.factor,
                SparseColMatRef::new(pattern, values),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut self.memory),
                faer::Spec::default(),
            )
            .map(|_| ())
            .map_err(|_| NotPositiveDefinite)
    }

    /// Solves with the last factor: `x` holds the right side and becomes the solution.
    pub fn solve(&mut self, x: &mut [f64]) {
        let size = x.len();
        let right_side = MatMut::from_column_major_slice_mut(x, size, 1);
        LltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            right_side,
            Par::Seq,
            MemStack::new(&mut self.memory),
        );
    }
}

/// Returns the place of each column in `order`.
fn inverse(order: &[usize]) -> Vec<usize> {
    let mut place = vec![0; order.len()];
    order
        .iter()
        .enumerate()
        .for_each(|(i, &column)| place[column] = i);
    place
}
