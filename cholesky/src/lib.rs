//! Sparse Cholesky factors of symmetric positive definite matrices of 3 x 3 blocks: one symbolic
//! factorization, many numeric ones in the same memory.
//!
//! Multifrontal (I. S. Duff, J. K. Reid, ACM TOMS 9(3), 1983): each separator of a nested
//! dissection and each leaf is eliminated as one dense front. The order of all sums is that of the
//! tree, so the same matrix gives the same bytes.
//!
//! A crate of its own because its kernels are optimized in every profile.

mod dissection;
mod graph;
mod kernel;
mod numeric;
mod solve;
mod symbolic;
mod tiles;

use crate::dissection::Part;
use crate::graph::Graph;
use crate::symbolic::{Front, Symbolic};
use crate::tiles::{TILE_ROWS, TileColumn};
use nalgebra::{Matrix3, Vector3};
use pulp::Arch;
use std::ops::Range;

/// Share of the work of a factorization that is spent on seeing whether it fails where the last one
/// did.
const SMALL_PART: f64 = 0.1;

/// The factor of a matrix, and the memory for it.
pub struct Cholesky {
    arch: Arch,
    symbolic: Symbolic,
    parts: Vec<Part>,
    factor: Vec<TileColumn>,
    stacks: [Vec<TileColumn>; 2],
    /// Front in which the last factorization failed, if it did and few others are needed to see
    /// whether the next one fails there too.
    suspect: Option<usize>,
    /// Right side or solution in the order of elimination.
    vector: Vec<f64>,
}

/// Memory of a factor, for another one.
#[derive(Default)]
pub struct FactorMemory {
    factor: Vec<TileColumn>,
    stacks: [Vec<TileColumn>; 2],
}

/// The matrix is not positive definite to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotPositiveDefinite;

/// There is no memory for the factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfMemory;

impl Cholesky {
    /// Orders and analyzes the lower triangle of a block matrix: the rows of column `j` are
    /// `rows[column_start[j]..column_start[j + 1]]`, ascending, the diagonal first.
    ///
    /// # Errors
    /// [`OutOfMemory`] if the factor does not fit.
    pub fn new(
        matrix @ (column_start, rows): (&[usize], &[usize]),
        memory: FactorMemory,
    ) -> Result<Self, OutOfMemory> {
        let graph = graph_of(column_start, rows);
        let parts = dissection::dissect(&graph);
        Self::dissected(matrix, &graph, parts, memory)
    }

    /// Analyzes a matrix of some of the vertices of this one, which are 0, 1, ... there and
    /// `vertices` here: they are eliminated in the same order, which need not be sought.
    ///
    /// # Errors
    /// [`OutOfMemory`] if the factor does not fit.
    pub fn restricted(
        &self,
        matrix @ (column_start, rows): (&[usize], &[usize]),
        vertices: &[usize],
        memory: FactorMemory,
    ) -> Result<Self, OutOfMemory> {
        let mut place = vec![None; self.symbolic.order.len()];
        for (i, &v) in vertices.iter().enumerate() {
            place[v] = Some(i);
        }
        let parts = dissection::restrict(&self.parts, &place);
        Self::dissected(matrix, &graph_of(column_start, rows), parts, memory)
    }

    fn dissected(
        matrix: (&[usize], &[usize]),
        graph: &Graph,
        parts: Vec<Part>,
        memory: FactorMemory,
    ) -> Result<Self, OutOfMemory> {
        let symbolic = Symbolic::new(matrix, graph, &parts);
        let [even, odd] = memory.stacks;
        let [even_len, odd_len] = symbolic.stack_len;
        Ok(Self {
            arch: Arch::new(),
            factor: resized(memory.factor, symbolic.factor_len)?,
            stacks: [resized(even, even_len)?, resized(odd, odd_len)?],
            suspect: None,
            vector: vec![0.0; 3 * graph.vertex_count()],
            symbolic,
            parts,
        })
    }

    /// Takes the memory of the factor, which is of no use from then on.
    pub fn take_memory(&mut self) -> FactorMemory {
        FactorMemory {
            factor: std::mem::take(&mut self.factor),
            stacks: std::mem::take(&mut self.stacks),
        }
    }

    /// Returns the count of numbers stored in the factor.
    pub fn factor_len(&self) -> usize {
        TILE_ROWS * self.factor.len()
    }

    /// Returns the multiplications and additions of a factorization, in pairs.
    pub fn multiply_adds(&self) -> f64 {
        self.symbolic.multiply_adds()
    }

