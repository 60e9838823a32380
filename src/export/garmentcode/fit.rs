//! The curves that an edge is written as: one where one fits, else several.

use super::arc::arc_through;
use super::bezier::{self, Bezier, BezierFit, LEAST_POINTS, MOST_POINTS};
use super::curve::EdgeCurve;
use crate::pattern::point::{Point2, cross, distance, dot, lerp, sub};

/// A curve may leave the points of an edge by this \[m\]: half of what a cutter sees.
const NEAR: f64 = 5e-5;

/// Points this near to the line between the ends lie on it \[m\].
const STRAIGHT: f64 = 1e-9;

/// A fitted curve bulges over a chord by this share of it at most: the turn of a chord every 20
/// degrees.
const BULGE: f64 = 0.05;

/// A fitted curve leaves the lines of an edge by this at most \[m\].
const MOST_OFF: f64 = 5e-4;

/// Curves are fitted to the edges of patterns with up to this many points: two seconds of work on
/// a zigzag, a tenth of one on real files.
pub(super) const MOST_FITTED: usize = 20_000;

/// Points that curves are fitted to at most in a pattern, fit by fit: two fits on each of the seven
/// levels of halves of 257 to 5 points, which share their ends.
const MOST_WORK: usize = 16 * MOST_FITTED;

/// A curve for a part of an edge.
pub(super) struct FittedCurve {
    /// Index of the point that it ends at.
    pub(super) end: usize,
    pub(super) curve: EdgeCurve,
    /// The greatest distance between it and the lines of the edge \[m\].
    pub(super) deviation: f64,
}

/// Finds the curves of the edges of a pattern.
pub(super) struct Fitter {
    /// True if the pattern has too many points: an edge that is no curve becomes its chords.
    pub(super) is_sparing: bool,
    /// Points that curves were fitted to, fit by fit: the work that was done.
    fitted: usize,
}

impl Fitter {
    /// Returns one for a pattern with this many points of edges.
    pub(super) fn of(points: usize) -> Self {
        Self {
            is_sparing: points > MOST_FITTED,
            fitted: 0,
        }
    }

    /// Returns the curves for a polyline of at least two points, from its first to its last one.
    pub(super) fn curves(&mut self, points: &[Point2]) -> Vec<FittedCurve> {
        let mut found = Vec::new();
        self.add(points, 0, &mut found);
        found
    }

    /// Adds the curves of the points from index `from` on: one, or those of both halves.
    fn add(&mut self, points: &[Point2], from: usize, found: &mut Vec<FittedCurve>) {
        if let Some((curve, deviation)) = self.single(points) {
            found.push(FittedCurve {
                end: from + points.len() - 1,
                curve,
                deviation,
            });
        } else if self.is_sparing {
            found.extend((1..points.len()).map(|step| FittedCurve {
                end: from + step,
                curve: EdgeCurve::Line,
                deviation: 0.0,
            }));
        } else {
            let middle = (points.len() - 1) / 2;
            self.add(&points[..=middle], from, found);
            self.add(&points[middle..], from + middle, found);
        }
    }

    /// Returns one curve for all points, with the greatest distance between it and their lines.
    fn single(&mut self, points: &[Point2]) -> Option<(EdgeCurve, f64)> {
        let [first, .., last] = points else {
            return Some((EdgeCurve::Line, 0.0));
        };
        if points.len() == 2 || is_straight(points) {
            return Some((EdgeCurve::Line, 0.0));
        }
        if distance(*first, *last) <= STRAIGHT {
            return None;
        }
        if let Some(arc) = arc_through(points) {
            return Some((arc, 0.0));
        }
        let is_drawn_so = (LEAST_POINTS..=MOST_POINTS).contains(&points.len());
        if !is_drawn_so || self.fitted + 2 * points.len() > MOST_WORK {
            return None;
        }
        let quadratic = self.fit(points, 2);
        if let Some(curve) = bezier::exact(points, 2, quadratic.as_ref()) {
            return Some((written(&curve), 0.0));
        }
        let cubic = self.fit(points, 3);
        if let Some(curve) = bezier::exact(points, 3, cubic.as_ref()) {
            return Some((written(&curve), 0.0));
        }
        cubic
            .filter(|_| !self.is_sparing)
            .and_then(|fit| near(points, &fit))
    }

