//! A central spring along a vector d that is linear in positions: energy k/2 (|d| - L)², L the rest
//! length.

use nalgebra::{Matrix3, Vector3};

/// Stiffness and rest length of a linear spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CentralSpring {
    /// Stiffness k \[N/m\].
    pub(crate) stiffness: f64,
    /// Rest length L \[m\].
    pub(crate) rest_length: f64,
}

impl CentralSpring {
    /// Returns the energy \[J\].
    pub(crate) fn energy(&self, d: &Vector3<f64>) -> f64 {
        0.5 * self.stiffness * (d.norm() - self.rest_length).powi(2)
    }

    /// Returns the derivative of the energy by `d` \[N\]; `None` where `d` is zero, and the force
    /// has no direction.
    pub(crate) fn tension(&self, d: &Vector3<f64>) -> Option<Vector3<f64>> {
        let length = d.norm();
        (length > 0.0).then(|| d * (self.stiffness * (1.0 - self.rest_length / length)))
    }

    /// Returns the Hessian of the energy by `d` \[N/m\], less the share `hessian_modification` of
    /// what is negative in it; `None` where `d` is zero.
    pub(crate) fn hessian(
        &self,
        d: &Vector3<f64>,
        hessian_modification: f64,
    ) -> Option<Matrix3<f64>> {
        let length = d.norm();
        if length == 0.0 {
            return None;
        }
        let n = d / length;
        let along = n * n.transpose();
        // Across the spring the stiffness is its tension over its length: negative when it is
        // pressed together.
        let across = 1.0 - self.rest_length / length;
        let across = if across < 0.0 {
            across * (1.0 - hessian_modification)
        } else {
            across
        };
        Some((along + (Matrix3::identity() - along) * across) * self.stiffness)
    }
}