    /// Factors the matrix of these blocks, which lie as `rows` given to [`Cholesky::new`].
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] if a pivot is not positive; the factor is then of no use.
    pub fn factorize(&mut self, blocks: &[Matrix3<f64>]) -> Result<(), NotPositiveDefinite> {
        if let Some(front) = self.suspect {
            self.factorize_fronts(blocks, self.symbolic.subtree(front))?;
        }
        self.suspect = None;
        self.factorize_fronts(blocks, 0..self.symbolic.fronts.len())
    }

    fn factorize_fronts(
        &mut self,
        blocks: &[Matrix3<f64>],
        fronts: Range<usize>,
    ) -> Result<(), NotPositiveDefinite> {
        let factored = numeric::factorize(
            self.arch,
            (&self.symbolic, fronts),
            blocks,
            &mut self.factor,
            &mut self.stacks,
        );
        factored.map_err(|front| {
            self.suspect = Some(front).filter(|&front| self.is_soon_tried(front));
            NotPositiveDefinite
        })
    }

    /// Returns true if what the factorization of a front needs is a small part of the whole.
    fn is_soon_tried(&self, front: usize) -> bool {
        let needed = &self.symbolic.fronts[self.symbolic.subtree(front)];
        let needed: f64 = needed.iter().map(Front::multiply_adds).sum();
        needed < SMALL_PART * self.multiply_adds()
    }

    /// Solves with the last factor: `x` holds the right side and becomes the solution.
    pub fn solve(&mut self, x: &mut [Vector3<f64>]) {
        let order = &self.symbolic.order;
        for (scalars, &v) in self.vector.chunks_exact_mut(3).zip(order) {
            scalars.copy_from_slice(x[v].as_slice());
        }
        solve::solve(self.arch, &self.symbolic, &self.factor, &mut self.vector);
        for (scalars, &v) in self.vector.chunks_exact(3).zip(order) {
            x[v].copy_from_slice(scalars);
        }
    }
}

/// Returns the graph of a lower triangle.
fn graph_of(column_start: &[usize], rows: &[usize]) -> Graph {
    let count = column_start.len() - 1;
    let entries = (0..count).flat_map(|column| {
        let rows = &rows[column_start[column]..column_start[column + 1]];
        rows.iter().map(move |&row| (column, row))
    });
    Graph::from_pairs(count, entries.filter(|(column, row)| column != row))
}

