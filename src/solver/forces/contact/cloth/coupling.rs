//! The blocks of a pair's corners in the Hessian: all of them where the matrix has them, else a
//! bound on its diagonal. Nothing is laid out for cloth that does not move, whose vertices are
//! numbered after the particles.

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Matrix3;

/// Returns true if `sparsity` has all blocks of those of these corners that are particles.
pub(super) fn is_coupled(sparsity: &Sparsity, corners: &[usize; 4]) -> bool {
    let count = sparsity.particle_count();
    let has = |a: usize, b: usize| a.max(b) >= count || sparsity.find(a, b).is_some();
    (0..4).all(|i| (0..i).all(|j| has(corners[i], corners[j])))
}

/// Adds `block` of each two corners to the matrix if it couples them all, else `bound` of each to
/// the diagonal; corners are named by their places in `corners`, and the later of two comes first.
pub(super) fn add_blocks(
    (sparsity, hessian): (&Sparsity, &mut BlockMatrix),
    corners: &[usize; 4],
    block: impl Fn(usize, usize) -> Matrix3<f64>,
    bound: impl Fn(usize) -> Matrix3<f64>,
) {
    let is_particle = |i: &usize| corners[*i] < sparsity.particle_count();
    let is_coupled = is_coupled(sparsity, corners);
    for i in (0..4).filter(is_particle) {
        let diagonal = sparsity.diagonal(corners[i]);
        if !is_coupled {
            hessian.add_diagonal(diagonal, &bound(i));
            continue;
        }
        hessian.add_diagonal(diagonal, &block(i, i));
        for j in (0..i).filter(is_particle) {
            hessian.add(sparsity.slot(corners[i], corners[j]), &block(i, j));
        }
    }
}
