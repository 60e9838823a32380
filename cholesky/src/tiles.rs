//! Layout of dense matrices: tiles of twelve rows, column by column, so that every loop over
//! columns reads memory in order and every column of a tile is a few vector registers.

use pulp::{Arch, Scalar, Simd, WithSimd};

/// Rows of a tile.
pub(crate) const TILE_ROWS: usize = 12;
/// Vertices of a tile, of three rows each.
pub(crate) const TILE_VERTICES: usize = TILE_ROWS / 3;

/// One column of a tile.
pub(crate) type TileColumn = [f64; TILE_ROWS];

/// Returns the number of tiles that hold so many vertices.
pub(crate) fn tile_count(vertices: usize) -> usize {
    vertices.div_ceil(TILE_VERTICES)
}

/// Returns the tile columns of a lower triangle of so many tile rows, in which row `t` has `t + 1`
/// tiles; also the start of row `t`.
pub(crate) fn triangle_len(tile_rows: usize) -> usize {
    TILE_ROWS * tile_rows * (tile_rows + 1) / 2
}

/// Work on tiles, whose columns are `VECTORS` vector registers of `S`.
pub(crate) trait TileOperation {
    type Output;

    fn run<S: Simd, const VECTORS: usize>(self, simd: S) -> Self::Output;
}

/// Runs `operation` in the widest vector registers of the machine that divide a column.
pub(crate) fn run<T: TileOperation>(arch: Arch, operation: T) -> T::Output {
    arch.dispatch(Dispatch(operation))
}

struct Dispatch<T>(T);

impl<T: TileOperation> WithSimd for Dispatch<T> {
    type Output = T::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> T::Output {
        match S::F64_LANES {
            4 => self.0.run::<S, 3>(simd),
            2 => self.0.run::<S, 6>(simd),
            _ => self.0.run::<Scalar, TILE_ROWS>(Scalar::new()),
        }
    }
}
