//! Positions of the particles and, after them, of the vertices of cloth that does not move.

use nalgebra::Vector3;
use std::borrow::Cow;

/// Returns the positions of the particles and those of fixed cloth \[m\].
pub(super) fn with_fixed<'a>(
    x: &'a [Vector3<f64>],
    fixed: &[Vector3<f64>],
) -> Cow<'a, [Vector3<f64>]> {
    if fixed.is_empty() {
        Cow::Borrowed(x)
    } else {
        Cow::Owned([x, fixed].concat())
    }
}

/// Runs `edit` on the positions of the particles and those of fixed cloth \[m\], and keeps what it
/// makes of the former.
pub(super) fn edit_with_fixed<T>(
    x: &mut [Vector3<f64>],
    fixed: &[Vector3<f64>],
    edit: impl FnOnce(&mut [Vector3<f64>]) -> T,
) -> T {
    if fixed.is_empty() {
        return edit(x);
    }
    let mut all = [&*x, fixed].concat();
    let result = edit(&mut all);
    let count = x.len();
    x.copy_from_slice(&all[..count]);
    result
}
