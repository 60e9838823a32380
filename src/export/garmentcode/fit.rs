//! The curves that an edge is written as: one where one fits, else several.

use super::arc::arc_through;
use super::bezier;
use super::curve::EdgeCurve;
use crate::pattern::point::{Point2, cross, distance, lerp, sub};

/// A curve may leave the points of an edge by this \[m\]: half of what a cutter sees.
const NEAR: f64 = 5e-5;

/// Points this near to the line between the ends lie on it \[m\].
const STRAIGHT: f64 = 1e-9;

/// Chords at least to which a curve is fitted that they were not drawn from.
const LEAST_CHORDS: usize = 4;

/// A fitted curve bulges over a chord by this share of it at most: the turn of a chord every 20
/// degrees.
const BULGE: f64 = 0.05;

/// A curve for a part of an edge.
pub(super) struct FittedCurve {
    /// Index of the point that it ends at.
    pub(super) end: usize,
    pub(super) curve: EdgeCurve,
    /// The greatest distance of a point of the edge from it \[m\].
    pub(super) deviation: f64,
}

/// Returns the curves for a polyline of at least two points, from its first to its last one.
pub(super) fn curves(points: &[Point2]) -> Vec<FittedCurve> {
    let mut found = Vec::new();
    add(points, 0, &mut found);
    found
}

/// Adds the curves of the points from index `from` on: one, or those of both halves.
fn add(points: &[Point2], from: usize, found: &mut Vec<FittedCurve>) {
    let end = from + points.len() - 1;
    if let Some((curve, deviation)) = single(points) {
        found.push(FittedCurve {
            end,
            curve,
            deviation,
        });
    } else {
        let middle = (points.len() - 1) / 2;
        add(&points[..=middle], from, found);
        add(&points[middle..], from + middle, found);
    }
}

/// Returns one curve for all points, with the greatest distance of one from it.
fn single(points: &[Point2]) -> Option<(EdgeCurve, f64)> {
    let [first, .., last] = points else {
        return Some((EdgeCurve::Line, 0.0));
    };
    if points.len() == 2 || is_straight(points) {
        return Some((EdgeCurve::Line, 0.0));
    }
    if distance(*first, *last) <= STRAIGHT {
        return None;
    }
    let exact = |degree| {
        let curve = bezier::exact(points, degree)?;
        Some(EdgeCurve::Bezier(curve.inner().to_vec()))
    };
    let drawn = arc_through(points)
        .or_else(|| exact(2))
        .or_else(|| exact(3));
    drawn.map(|curve| (curve, 0.0)).or_else(|| near(points))
}

/// Returns true if points follow the line between the first and the last one.
fn is_straight(points: &[Point2]) -> bool {
    let (a, b) = (points[0], points[points.len() - 1]);
    let long = distance(a, b);
    let mut along = 0.0;
    long > STRAIGHT
        && points.iter().all(|p| {
            let d = sub(*p, a);
            let e = sub(b, a);
            let forth = (d[0] * e[0] + d[1] * e[1]) / long;
            let is_on = cross(e, d).abs() / long <= STRAIGHT && forth >= along;
            along = forth;
            is_on
        })
}

/// Returns a cubic curve that passes near all points without bulging between them.
fn near(points: &[Point2]) -> Option<(EdgeCurve, f64)> {
    if points.len() <= LEAST_CHORDS {
        return None;
    }
    let fit = bezier::fit(points, 3)?;
    let deviation = fit.curve.deviation(points, &fit.parameters);
    let chords = points.windows(2).zip(fit.parameters.windows(2));
    let is_calm = chords.into_iter().all(|(ends, t)| {
        let bulge = distance(
            fit.curve.at(f64::midpoint(t[0], t[1])),
            lerp(ends[0], ends[1], 0.5),
        );
        t[0] < t[1] && bulge <= NEAR + BULGE * distance(ends[0], ends[1])
    });
    (deviation <= NEAR && is_calm)
        .then(|| (EdgeCurve::Bezier(fit.curve.inner().to_vec()), deviation))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_polyline_is_one_curve_and_one_with_a_kink_is_several() {
        let smooth: Vec<Point2> = (0..=40)
            .map(|i| f64::from(i) / 40.0)
            .map(|x| [0.4 * x, 0.05 * (2.0 * x).sin()])
            .collect();
        let found = curves(&smooth);
        assert_eq!((found.len(), found[0].end), (1, 40));
        assert!(found[0].deviation <= NEAR);
        let mut kinked = smooth;
        for p in &mut kinked[20..] {
            p[1] += 0.5 * (p[0] - 0.2);
        }
        let found = curves(&kinked);
        assert!(found.len() > 1 && found.iter().any(|part| part.end == 20));
        assert_eq!(found.last().map(|part| part.end), Some(40));
    }

    #[test]
    fn points_on_a_line_are_a_line() {
        let line: Vec<Point2> = (0..=6).map(|i| [0.1 * f64::from(i), 0.3]).collect();
        let found = curves(&line);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].curve, EdgeCurve::Line);
    }
}
