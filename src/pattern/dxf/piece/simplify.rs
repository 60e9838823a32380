//! A closed polyline simplified: without the points that lie on straight lines between others, and
//! without the noise of digitized lines.
//!
//! A curve that was drawn as chords and sampled anew turns at the ends of its old chords alone, so
//! that each of them looks like a corner between two straight lines.
//!
//! Method: lines as long as a cone of directions allows, after J. Sklansky and V. Gonzalez, Fast
//! polygonal approximation of digitized curves, Pattern Recognition 12 (1980).

use crate::pattern::point::{Point2, cross, distance, sub, turn};

/// A line on which at least this share of neighboring points bend to different sides, or not at
/// all, was sampled from straight lines or is noisy.
const ALTERNATING: f64 = 0.4;

/// Bounds of the distance from a straight line at which a point lies on it: coordinates are rounded
/// to a micrometer, and hands tremble by hundredths of a millimeter \[m\].
const ON_LINE: [f64; 2] = [1e-6, 5e-5];

/// Points lie on a straight line if they do to within this many times the median noise.
const NOISE_FACTOR: f64 = 3.0;

/// The points that a simplified closed polyline keeps.
pub(super) struct SimplifiedRing {
    /// Their indices.
    pub(super) kept: Vec<usize>,
    /// False if the distances between them tell nothing.
    pub(super) has_steps: bool,
}

impl SimplifiedRing {
    /// Simplifies a ring; turns of `sharp` or more are kept as they are.
    pub(super) fn of(points: &[Point2], sharp: f64) -> Self {
        let n = points.len();
        let all = Self {
            kept: (0..n).collect(),
            has_steps: true,
        };
        if n < 8 {
            return all;
        }
        let at = |i: usize| points[i % n];
        let turns = (0..n).map(|i| turn(at(i + n - 1), at(i), at(i + 1)).abs());
        let is_sharp: Vec<bool> = turns.map(|turn| turn >= sharp).collect();
        let offsets: Vec<f64> = (0..n)
            .map(|i| offset(at(i), at(i + n - 1), at(i + 1)))
            .collect();
        let Some(noise) = noise(&offsets, &is_sharp) else {
            return all;
        };
        let on_line = (NOISE_FACTOR * noise).clamp(ON_LINE[0], ON_LINE[1]);
        let kept = kept_points(points, &is_sharp, on_line);
        Self {
            has_steps: kept.len() == n,
            kept,
        }
    }
}