    fn fit(&mut self, points: &[Point2], degree: usize) -> Option<BezierFit> {
        self.fitted += points.len();
        bezier::fit(points, degree)
    }
}

fn written(curve: &Bezier) -> EdgeCurve {
    EdgeCurve::Bezier(curve.inner().to_vec())
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

/// Returns a fitted curve that passes near all points without bulging between them, with the
/// greatest distance between it and their lines.
fn near(points: &[Point2], fit: &BezierFit) -> Option<(EdgeCurve, f64)> {
    let mut deviation = fit.curve.deviation(points, &fit.parameters);
    if deviation > NEAR {
        return None;
    }
    for (ends, t) in points.windows(2).zip(fit.parameters.windows(2)) {
        let [a, b] = [ends[0], ends[1]];
        let bulge = distance(fit.curve.at(f64::midpoint(t[0], t[1])), lerp(a, b, 0.5));
        if t[0] >= t[1] || bulge > NEAR + BULGE * distance(a, b) {
            return None;
        }
        for share in [0.25, 0.5, 0.75] {
            let at = fit.curve.at(t[0] + share * (t[1] - t[0]));
            deviation = deviation.max(distance_from_chord(at, [a, b]));
        }
    }
    (deviation <= MOST_OFF).then(|| (written(&fit.curve), deviation))
}

/// Returns the distance of a point from a chord \[m\].
fn distance_from_chord(p: Point2, [a, b]: [Point2; 2]) -> f64 {
    let way = sub(b, a);
    let t = dot(sub(p, a), way) / dot(way, way).max(f64::MIN_POSITIVE);
    distance(p, lerp(a, b, t.clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curves(points: &[Point2]) -> Vec<FittedCurve> {
        Fitter::of(points.len()).curves(points)
    }

    /// A polyline that turns back at every point.
    fn zigzag(count: u32) -> Vec<Point2> {
        let at = |i: u32| [1e-3 * f64::from(i), 1e-3 * f64::from(i % 2)];
        (0..count).map(at).collect()
    }

    #[test]
    fn work_grows_with_the_number_of_points_and_ends_at_a_budget() {
        for count in [300, 2_000] {
            let mut fitter = Fitter::of(count as usize);
            let found = fitter.curves(&zigzag(count));
            assert_eq!(found.last().map(|part| part.end), Some(count as usize - 1));
            assert!(fitter.fitted <= 16 * count as usize, "{}", fitter.fitted);
        }
        let mut fitter = Fitter::of(20_001);
        let found = fitter.curves(&zigzag(20_001));
        assert_eq!((found.len(), fitter.fitted), (20_000, 0));
        assert!(found.iter().all(|part| part.curve == EdgeCurve::Line));
        fitter.fitted = MOST_WORK - 250;
        for _ in 0..3 {
            fitter.curves(&zigzag(100));
        }
        assert_eq!(fitter.fitted, MOST_WORK - 50);
    }

    #[test]
    fn curve_that_leaves_long_chords_is_refused() {
        // Chords of 0.1 m on a circle of 1 m: the curve is 1.25 mm off them.
        let at = |i: u32| [(0.1 * f64::from(i)).cos(), (0.1 * f64::from(i)).sin()];
        let wide: Vec<Point2> = (0..=8).map(at).collect();
        assert_eq!(curves(&wide).len(), 8);
        let small: Vec<Point2> = wide.iter().map(|p| p.map(|c| 0.2 * c)).collect();
        let found = curves(&small);
        assert_eq!(found.len(), 1);
        let off = 0.2 * (1.0 - 0.05_f64.cos());
        assert!((found[0].deviation - off).abs() < 2e-5, "{off}");
    }

    #[test]
    fn smooth_polyline_is_one_curve_and_one_with_a_kink_is_several() {
        let smooth: Vec<Point2> = (0..=40)
            .map(|i| f64::from(i) / 40.0)
            .map(|x| [0.4 * x, 0.05 * (2.0 * x).sin()])
            .collect();
        let found = curves(&smooth);
        assert_eq!((found.len(), found[0].end), (1, 40));
        assert!(found[0].deviation <= MOST_OFF);
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
