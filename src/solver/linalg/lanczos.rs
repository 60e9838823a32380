//! The largest eigenvalue of a symmetric operator by Lanczos iteration (C. Lanczos, J. Res. Nat.
//! Bur. Stand. 45(4), 1950).
//!
//! Only products of the operator with vectors are needed. The Ritz value comes from below; from a
//! random start its mean relative error after k products with n unknowns is at most
//! 0.103 (ln(n (k - 1)^4) / (k - 1))²
//! (J. Kuczyński, H. Woźniakowski, SIAM J. Matrix Anal. Appl. 13(4), 1992).

use nalgebra::Vector3;

/// Share of the Ritz value below which the remainder of a product counts as zero: products by
/// differences carry about 1e-6 of rounding.
const BREAKDOWN: f64 = 1e-6;
/// Bisections of the interval that holds the largest eigenvalue of the tridiagonal matrix.
const BISECTIONS: usize = 60;

/// Criteria by which the iteration ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LanczosLimits {
    /// Products at most.
    pub(crate) products: usize,
    /// Relative change over a tenth of the products at which the Ritz value counts as converged; 0
    /// to take all products.
    pub(crate) tolerance: f64,
}

/// The largest Ritz value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RitzValue {
    pub(crate) value: f64,
    /// Products that it took.
    pub(crate) products: usize,
}

/// A symmetric linear operator: applies itself to its first argument and writes to its second.
pub(crate) type LinearOperator<'a> = dyn FnMut(&[Vector3<f64>], &mut [Vector3<f64>]) + 'a;

/// Returns the largest Ritz value of the operator that `multiply` applies to its first argument and
/// writes to its second, from the vector `start`.
pub(crate) fn largest_ritz_value(
    start: Vec<Vector3<f64>>,
    limits: LanczosLimits,
    multiply: &mut LinearOperator<'_>,
) -> RitzValue {
    let interval = limits.products / 10;
    let mut last_checked = 0.0;
    let count = start.len();
    let mut z = start;
    normalize(&mut z);
    let mut previous = vec![Vector3::zeros(); count];
    let mut product = previous.clone();
    let (mut diagonal, mut off_diagonal) = (Vec::new(), Vec::new());
    for number in 1..=limits.products.min(3 * count) {
        multiply(&z, &mut product);
        let alpha = dot(&z, &product);
        let beta = off_diagonal.last().copied().unwrap_or(0.0);
        for ((p, z), b) in product.iter_mut().zip(&z).zip(&previous) {
            *p -= z * alpha + b * beta;
        }
        diagonal.push(alpha);
        let remainder = normalize(&mut product);
        if remainder <= BREAKDOWN * largest_of_tridiagonal(&diagonal, &off_diagonal).abs() {
            break;
        }
        if limits.tolerance > 0.0 && number % interval == 0 {
            let largest = largest_of_tridiagonal(&diagonal, &off_diagonal);
            if largest - last_checked <= limits.tolerance * largest {
                break;
            }
            last_checked = largest;
        }
        off_diagonal.push(remainder);
        std::mem::swap(&mut previous, &mut z);
        std::mem::swap(&mut z, &mut product);
    }
    off_diagonal.truncate(diagonal.len().saturating_sub(1));
    RitzValue {
        value: largest_of_tridiagonal(&diagonal, &off_diagonal),
        products: diagonal.len(),
    }
}

/// Returns `count` vectors that favor no direction, components between -0.5 and 0.5, the same at
/// every call.
pub(crate) fn pseudo_random_vectors(count: usize) -> Vec<Vector3<f64>> {
    let mut seed = 1_u64;
    let mut number = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    };
    (0..count)
        .map(|_| Vector3::new(number(), number(), number()))
        .collect()
}

fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

/// Scales `z` to length 1 and returns the length that it had.
fn normalize(z: &mut [Vector3<f64>]) -> f64 {
    let length = dot(z, z).sqrt();
    if length > 0.0 {
        z.iter_mut().for_each(|z| *z /= length);
    }
    length
}

/// Returns the largest eigenvalue of a symmetric tridiagonal matrix, by bisection on the count of
/// negative pivots (Sturm).
fn largest_of_tridiagonal(diagonal: &[f64], off_diagonal: &[f64]) -> f64 {
    let off = |i: usize| off_diagonal.get(i).copied().unwrap_or(0.0);
    let radius = |i: usize| if i == 0 { 0.0 } else { off(i - 1) } + off(i);
    let rows = || diagonal.iter().enumerate();
    let mut low = diagonal.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut high = rows().map(|(i, d)| d + radius(i)).fold(low, f64::max);
    let all_below = |value: f64| {
        let mut pivot = 1.0;
        rows().all(|(i, d)| {
            let carried = if i == 0 {
                0.0
            } else {
                off(i - 1).powi(2) / pivot
            };
            pivot = d - value - carried;
            pivot < 0.0
        })
    };
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if all_below(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The eigenvalues of the path's matrix (2, -1) are 2 - 2 cos(k π / (n + 1)).
    #[test]
    fn the_largest_eigenvalue_of_a_path_is_found() {
        let n = 10;
        let exact = 2.0 - 2.0 * (n as f64 * std::f64::consts::PI / (n as f64 + 1.0)).cos();
        let found = largest_of_tridiagonal(&[2.0; 10], &[-1.0; 9].map(f64::abs));
        assert!((found - exact).abs() < 1e-14 * exact, "{found} {exact}");
    }
}
