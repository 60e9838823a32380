//! Bodies with a head, and those that end with the stump of a neck.

/// Length of a head with the neck, at least, as a share of the height of a body.
const HEAD: f64 = 0.09;

/// Returns true if what a body of this height \[m\] has above the sides of its neck \[m\] is a
/// head.
pub fn is_head(above_neck: f64, height: f64) -> bool {
    above_neck >= HEAD * height
}
