//! Layout of dense matrices: tiles of twelve rows, column by column, so that every loop over
//! columns reads memory in order and every column of a tile is a few vector registers.

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