/// Returns the median distance by which points leave the line of their neighbors; `None` where
/// these bend to the same side, as those of smooth curves do.
fn noise(offsets: &[f64], is_sharp: &[bool]) -> Option<f64> {
    let n = offsets.len();
    let smooth: Vec<usize> = (0..n)
        .filter(|i| (0..3).all(|k| !is_sharp[(i + k) % n]))
        .collect();
    // Two points on one straight line say nothing of the curves beside it.
    let pairs = smooth.iter().map(|i| [offsets[*i], offsets[(i + 1) % n]]);
    let pairs = pairs.filter(|pair| pair.iter().any(|offset| offset.abs() > ON_LINE[0]));
    let (alternating, all) = pairs.fold((0_usize, 0_usize), |(alternating, all), [a, b]| {
        (
            alternating + usize::from(a * b <= 0.0 || a.abs().min(b.abs()) <= ON_LINE[0]),
            all + 1,
        )
    });
    if smooth.is_empty() || (alternating as f64) < ALTERNATING * all as f64 {
        return None;
    }
    let jump = |i: &usize| {
        let [a, b, c] = [0, 1, 2].map(|k| offsets[(i + k) % n]);
        (b - 0.5 * (a + c)).abs()
    };
    let mut jumps: Vec<f64> = smooth.iter().map(jump).collect();
    let middle = jumps.len() / 2;
    Some(*jumps.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Returns the signed distance of a point from the line through two others \[m\].
fn offset(p: Point2, a: Point2, b: Point2) -> f64 {
    cross(sub(b, a), sub(p, a)) / distance(a, b).max(f64::MIN_POSITIVE)
}

/// Returns the points of a ring that are left where those on the lines between others are taken
/// out. Each line is drawn as far as all points on its way lie within `on_line` of it.
fn kept_points(points: &[Point2], is_sharp: &[bool], on_line: f64) -> Vec<usize> {
    let n = points.len();
    let start = is_sharp.iter().position(|sharp| *sharp).unwrap_or(0);
    let mut kept = vec![start];
    let mut from = start;
    let mut cone = Cone::new();
    for k in 1..=n {
        let i = (start + k) % n;
        let d = sub(points[i], points[from]);
        if !cone.holds(d) {
            from = (start + k - 1) % n;
            kept.push(from);
            cone = Cone::new();
        }
        if k < n && is_sharp[i] {
            kept.push(i);
            from = i;
            cone = Cone::new();
        } else {
            cone.narrow(sub(points[i], points[from]), on_line);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// The directions of lines from a point that pass all points on their way nearby.
struct Cone {
    /// The rightmost and the leftmost direction, once there are any.
    sides: Option<[Point2; 2]>,
}

impl Cone {
    fn new() -> Self {
        Self { sides: None }
    }

    fn holds(&self, d: Point2) -> bool {
        self.sides
            .is_none_or(|[right, left]| cross(right, d) >= 0.0 && cross(d, left) >= 0.0)
    }

    /// Leaves the directions that pass within `reach` of a point `d` away.
    fn narrow(&mut self, d: Point2, reach: f64) {
        let length = distance([0.0; 2], d);
        if length <= reach {
            return;
        }
        let across = reach / length;
        let own = [
            [d[0] + across * d[1], d[1] - across * d[0]],
            [d[0] - across * d[1], d[1] + across * d[0]],
        ];
        let [mut right, mut left] = self.sides.unwrap_or(own);
        if cross(right, own[0]) > 0.0 {
            right = own[0];
        }
        if cross(left, own[1]) < 0.0 {
            left = own[1];
        }
        self.sides = Some([right, left]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHARP: f64 = 0.349;

    /// A half disc of radius 0.2 m, its round side as 12 chords, with points every `step` meters.
    fn half_disc(step: f64, noise: f64) -> (Vec<Point2>, Vec<usize>) {
        let angles = (0..=12).map(|i| std::f64::consts::PI * f64::from(i) / 12.0);
        let corners: Vec<Point2> = angles.map(|a| [0.2 * a.cos(), 0.2 * a.sin()]).collect();
        let (mut points, mut ends) = (vec![], vec![]);
        let mut sign = 1.0;
        for (i, a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let count = (distance(*a, b) / step).ceil();
            ends.push(points.len());
            let mut at = 0.0;
            while at < count {
                sign = -sign;
                let t = at / count;
                let shift = if at > 0.0 { sign * noise } else { 0.0 };
                let along = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
                points.push([along[0] + shift * along[0], along[1] + shift * along[1]]);
                at += 1.0;
            }
        }
        (points, ends)
    }

    #[test]
    fn chords_sampled_anew_are_the_chords() {
        for step in [0.001, 0.003, 0.01] {
            let (points, ends) = half_disc(step, 0.0);
            let simplified = SimplifiedRing::of(&points, SHARP);
            assert_eq!(simplified.kept, ends, "every {step} m");
        }
    }

    #[test]
    fn noisy_lines_are_straight() {
        // 0.0001 of 0.2 m: 0.02 mm to either side.
        let (points, ends) = half_disc(0.003, 1e-4);
        let simplified = SimplifiedRing::of(&points, SHARP);
        assert!(
            simplified.kept.len() <= 2 * ends.len(),
            "{:?}",
            simplified.kept
        );
        assert!(!simplified.has_steps);
    }

    #[test]
    fn curves_beside_straight_lines_stay_whole() {
        let mut points: Vec<Point2> = (0..100).map(|i| [0.002 * f64::from(i), 0.0]).collect();
        points.extend((0..90).map(|i| {
            let angle = f64::from(i) * 2.0_f64.to_radians();
            [0.2 + 0.1 * angle.sin(), 0.1 - 0.1 * angle.cos()]
        }));
        points.extend((0..100).map(|i| [0.2 - 0.002 * f64::from(i), 0.2]));
        assert_eq!(SimplifiedRing::of(&points, SHARP).kept.len(), points.len());
    }

    #[test]
    fn smooth_curves_stay_whole() {
        let angles = (0..90).map(|i| f64::from(i) * 4.0_f64.to_radians());
        let points: Vec<Point2> = angles.map(|a| [0.2 * a.cos(), 0.3 * a.sin()]).collect();
        assert_eq!(SimplifiedRing::of(&points, SHARP).kept.len(), 90);
    }
}
