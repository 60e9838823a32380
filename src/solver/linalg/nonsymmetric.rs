//! The linear system of a Newton step where some force is not conservative: P + N, P the symmetric
//! part, N the antisymmetric one.
//!
//! The conjugate gradient method for a positive definite symmetric part that can be factored (P.
//! Concus, G. H. Golub, "A generalized conjugate gradient method for nonsymmetric systems of linear
//! equations", 1976; O. Widlund, "A Lanczos method for a class of nonsymmetric systems of linear
//! equations", SIAM J. Numer. Anal. 15(4), 1978): each iteration solves with P once and applies N
//! once. With b the largest |eigenvalue| of P⁻¹ N, the error falls by (sqrt(1 + b²) - 1) / b an
//! iteration.

use nalgebra::Vector3;

/// Share of the first residual at which the step is near enough for Newton's method.
const NEAR: f64 = 1e-3;
/// Iterations at most: what is left then makes a step that is not quite Newton's, but still
/// downhill.
const MOST: usize = 60;

/// Writes a matrix times its first argument into its second.
type Apply<'a> = dyn FnMut(&[Vector3<f64>], &mut [Vector3<f64>]) + 'a;

/// Solver for such a system, with its scratch memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct NonsymmetricSolver {
    /// Residuals of the last two iterates.
    residual: Vec<Vector3<f64>>,
    older: Vec<Vector3<f64>>,
    /// The iterate before the last.
    before: Vec<Vector3<f64>>,
    /// P⁻¹ times the residual.
    change: Vec<Vector3<f64>>,
    skewed: Vec<Vector3<f64>>,
}

impl NonsymmetricSolver {
    /// Turns `step`, the solution of P step = `force`, into that of (P + N) step = `force`: `solve`
    /// solves with P in place, `apply` writes N times its first argument into its second.
    pub(crate) fn correct(
        &mut self,
        force: &[Vector3<f64>],
        step: &mut [Vector3<f64>],
        solve: &mut dyn FnMut(&mut [Vector3<f64>]),
        apply: &mut Apply<'_>,
    ) {
        for scratch in [&mut self.before, &mut self.skewed, &mut self.residual] {
            scratch.clear();
            scratch.resize(step.len(), Vector3::zeros());
        }
        self.older.clear();
        self.older.extend_from_slice(force);
        apply(step, &mut self.residual);
        self.residual.iter_mut().for_each(|r| *r = -*r);
        let first = dot(step, force);
        let (mut square, mut weight) = (first, 1.0);
        for _ in 0..MOST {
            self.change.clone_from(&self.residual);
            solve(&mut self.change);
            let next = dot(&self.change, &self.residual);
            if next <= NEAR * NEAR * first {
                return;
            }
            weight = 1.0 / (1.0 + next / (square * weight));
            square = next;
            apply(&self.change, &mut self.skewed);
            self.advance(step, weight);
        }
    }

    /// `x_(k+1) = x_(k-1) + w (v_k + x_k - x_(k-1))`, and the residuals to match.
    fn advance(&mut self, step: &mut [Vector3<f64>], weight: f64) {
        for (i, x) in step.iter_mut().enumerate() {
            let next = self.before[i] + (self.change[i] + *x - self.before[i]) * weight;
            self.before[i] = *x;
            *x = next;
            let residual = self.older[i] * (1.0 - weight) - self.skewed[i] * weight;
            self.older[i] = self.residual[i];
            self.residual[i] = residual;
        }
    }
}

fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P the identity and N rotations by unlike rates: (1 + N) x = f in closed form, pair of
    /// coordinates by pair.
    #[test]
    fn it_solves_a_system_with_a_large_antisymmetric_part() {
        let rate = |i: usize| 0.5 + i as f64;
        let mut apply = |x: &[Vector3<f64>], y: &mut [Vector3<f64>]| {
            for (i, (x, y)) in x.iter().zip(y).enumerate() {
                *y = Vector3::new(-rate(i) * x.y, rate(i) * x.x, 0.0);
            }
        };
        let force: Vec<_> = (0..5)
            .map(|i| Vector3::new(1.0, 0.2 * i as f64, 2.0))
            .collect();
        let mut step = force.clone();
        NonsymmetricSolver::default().correct(&force, &mut step, &mut |_| {}, &mut apply);
        for (i, (x, f)) in step.iter().zip(&force).enumerate() {
            let (r, turned) = (rate(i), 1.0 + rate(i).powi(2));
            let exact = Vector3::new((f.x + r * f.y) / turned, (f.y - r * f.x) / turned, f.z);
            // The residual is a thousandth of the force, of norm below 6 in all.
            assert!((x - exact).norm() < 6e-3, "{x} {exact}");
        }
    }
}
