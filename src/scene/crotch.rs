//! Seams between the legs.

use nalgebra::Vector3;

/// Distance from the middle, and above the crotch, within which a seam from front to back goes
/// between the legs \[m\].
const BETWEEN_LEGS: f64 = 0.1;

/// Returns true if a stitch with these ends goes from front to back between the legs of a body
/// with this crotch \[m\].
pub(super) fn is_between_legs([a, b]: &[Vector3<f64>; 2], crotch: &Vector3<f64>) -> bool {
    let is_low = |p: &Vector3<f64>| p.y < crotch.y + BETWEEN_LEGS && p.x.abs() < BETWEEN_LEGS;
    is_low(a) && is_low(b) && (a.z - crotch.z) * (b.z - crotch.z) < 0.0
}
