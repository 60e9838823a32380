//! The cone that a panel becomes where two of its edges that run about a point of its plane are
//! sewn to each other, as of a circle skirt in one piece.

use nalgebra::{Matrix2, Rotation2, Vector2};
use std::f64::consts::{PI, TAU};

/// Least and largest angle of such a panel about the point \[rad\]: narrower ones hang well rolled
/// as they are, wider ones are flat.
const ANGLES: [f64; 2] = [0.8, 6.2];
/// Furthest that the edges may be from each other, turned about the point \[m, RMS\].
const APART: f64 = 0.01;
/// Stitches that tell a turn at least.
const STITCHES: usize = 3;

/// A cone, as its panel is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cone {
    /// The point that the edges run about, on the turned drawing \[m\].
    apex: Vector2<f64>,
    /// Direction from there to the middle of the panel \[rad\].
    middle: f64,
    /// Share of a whole turn that the panel covers: the sine of half the cone's opening angle.
    share: f64,
    /// Distance of the panel from the apex \[m\].
    inner: f64,
}

impl Cone {
    /// The cone of a panel with this outline, whose `stitches` to itself join these points of the
    /// drawing \[m\]; none where they are not two edges about a point.
    pub(super) fn of(outline: &[Vector2<f64>], stitches: &[[Vector2<f64>; 2]]) -> Option<Self> {
        if stitches.len() < STITCHES {
            return None;
        }
        let (apex, turn) = turn_about(stitches)?;
        let rotation = Rotation2::new(turn);
        let off = |s: &[Vector2<f64>; 2]| (apex + rotation * (s[0] - apex) - s[1]).norm_squared();
        let apart = (stitches.iter().map(off).sum::<f64>() / stitches.len() as f64).sqrt();
        let from_a = middle(stitches, 0) - apex;
        let between = from_a.y.atan2(from_a.x) + 0.5 * turn;
        let (middle, angle) = if is_crossed(outline, &apex, between) {
            (between, turn.abs())
        } else {
            (between + PI, TAU - turn.abs())
        };
        let far = outline.iter().map(|p| (p - apex).norm());
        let is_cone = apart < APART && (ANGLES[0]..ANGLES[1]).contains(&angle);
        is_cone.then(|| Self {
            apex,
            middle,
            share: angle / TAU,
            inner: far.fold(f64::INFINITY, f64::min),
        })
    }

    /// Radius of its narrow end \[m\].
    pub(super) fn radius(&self) -> f64 {
        self.inner * self.share
    }

    /// Height \[m\] of a panel that reaches so far from the apex.
    pub(super) fn height(&self, outline: &[Vector2<f64>]) -> f64 {
        let far = outline.iter().map(|p| (p - self.apex).norm());
        (far.fold(0.0, f64::max) - self.inner) * self.slope()
    }

    /// Cosine of half the opening angle.
    fn slope(&self) -> f64 {
        (1.0 - self.share * self.share).sqrt()
    }

    /// Returns the angle round the axis from the middle of the panel \[rad\], the distance outward
    /// and the one down from the narrow end \[m\].
    pub(super) fn place(&self, p: &Vector2<f64>) -> [f64; 3] {
        let from = p - self.apex;
        let angle = (from.y.atan2(from.x) - self.middle + PI).rem_euclid(TAU) - PI;
        let along = from.norm() - self.inner;
        [angle / self.share, along * self.share, along * self.slope()]
    }
}

/// Returns the turn of the plane that takes the first points of the pairs nearest to the second
/// (least squares), and the point that it leaves where it is; none where that is a shift.
fn turn_about(pairs: &[[Vector2<f64>; 2]]) -> Option<(Vector2<f64>, f64)> {
    let [a, b] = [middle(pairs, 0), middle(pairs, 1)];
    let (mut cos, mut sin) = (0.0, 0.0);
    for pair in pairs {
        let (p, q) = (pair[0] - a, pair[1] - b);
        cos += p.dot(&q);
        sin += p.perp(&q);
    }
    let turn = f64::atan2(sin, cos);
    let rotation = Rotation2::new(turn);
    let moved = Matrix2::identity() - rotation.matrix();
    Some((moved.try_inverse()? * (b - rotation * a), turn))
}

/// Returns the mean of the first or the second points of pairs.
fn middle(pairs: &[[Vector2<f64>; 2]], which: usize) -> Vector2<f64> {
    pairs.iter().map(|pair| pair[which]).sum::<Vector2<f64>>() / pairs.len() as f64
}

/// Returns true if a closed outline crosses the half line from `apex` in this direction \[rad\].
fn is_crossed(outline: &[Vector2<f64>], apex: &Vector2<f64>, direction: f64) -> bool {
    let along = Vector2::new(direction.cos(), direction.sin());
    let next = outline.iter().cycle().skip(1);
    let mut pieces = outline.iter().zip(next).map(|(p, q)| (p - apex, q - apex));
    pieces.any(|(p, q)| {
        let [a, b] = [along.perp(&p), along.perp(&q)];
        (a >= 0.0) != (b >= 0.0) && along.dot(&(p + (q - p) * (a / (a - b)))) > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sector of this angle in degrees between radii of 0.2 and 0.8 m about a point, its middle
    /// towards -y, and the stitches that close it.
    fn sector(degrees: f64) -> (Vec<Vector2<f64>>, Vec<[Vector2<f64>; 2]>) {
        let point = |share: f64, radius: f64| {
            let angle = -0.5 * PI + share * degrees.to_radians();
            Vector2::new(0.3 + radius * angle.cos(), 0.1 + radius * angle.sin())
        };
        let shares = (0..=20).map(|k| f64::from(k) / 20.0 - 0.5);
        let inner = shares.clone().map(|share| point(share, 0.2));
        let outline = inner.chain(shares.rev().map(|share| point(share, 0.8)));
        let radii = (0..=6).map(|k| 0.2 + 0.1 * f64::from(k));
        let stitches = radii.map(|radius| [point(-0.5, radius), point(0.5, radius)]);
        (outline.collect(), stitches.collect())
    }

    #[test]
    fn sectors_close_round_their_axis() {
        for degrees in [90.0, 120.0, 179.0, 270.0, 350.0] {
            let (outline, stitches) = sector(degrees);
            let cone = Cone::of(&outline, &stitches).expect("a cone");
            let share = degrees / 360.0;
            assert!((cone.radius() - 0.2 * share).abs() < 1e-9, "{degrees}");
            for [a, b] in &stitches {
                let [from, to] = [a, b].map(|p| cone.place(p));
                assert!((from[0] + PI).abs() < 1e-6 && (to[0] - PI).abs() < 1e-6);
                assert!((from[1] - to[1]).abs() < 1e-9 && (from[2] - to[2]).abs() < 1e-9);
                // Lengths along the sides are kept.
                let along = (a - cone.apex).norm() - 0.2;
                assert!((from[1].hypot(from[2]) - along).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_tube_and_a_strip_are_no_cones() {
        let (outline, stitches) = sector(20.0);
        assert_eq!(Cone::of(&outline, &stitches), None);
        let tube = |y: f64| [Vector2::new(0.0, y), Vector2::new(1.0, y)];
        let stitches = [0.0, 0.1, 0.2, 0.3].map(tube);
        assert_eq!(Cone::of(stitches.as_flattened(), &stitches), None);
    }
}
