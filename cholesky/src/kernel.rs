//! Dense factorization of a front, in vector instructions.
//!
//! Left-looking by tiles: everything that earlier columns contribute to a tile is one product,
//! summed up in registers.

use crate::NotPositiveDefinite;
use crate::tiles::{TILE_ROWS, TileColumn, TileOperation, triangle_len};
use pulp::Simd;

/// Columns of a product that are summed up at a time: with three vectors a column there are
/// registers for them.
const GROUP: usize = 3;

/// A front to be factored: its own columns, and its contribution to the parent.
pub(crate) struct FrontFactorization<'f> {
    /// Tile rows of the own vertices, then of those below, each of `columns`.
    pub(crate) panel: &'f mut [TileColumn],
    /// Lower triangle by tile rows; overwritten with what the panel contributes.
    pub(crate) update: &'f mut [TileColumn],
    pub(crate) columns: usize,
    pub(crate) own_tile_rows: usize,
}

impl TileOperation for FrontFactorization<'_> {
    type Output = Result<(), NotPositiveDefinite>;

    #[inline(always)]
    fn run<S: Simd, const VECTORS: usize>(self, simd: S) -> Self::Output {
        let Self {
            panel,
            update,
            columns,
            own_tile_rows,
        } = self;
        for tile in 0..own_tile_rows {
            let before = tile * TILE_ROWS;
            let width = TILE_ROWS.min(columns - before);
            let (above, rest) = panel.split_at_mut((tile + 1) * columns);
            let (earlier, diagonal) = above[tile * columns..].split_at_mut(before);
            let diagonal = &mut diagonal[..width];
            subtract_product::<S, VECTORS, true>(simd, diagonal, earlier, earlier);
            factor_tile(diagonal)?;
            for row in rest.chunks_exact_mut(columns) {
                let (left, own) = row.split_at_mut(before);
                let own = &mut own[..width];
                subtract_product::<S, VECTORS, true>(simd, own, left, earlier);
                solve_tile::<S, VECTORS>(simd, own, diagonal);
            }
        }
        let below = &panel[own_tile_rows * columns..];
        for (t, left) in below.chunks_exact(columns).enumerate() {
            let row = &mut update[triangle_len(t)..triangle_len(t + 1)];
            let tiles = row.chunks_exact_mut(TILE_ROWS);
            for (own, right) in tiles.zip(below.chunks_exact(columns)) {
                subtract_product::<S, VECTORS, false>(simd, own, left, right);
            }
        }
        Ok(())
    }
}

/// Subtracts `left rightᵀ` from the columns of a tile, or from zero.
#[inline(always)]
fn subtract_product<S: Simd, const VECTORS: usize, const FROM_TILE: bool>(
    simd: S,
    tile: &mut [TileColumn],
    left: &[TileColumn],
    right: &[TileColumn],
) {
    for (group, columns) in tile.as_chunks_mut::<GROUP>().0.iter_mut().enumerate() {
        let mut sum = [[simd.splat_f64s(0.0); VECTORS]; GROUP];
        for (left, right) in left.iter().zip(right) {
            let left = S::as_simd_f64s(left).0;
            let right = &right.as_chunks::<GROUP>().0[group];
            for (sum, &right) in sum.iter_mut().zip(right) {
                let right = simd.splat_f64s(right);
                for (sum, &left) in sum.iter_mut().zip(left) {
                    *sum = simd.mul_add_e_f64s(left, right, *sum);
                }
            }
        }
        for (column, sum) in columns.iter_mut().zip(&sum) {
            let column = S::as_mut_simd_f64s(column).0;
            for (value, &sum) in column.iter_mut().zip(sum) {
                *value = if FROM_TILE {
                    simd.sub_f64s(*value, sum)
                } else {
                    simd.neg_f64s(sum)
                };
            }
        }
    }
}

/// Factors the lower triangle of a tile; on its diagonal are the reciprocals then.
#[inline(always)]
fn factor_tile(tile: &mut [TileColumn]) -> Result<(), NotPositiveDefinite> {
    for j in 0..tile.len() {
        let (earlier, rest) = tile.split_at_mut(j);
        let column = &mut rest[0];
        for earlier in earlier.iter() {
            let factor = earlier[j];
            for (value, earlier) in column.iter_mut().zip(earlier) {
                *value -= factor * earlier;
            }
        }
        let pivot = column[j];
        // Not even if it is no number.
        if !(pivot > 0.0 && pivot.is_finite()) {
            return Err(NotPositiveDefinite);
        }
        let reciprocal = pivot.sqrt().recip();
        for value in column.iter_mut() {
            *value *= reciprocal;
        }
        column[j] = reciprocal;
    }
    Ok(())
}

/// Divides a tile by the transpose of a factored one.
#[inline(always)]
fn solve_tile<S: Simd, const VECTORS: usize>(
    simd: S,
    tile: &mut [TileColumn],
    factor: &[TileColumn],
) {
    for j in 0..factor.len() {
        let (earlier, rest) = tile.split_at_mut(j);
        let column = S::as_mut_simd_f64s(&mut rest[0]).0;
        let mut sum = [simd.splat_f64s(0.0); VECTORS];
        for (earlier, factor) in earlier.iter().zip(factor) {
            let factor = simd.splat_f64s(factor[j]);
            for (sum, &earlier) in sum.iter_mut().zip(S::as_simd_f64s(earlier).0) {
                *sum = simd.mul_add_e_f64s(earlier, factor, *sum);
            }
        }
        let reciprocal = simd.splat_f64s(factor[j][j]);
        for (value, &sum) in column.iter_mut().zip(&sum) {
            *value = simd.mul_f64s(simd.sub_f64s(*value, sum), reciprocal);
        }
    }
}
