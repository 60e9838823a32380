//! Uniform cubic B-splines: weights of a value and its derivatives, and the coefficients that
//! interpolate.

/// Weights of the four coefficients about a cell, at `t` from 0 to 1 along it.
pub(super) fn weights(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [
        s * s * s / 6.0,
        (t * t * (3.0 * t - 6.0) + 4.0) / 6.0,
        (s * s * (3.0 * s - 6.0) + 4.0) / 6.0,
        t * t * t / 6.0,
    ]
}

/// First derivative of [`weights`] by `t`.
pub(super) fn slopes(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [
        -s * s / 2.0,
        t * (1.5 * t - 2.0),
        s * (2.0 - 1.5 * s),
        t * t / 2.0,
    ]
}

/// Second derivative of [`weights`] by `t`.
pub(super) fn bends(t: f64) -> [f64; 4] {
    [1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t]
}

/// Values at the knots to the coefficients of the spline through them, in place, along one line of
/// an array.
///
/// Solves `(c[i-1] + 4 c[i] + c[i+1]) / 6 = f[i]` with natural ends, `c = f` there (M. Unser,
/// "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16(6),
/// 1999). `pivots` as made by [`pivots`] for
/// the length of the line, or for more.
pub(super) fn interpolate(values: &mut [f64], pivots: &[f64]) {
    let last = values.len().saturating_sub(1);
    for i in 1..last {
        values[i] = (6.0 * values[i] - values[i - 1]) * pivots[i];
    }
    for i in (1..last).rev() {
        values[i] -= pivots[i] * values[i + 1];
    }
}

/// Reciprocal pivots of the elimination for lines of `count` values.
pub(super) fn pivots(count: usize) -> Vec<f64> {
    let mut pivots = vec![0.0; count];
    for i in 1..count.saturating_sub(1) {
        pivots[i] = 1.0 / (4.0 - pivots[i - 1]);
    }
    pivots
}