/// Returns memory for `len` tile columns, with whatever is in it: a factorization writes before it
/// reads.
fn resized(mut memory: Vec<TileColumn>, len: usize) -> Result<Vec<TileColumn>, OutOfMemory> {
    let more = len.saturating_sub(memory.len());
    memory.try_reserve_exact(more).map_err(|_| OutOfMemory)?;
    memory.resize(len, [0.0; TILE_ROWS]);
    Ok(memory)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// Vertices of a grid, each coupled to those around it.
    struct GridMatrix {
        column_start: Vec<usize>,
        rows: Vec<usize>,
        blocks: Vec<Matrix3<f64>>,
    }

    impl GridMatrix {
        fn laid_out(&self) -> (&[usize], &[usize]) {
            (&self.column_start, &self.rows)
        }
    }

    /// Returns memory that would spoil whatever is read before it is written.
    fn used_memory() -> FactorMemory {
        let used = || vec![[f64::NAN; TILE_ROWS]; 40_000];
        FactorMemory {
            factor: used(),
            stacks: [used(), used()],
        }
    }

    /// Returns a matrix of random blocks with `diagonal` on its diagonal.
    fn grid(width: usize, height: usize, diagonal: f64) -> GridMatrix {
        let mut seed = 1.0_f64;
        let mut random = || {
            seed = (seed * 16807.0) % 2_147_483_647.0;
            seed / 2_147_483_647.0 - 0.5
        };
        let (mut column_start, mut rows, mut blocks) = (vec![0], vec![], vec![]);
        for column in 0..width * height {
            rows.push(column);
            blocks.push(Matrix3::from_diagonal_element(diagonal));
            for row in column + 1..width * height {
                let dx = (row % width).abs_diff(column % width);
                let dy = (row / width).abs_diff(column / width);
                if dx.max(dy) == 1 {
                    rows.push(row);
                    blocks.push(Matrix3::from_fn(|_, _| random()));
                }
            }
            column_start.push(rows.len());
        }
        GridMatrix {
            column_start,
            rows,
            blocks,
        }
    }

    fn dense(matrix: &GridMatrix) -> DMatrix<f64> {
        let count = matrix.column_start.len() - 1;
        let mut dense = DMatrix::zeros(3 * count, 3 * count);
        for column in 0..count {
            for k in matrix.column_start[column]..matrix.column_start[column + 1] {
                let (row, block) = (matrix.rows[k], &matrix.blocks[k]);
                dense
                    .view_mut((3 * row, 3 * column), (3, 3))
                    .copy_from(block);
                dense
                    .view_mut((3 * column, 3 * row), (3, 3))
                    .copy_from(&block.transpose());
            }
        }
        dense
    }

    /// Every shape of front occurs: leaves, thick and thin separators, tiles that are not full.
    #[test]
    fn solutions_are_those_of_a_dense_factor() {
        for (width, height) in [(1, 1), (1, 2), (3, 2), (5, 5), (40, 3), (17, 19)] {
            let matrix = grid(width, height, 14.0);
            let count = width * height;
            let right: Vec<_> = (0..count)
                .map(|i| Vector3::new(i as f64, 1.0, -2.0))
                .collect();
            let mut cholesky = Cholesky::new(matrix.laid_out(), used_memory()).expect("small");
            let scalars = DVector::from_iterator(3 * count, right.iter().flatten().copied());
            let exact = dense(&matrix).lu().solve(&scalars).expect("regular");
            // In the same memory, by vectors and without.
            for arch in [cholesky.arch, Arch::Scalar] {
                cholesky.arch = arch;
                cholesky
                    .factorize(&matrix.blocks)
                    .expect("diagonally dominant");
                let mut solution = right.clone();
                cholesky.solve(&mut solution);
                let scalars = solution.iter().flatten().copied();
                let off = (DVector::from_iterator(3 * count, scalars) - &exact).norm();
                // By Gershgorin the eigenvalues are within 14 ± 12, so the condition number is
                // below 13: a few hundred units of rounding are ample.
                assert!(
                    off < 300.0 * f64::EPSILON * exact.norm(),
                    "{width} by {height}, {arch:?}: {off:.1e}"
                );
            }
        }
    }

    /// The matrix of some vertices of another, which are in ascending order.
    fn restricted(matrix: &GridMatrix, vertices: &[usize]) -> GridMatrix {
        let (mut column_start, mut rows, mut blocks) = (vec![0], vec![], vec![]);
        for &column in vertices {
            for k in matrix.column_start[column]..matrix.column_start[column + 1] {
                if let Ok(row) = vertices.binary_search(&matrix.rows[k]) {
                    rows.push(row);
                    blocks.push(matrix.blocks[k]);
                }
            }
            column_start.push(rows.len());
        }
        GridMatrix {
            column_start,
            rows,
            blocks,
        }
    }

    #[test]
    fn a_matrix_of_some_vertices_is_solved_in_the_order_of_all() {
        let matrix = grid(23, 17, 14.0);
        let whole = Cholesky::new(matrix.laid_out(), FactorMemory::default()).expect("small");
        // Every third or a patch: separators are emptied, and the graph falls to pieces.
        let third = (0..23 * 17).step_by(3).collect::<Vec<_>>();
        let patch = (0..23 * 17).filter(|i| i % 23 < 6).collect::<Vec<_>>();
        for vertices in [third, patch, vec![5], vec![]] {
            let part = restricted(&matrix, &vertices);
            let mut cholesky = whole
                .restricted(part.laid_out(), &vertices, used_memory())
                .expect("small");
            cholesky.factorize(&part.blocks).expect("as the whole");
            let mut solution: Vec<_> = vertices.iter().map(|&v| Vector3::x() * v as f64).collect();
            let right =
                DVector::from_iterator(3 * vertices.len(), solution.iter().flatten().copied());
            cholesky.solve(&mut solution);
            let scalars = solution.iter().flatten().copied();
            let product = dense(&part) * DVector::from_iterator(right.len(), scalars);
            // As above: norms and condition are bounded by Gershgorin.
            assert!((product - &right).norm() <= 300.0 * f64::EPSILON * right.norm());
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused_and_the_next_one_is_not() {
        let mut matrix = grid(9, 9, 14.0);
        let mut cholesky =
            Cholesky::new(matrix.laid_out(), FactorMemory::default()).expect("small");
        let middle = matrix.column_start[40];
        matrix.blocks[middle] = Matrix3::from_diagonal(&Vector3::new(14.0, -14.0, 14.0));
        assert_eq!(cholesky.factorize(&matrix.blocks), Err(NotPositiveDefinite));
        // It fails again in the same place, and after that elsewhere.
        assert_eq!(cholesky.factorize(&matrix.blocks), Err(NotPositiveDefinite));
        matrix.blocks[middle] = Matrix3::from_diagonal_element(14.0);
        matrix.blocks[0] = Matrix3::from_diagonal_element(-14.0);
        assert_eq!(cholesky.factorize(&matrix.blocks), Err(NotPositiveDefinite));
        matrix.blocks[0] = Matrix3::from_diagonal_element(14.0);
        assert_eq!(cholesky.factorize(&matrix.blocks), Ok(()));
        matrix.blocks[middle][(0, 0)] = f64::NAN;
        assert_eq!(cholesky.factorize(&matrix.blocks), Err(NotPositiveDefinite));
    }
}
