//! Forward and backward substitution.

use crate::symbolic::{Front, Symbolic};
use crate::tiles::{TILE_ROWS, TileColumn};
use pulp::{Arch, Simd, WithSimd};

/// Solves with `factor`: `x`, in the order of elimination, holds the right side and becomes the
/// solution.
pub(crate) fn solve(arch: Arch, symbolic: &Symbolic, factor: &[TileColumn], x: &mut [f64]) {
    arch.dispatch(Substitution {
        symbolic,
        factor,
        x,
    });
}

struct Substitution<'s> {
    symbolic: &'s Symbolic,
    factor: &'s [TileColumn],
    x: &'s mut [f64],
}

impl WithSimd for Substitution<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match S::F64_LANES {
            4 => self.run::<S, 3>(simd),
            2 => self.run::<S, 6>(simd),
            _ => self.run::<S, TILE_ROWS>(simd),
        }
    }
}

impl Substitution<'_> {
    #[inline(always)]
    fn run<S: Simd, const VECTORS: usize>(self, simd: S) {
        for front in &self.symbolic.fronts {
            let panel = &self.factor[front.panel..front.panel + front.panel_len()];
            forward::<S, VECTORS>(simd, front, panel, self.x);
        }
        for front in self.symbolic.fronts.iter().rev() {
            let panel = &self.factor[front.panel..front.panel + front.panel_len()];
            backward::<S, VECTORS>(simd, front, panel, self.x);
        }
    }
}

/// Ranks of the vertices below, tile by tile.
fn below_tiles(front: &Front) -> impl Iterator<Item = &[usize]> {
    front.below.chunks(TILE_ROWS / 3)
}

#[inline(always)]
fn forward<S: Simd, const VECTORS: usize>(
    simd: S,
    front: &Front,
    panel: &[TileColumn],
    x: &mut [f64],
) {
    let columns = front.columns();
    let (head, later) = x.split_at_mut(3 * front.own.end);
    let own = &mut head[3 * front.own.start..];
    let (own_rows, rows_below) = panel.split_at(front.tile_rows()[0] * columns);
    for (tile, row) in own_rows.chunks_exact(columns).enumerate() {
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
    for (row, ranks) in rows_below.chunks_exact(columns).zip(below_tiles(front)) {
        let product = multiply::<S, VECTORS>(simd, row, own);
        for (&rank, product) in ranks.iter().zip(product.chunks_exact(3)) {
            let first = 3 * (rank - front.own.end);
            for (x, product) in later[first..first + 3].iter_mut().zip(product) {
                *x -= product;
            }
        }
    }
}

#[inline(always)]
fn backward<S: Simd, const VECTORS: usize>(
    simd: S,
    front: &Front,
    panel: &[TileColumn],
    x: &mut [f64],
) {
    let columns = front.columns();
    let (head, later) = x.split_at_mut(3 * front.own.end);
    let own = &mut head[3 * front.own.start..];
    let (own_rows, rows_below) = panel.split_at(front.tile_rows()[0] * columns);
    for (row, ranks) in rows_below.chunks_exact(columns).zip(below_tiles(front)) {
        let mut known = [0.0; TILE_ROWS];
        for (known, &rank) in known.chunks_exact_mut(3).zip(ranks) {
            let first = 3 * (rank - front.own.end);
            known.copy_from_slice(&later[first..first + 3]);
        }
        subtract_transposed::<S, VECTORS>(simd, own, row, &known);
    }
    for (tile, row) in own_rows.chunks_exact(columns).enumerate().rev() {
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
