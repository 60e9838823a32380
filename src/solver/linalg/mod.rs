//! Sparse linear algebra on matrices of 3 x 3 blocks.

pub(crate) mod block_matrix;
pub(crate) mod lanczos;
pub(crate) mod nonsymmetric;
