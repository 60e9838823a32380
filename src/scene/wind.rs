//! Wind: the velocity of the air round the garment.

use nalgebra::Vector3;

/// Moving air, the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Mean velocity \[m/s\].
    pub velocity: Vector3<f64>,
    /// Size of the gusts as a share of the mean speed; 0 is steady.
    pub gust: f64,
}
