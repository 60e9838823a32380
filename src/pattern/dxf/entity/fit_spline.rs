//! Cubic splines through given points, as polylines.
//!
//! Source: C. de Boor, "A Practical Guide to Splines", chapter IV (complete and natural cubic
//! splines).

use crate::pattern::Point2;
use crate::pattern::bspline::flatten;
use crate::pattern::point::distance;
use std::ops::Range;

/// A fit point this many points away bends a spline by 1e-7 of itself: each halves the influence
/// twice over.
const WRAP: usize = 12;

/// Returns the points of the cubic spline through `fit`, both ends included: twice differentiable
/// in the length of chords, its ends along the tangents where those are not zero, else without
/// curvature. A closed one goes round.
pub(super) fn through(
    fit: &[Point2],
    closed: bool,
    tangents: [Point2; 2],
    most: usize,
) -> Vec<Point2> {
    let mut fit: Vec<Point2> = fit.to_vec();
    fit.dedup();
    if closed && fit.len() > 2 && fit.first() == fit.last() {
        fit.pop();
    }
    let n = fit.len();
    if n < 3 {
        return fit;
    }
    if !closed {
        let slopes = slopes(&fit, tangents);
        return hermite(&fit, &slopes, 0..n - 1, most);
    }
    let around: Vec<Point2> = (0..=n + 2 * WRAP)
        .map(|i| fit[(i + n * WRAP - WRAP) % n])
        .collect();
    let slopes = slopes(&around, [[0.0; 2]; 2]);
    hermite(&around, &slopes, WRAP..WRAP + n, most)
}

/// A row of the tridiagonal system for the slopes.
struct SlopeRow {
    below: f64,
    diagonal: f64,
    above: f64,
    right: Point2,
}

impl SlopeRow {
    /// Returns diagonal, off-diagonal and right side of the row of an end: its slope is the unit
    /// tangent where that is not zero, else the curve has no curvature there.
    fn of_end(tangent: Point2, chord: Point2) -> (f64, f64, Point2) {
        let length = tangent[0].hypot(tangent[1]);
        if length > 0.0 {
            (1.0, 0.0, tangent.map(|c| c / length))
        } else {
            (2.0, 1.0, chord.map(|c| 3.0 * c))
        }
    }
}

/// Returns the derivatives at the points of an open cubic spline, by the length of chords: the
/// second derivatives from both sides of a point are equal.
fn slopes(p: &[Point2], tangents: [Point2; 2]) -> Vec<Point2> {
    let n = p.len();
    let h: Vec<f64> = p.windows(2).map(|w| distance(w[0], w[1])).collect();
    let chord = |i: usize| [0, 1].map(|k| (p[i + 1][k] - p[i][k]) / h[i]);
    let mut rows = Vec::with_capacity(n);
    let (diagonal, above, right) = SlopeRow::of_end(tangents[0], chord(0));
    rows.push(SlopeRow {
        below: 0.0,
        diagonal,
        above,
        right,
    });
    for i in 1..n - 1 {
        let (a, b) = (chord(i - 1), chord(i));
        rows.push(SlopeRow {
            below: h[i],
            diagonal: 2.0 * (h[i - 1] + h[i]),
            above: h[i - 1],
            right: [0, 1].map(|k| 3.0 * (h[i] * a[k] + h[i - 1] * b[k])),
        });
    }
    let (diagonal, below, right) = SlopeRow::of_end(tangents[1], chord(n - 2));
    rows.push(SlopeRow {
        below,
        diagonal,
        above: 0.0,
        right,
    });
    solve(rows)
}

/// Solves a tridiagonal system by elimination.
fn solve(mut rows: Vec<SlopeRow>) -> Vec<Point2> {
    for i in 1..rows.len() {
        let factor = rows[i].below / rows[i - 1].diagonal;
        rows[i].diagonal -= factor * rows[i - 1].above;
        for k in 0..2 {
            rows[i].right[k] -= factor * rows[i - 1].right[k];
        }
    }
    let mut found = vec![[0.0; 2]; rows.len()];
    for (i, row) in rows.iter().enumerate().rev() {
        let next = found.get(i + 1).copied().unwrap_or_default();
        found[i] = [0, 1].map(|k| (row.right[k] - row.above * next[k]) / row.diagonal);
    }
    found
}

/// Returns the points of the cubics with these ends and slopes, of some of the stretches.
fn hermite(p: &[Point2], slopes: &[Point2], stretches: Range<usize>, most: usize) -> Vec<Point2> {
    let mut points = Vec::new();
    for i in stretches {
        if points.len() > most {
            break;
        }
        let h = distance(p[i], p[i + 1]);
        let at = |t: f64| {
            let (u, v) = (1.0 - t, t);
            [0, 1].map(|k| {
                p[i][k] * u * u * (1.0 + 2.0 * v)
                    + p[i + 1][k] * v * v * (1.0 + 2.0 * u)
                    + h * u * v * (slopes[i][k] * u - slopes[i + 1][k] * v)
            })
        };
        flatten(&at, [0.0, 1.0], &mut points);
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::polyline::length;
    use std::f64::consts::{PI, TAU};

    const MOST: usize = 1000;

    /// Points of a circle of radius 1, every 15 degrees, over `turn`.
    fn on_circle(turn: f64) -> Vec<Point2> {
        (0..=24)
            .map(|i| turn * f64::from(i) / 24.0)
            .map(|a| [a.cos(), a.sin()])
            .collect()
    }

    /// A cubic spline through points a step h apart on a unit circle is off by about h^4 / 384.
    const OFF: f64 = 1e-4;

    #[test]
    fn curve_through_fit_points_keeps_to_a_circle() {
        let half = through(&on_circle(PI), false, [[0.0, 2.0], [0.0, -1.0]], MOST);
        assert!(half.iter().all(|p| (p[0].hypot(p[1]) - 1.0).abs() < OFF));
        assert!(length(&half) > PI * (1.0 - OFF));
        let whole = through(&on_circle(TAU), true, [[0.0; 2]; 2], MOST);
        assert!(whole.iter().all(|p| (p[0].hypot(p[1]) - 1.0).abs() < OFF));
        assert!(distance(whole[0], whole[whole.len() - 1]) < 1e-12);
    }

    #[test]
    fn curve_without_tangents_ends_without_curvature() {
        let fit = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
        let slopes = slopes(&fit, [[0.0; 2]; 2]);
        // By hand: m0 = 3/2 of the first chord less half of m1, and m1 lies along x by symmetry.
        let root = 0.5_f64.sqrt();
        let wanted = [[root, 1.5 * root], [root, 0.0], [root, -1.5 * root]];
        for (found, wanted) in slopes.iter().zip(wanted) {
            assert!(distance(*found, wanted) < 1e-12, "{found:?}");
        }
    }
}
