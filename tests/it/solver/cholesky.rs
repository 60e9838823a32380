//! Sparse Cholesky factors on matrices with known solutions.

use seamster_cholesky::{Cholesky, NotPositiveDefinite};

#[test]
fn a_path_laplacian_is_solved() {
    // [2 -1 0; -1 2 -1; 0 -1 2] x = [1 0 1] has x = [1 1 1].
    let mut cholesky =
        Cholesky::new(vec![0, 2, 4, 5], vec![0, 1, 1, 2, 2], Some(&[2, 0, 1])).expect("small");
    cholesky
        .factorize(&[2.0, -1.0, 2.0, -1.0, 2.0])
        .expect("positive definite");
    let mut x = [1.0, 0.0, 1.0];
    cholesky.solve(&mut x);
    assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-15));
}

#[test]
fn an_indefinite_matrix_is_refused() {
    let mut cholesky = Cholesky::new(vec![0, 1], vec![0], None).expect("small");
    assert_eq!(cholesky.factorize(&[-1.0]), Err(NotPositiveDefinite));
}
