//! Splines of a DXF as polylines, those through fit points too.
//!
//! Source of the interpolation: C. de Boor, "A Practical Guide to Splines", chapter IV (cubic splines
//! with clamped and natural ends).

use super::geometry::EntityPath;
use super::plane::xy;
use crate::fault::Fault;
use crate::pattern::Point2;
use crate::pattern::bspline::{BSpline, flatten};
use crate::pattern::dxf::findings::at_line;
use crate::pattern::point::distance;
use std::ops::Range;

/// Returns a spline of the crate as a path; where it has more than `most` points, it ends early.
///
/// # Errors
/// Numbers that make no spline.
pub(super) fn path(
    s: &dxf::entities::Spline,
    line: usize,
    most: usize,
) -> Result<EntityPath, Fault> {
    let refuse = |what: &str| refuse(line, what);
    let degree = usize::try_from(s.degree_of_curve)
        .map_err(|_| refuse("the spline's degree is negative"))?;
    let controls: Vec<Point2> = s.control_points.iter().map(xy).collect();
    if controls.is_empty() {
        let fit: Vec<Point2> = s.fit_points.iter().map(xy).collect();
        if fit.len() < 2 {
            return Err(refuse(
                "the spline has neither control points nor fit points",
            ));
        }
        let tangents = [&s.start_tangent, &s.end_tangent].map(xy);
        return Ok(EntityPath::curve(through(
            &fit,
            s.flags & 1 == 1,
            tangents,
            most,
        )));
    }
    if degree == 0 || controls.len() <= degree || s.knot_values.len() != controls.len() + degree + 1
    {
        return Err(refuse(
            "the spline's degree, knots and control points do not go together",
        ));
    }
    if s.knot_values.windows(2).any(|w| w[1] < w[0])
        || s.knot_values[degree] >= s.knot_values[controls.len()]
    {
        return Err(refuse("the spline's knots fall"));
    }
    if !s.weight_values.is_empty() && s.weight_values.len() != controls.len()
        || s.weight_values.iter().any(|w| *w <= 0.0)
    {
        return Err(refuse(
            "the spline's weights are not positive, one to a control point",
        ));
    }
    let curve = BSpline {
        degree,
        knots: &s.knot_values,
        controls: &controls,
        weights: &s.weight_values,
    };
    Ok(EntityPath::curve(curve.points(most)))
}

fn refuse(line: usize, what: &str) -> Fault {
    Fault::new("pattern/spline", at_line(line), what.to_owned())
        .fix("export curves as polylines, or draw this one anew")
}

/// Returns the points of the cubic spline through `fit`, both ends included: twice differentiable in
/// the length of chords, its ends along the tangents where those are not zero, else without
/// curvature. A closed one goes round.
fn through(fit: &[Point2], closed: bool, tangents: [Point2; 2], most: usize) -> Vec<Point2> {
    /// A fit point this many points away bends a spline by 1e-7 of itself: each halves the influence
    /// twice over.
    const WRAP: usize = 12;
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

/// Returns the derivatives at the points of an open cubic spline, by the length of chords: the
/// tridiagonal system of equal second derivatives from both sides, solved by elimination.
fn slopes(p: &[Point2], tangents: [Point2; 2]) -> Vec<Point2> {
    let n = p.len();
    let h: Vec<f64> = p.windows(2).map(|w| distance(w[0], w[1])).collect();
    let chord = |i: usize| [0, 1].map(|k| (p[i + 1][k] - p[i][k]) / h[i]);
    let end = |tangent: Point2, chord: Point2| {
        let long = tangent[0].hypot(tangent[1]);
        if long > 0.0 {
            (1.0, 0.0, tangent.map(|c| c / long))
        } else {
            (2.0, 1.0, chord.map(|c| 3.0 * c))
        }
    };
    // Rows: below, diagonal, above, right side.
    let mut rows: Vec<(f64, f64, f64, Point2)> = Vec::with_capacity(n);
    let (diagonal, above, right) = end(tangents[0], chord(0));
    rows.push((0.0, diagonal, above, right));
    for i in 1..n - 1 {
        let (a, b) = (chord(i - 1), chord(i));
        let right = [0, 1].map(|k| 3.0 * (h[i] * a[k] + h[i - 1] * b[k]));
        rows.push((h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1], right));
    }
    let (diagonal, below, right) = end(tangents[1], chord(n - 2));
    rows.push((below, diagonal, 0.0, right));
    for i in 1..n {
        let factor = rows[i].0 / rows[i - 1].1;
        rows[i].1 -= factor * rows[i - 1].2;
        for k in 0..2 {
            rows[i].3[k] -= factor * rows[i - 1].3[k];
        }
    }
    let mut slopes = vec![[0.0; 2]; n];
    for i in (0..n).rev() {
        let next = slopes.get(i + 1).copied().unwrap_or_default();
        slopes[i] = [0, 1].map(|k| (rows[i].3[k] - rows[i].2 * next[k]) / rows[i].1);
    }
    slopes
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
