//! Numbers as they are written.

/// Rounds a number of the file: to 1e-12 m where the unit is a centimeter.
pub(super) fn neat(value: f64) -> f64 {
    // Adding 0 makes -0 plain.
    (value * 1e10).round() / 1e10 + 0.0
}
