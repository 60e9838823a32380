//! Arcs found in polylines: those that the importer drew, a chord a degree.

use super::curve::EdgeCurve;
use crate::pattern::point::{Point2, cross, distance, sub, turn};
use std::f64::consts::PI;

/// Largest turn between two chords of an imported arc \[rad\].
const STEP: f64 = PI / 180.0;

/// Points of an arc lie on its circle, and its chords are as long as each other, to this \[m\].
const EXACT: f64 = 1e-8;

/// Returns the arc that a polyline was drawn from; `None` if it was not one.
pub(super) fn arc_through(points: &[Point2]) -> Option<EdgeCurve> {
    let steps = points.len().checked_sub(1).filter(|steps| *steps >= 2)?;
    let center = center([points[0], points[steps / 2], points[steps]])?;
    let radius = distance(center, points[0]);
    let chord = distance(points[0], points[1]);
    let is_even = points
        .windows(2)
        .all(|w| (distance(w[0], w[1]) - chord).abs() <= EXACT);
    let is_round = points
        .iter()
        .all(|p| (distance(center, *p) - radius).abs() <= EXACT);
    let sweep = 2.0 * (0.5 * chord / radius).min(1.0).asin() * steps as f64;
    let is_drawn_so = (sweep / STEP - 1e-6).ceil().max(2.0) == steps as f64;
    (is_even && is_round && is_drawn_so && sweep < 2.0 * PI).then(|| EdgeCurve::Arc {
        radius,
        large: sweep > PI * (1.0 + 1e-9),
        right: turn(points[0], points[1], points[2]) > 0.0,
    })
}

/// Returns the center of the circle through three points; `None` where they lie on a line.
fn center([a, b, c]: [Point2; 3]) -> Option<Point2> {
    let (u, v) = (sub(b, a), sub(c, a));
    let twice = 2.0 * cross(u, v);
    let [uu, vv] = [u, v].map(|d| d[0] * d[0] + d[1] * d[1]);
    let x = (v[1] * uu - u[1] * vv) / twice;
    let y = (u[0] * vv - v[0] * uu) / twice;
    (x.is_finite() && y.is_finite()).then(|| [a[0] + x, a[1] + y])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(radius: f64, sweep: f64, steps: u32) -> Vec<Point2> {
        let at = |i: u32| 0.3 + sweep * f64::from(i) / f64::from(steps);
        let place = |angle: f64| [1.0 + radius * angle.cos(), 2.0 + radius * angle.sin()];
        (0..=steps).map(at).map(place).collect()
    }

    #[test]
    fn arcs_are_found_with_their_size_and_side() {
        for (sweep, steps, large, right) in
            [(0.5 * PI, 90, false, true), (-1.5 * PI, 270, true, false)]
        {
            let found = arc_through(&drawn(0.4, sweep, steps)).expect("an arc");
            let EdgeCurve::Arc {
                radius,
                large: is_large,
                right: is_right,
            } = found
            else {
                panic!("{found:?}");
            };
            assert!((radius - 0.4).abs() < 1e-12);
            assert_eq!((is_large, is_right), (large, right));
        }
    }

    #[test]
    fn polylines_of_other_steps_are_no_arcs() {
        assert_eq!(arc_through(&drawn(0.4, 0.5 * PI, 20)), None);
        assert_eq!(arc_through(&[[0.0, 0.0], [0.1, 0.1], [0.2, 0.0]]), None);
        assert_eq!(arc_through(&[[0.0, 0.0], [0.1, 0.0], [0.2, 0.0]]), None);
    }
}
