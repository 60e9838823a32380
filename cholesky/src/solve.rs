//! Forward and backward substitution.

use crate::symbolic::{Front, Symbolic};
use crate::tiles::{TILE_ROWS, TILE_VERTICES, TileColumn, TileOperation, run};
use pulp::{Arch, Simd};

/// Solves with `factor`: `x`, in the order of elimination, holds the right side and becomes the
/// solution.
pub(crate) fn solve(arch: Arch, symbolic: &Symbolic, factor: &[TileColumn], x: &mut [f64]) {
    let substitution = Substitution {
        symbolic,
        factor,
        x,
    };
    run(arch, substitution);
}

struct Substitution<'s> {
    symbolic: &'s Symbolic,
    factor: &'s [TileColumn],
    x: &'s mut [f64],
}

impl TileOperation for Substitution<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd, const VECTORS: usize>(self, simd: S) {
        for front in &self.symbolic.fronts {
            forward::<S, VECTORS>(simd, &FrontPanel::new(front, self.factor), self.x);
        }
        for front in self.symbolic.fronts.iter().rev() {
            backward::<S, VECTORS>(simd, &FrontPanel::new(front, self.factor), self.x);
        }
    }
}

/// A front and its part of the factor.
struct FrontPanel<'f> {
    front: &'f Front,
    own_rows: &'f [TileColumn],
    rows_below: &'f [TileColumn],
}

impl<'f> FrontPanel<'f> {
    #[inline(always)]
    fn new(front: &'f Front, factor: &'f [TileColumn]) -> Self {
        let panel = &factor[front.panel..front.panel + front.panel_len()];
        let (own_rows, rows_below) = panel.split_at(front.tile_rows()[0] * front.columns());
        Self {
            front,
            own_rows,
            rows_below,
        }
    }

    /// Iterates over the tile rows of its own vertices.
    #[inline(always)]
    fn own(&self) -> impl DoubleEndedIterator<Item = (usize, &[TileColumn])> + ExactSizeIterator {
        self.own_rows.chunks_exact(self.front.columns()).enumerate()
    }

    /// Iterates over the tile rows of the vertices below, with the places of these in what follows
    /// the front's own.
    #[inline(always)]
    fn below(&self) -> impl Iterator<Item = (&[TileColumn], impl Iterator<Item = usize>)> {
        let rows = self.rows_below.chunks_exact(self.front.columns());
        let end = self.front.own.end;
        let tiles = self.front.below.chunks(TILE_VERTICES);
        rows.zip(tiles.map(move |ranks| ranks.iter().map(move |rank| 3 * (rank - end))))
    }

    /// Returns the values of its own vertices and those of the later ones.
    #[inline(always)]
    fn split<'x>(&self, x: &'x mut [f64]) -> (&'x mut [f64], &'x mut [f64]) {
        let (head, later) = x.split_at_mut(3 * self.front.own.end);
        (&mut head[3 * self.front.own.start..], later)
    }
}

#[inline(always)]
fn forward<S: Simd, const VECTORS: usize>(simd: S, panel: &FrontPanel<'_>, x: &mut [f64]) {
    let (own, later) = panel.split(x);
    for (tile, row) in panel.own() {
        let before = tile * TILE_ROWS;
        let (earlier, rest) = own.split_at_mut(before);
        let product = multiply::<S, VECTORS>(simd, &row[..before], earlier);
        let width = TILE_ROWS.min(rest.len());
        for j in 0..width {
            rest[j] -= product[j];
        }
        for (j, column) in row[before..before + width].iter().enumerate() {
            let value = rest[j] * column[j];
            rest[j] = value;
            for r in j + 1..width {
                rest[r] -= column[r] * value;
            }
        }
    }
    for (row, places) in panel.below() {
        let product = multiply::<S, VECTORS>(simd, row, own);
        for (first, product) in places.zip(product.chunks_exact(3)) {
            for (x, product) in later[first..first + 3].iter_mut().zip(product) {
                *x -= product;
            }
        }
    }
}

#[inline(always)]
fn backward<S: Simd, const VECTORS: usize>(simd: S, panel: &FrontPanel<'_>, x: &mut [f64]) {
    let (own, later) = panel.split(x);
    for (row, places) in panel.below() {
        let mut known = [0.0; TILE_ROWS];
        for (known, first) in known.chunks_exact_mut(3).zip(places) {
            known.copy_from_slice(&later[first..first + 3]);
        }
        subtract_transposed::<S, VECTORS>(simd, own, row, &known);
    }
    for (tile, row) in panel.own().rev() {
        let before = tile * TILE_ROWS;
        let (earlier, rest) = own.split_at_mut(before);
        let width = TILE_ROWS.min(rest.len());
        let mut known = [0.0; TILE_ROWS];
        for j in (0..width).rev() {
            let column = &row[before + j];
            let sum: f64 = (j + 1..width).map(|r| column[r] * known[r]).sum();
            known[j] = (rest[j] - sum) * column[j];
            rest[j] = known[j];
        }
        subtract_transposed::<S, VECTORS>(simd, earlier, &row[..before], &known);
    }
}

/// Returns the product of a tile row with `x`.
#[inline(always)]
fn multiply<S: Simd, const VECTORS: usize>(
    simd: S,
    row: &[TileColumn],
    x: &[f64],
) -> [f64; TILE_ROWS] {
    let mut sum = [simd.splat_f64s(0.0); VECTORS];
    for (column, &x) in row.iter().zip(x) {
        let x = simd.splat_f64s(x);
        for (sum, &column) in sum.iter_mut().zip(S::as_simd_f64s(column).0) {
            *sum = simd.mul_add_e_f64s(column, x, *sum);
        }
    }
    let mut product = [0.0; TILE_ROWS];
    S::as_mut_simd_f64s(&mut product).0.copy_from_slice(&sum);
    product
}

/// Subtracts the product of the transpose of a tile row with `known` from `x`.
#[inline(always)]
fn subtract_transposed<S: Simd, const VECTORS: usize>(
    simd: S,
    x: &mut [f64],
    row: &[TileColumn],
    known: &[f64; TILE_ROWS],
) {
    let known = S::as_simd_f64s(known).0;
    for (x, column) in x.iter_mut().zip(row) {
        let mut sum = simd.splat_f64s(0.0);
        for (&column, &known) in S::as_simd_f64s(column).0.iter().zip(known) {
            sum = simd.mul_add_e_f64s(column, known, sum);
        }
        *x -= simd.reduce_sum_f64s(sum);
    }
}
