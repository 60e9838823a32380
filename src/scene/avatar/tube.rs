//! Rings of a limb: smooth closed sections in planes along an axis, each of a girth of its own.

use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A plane with a point of the axis: `outward` (to the body's left on the left side) and `forward`
/// span it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) center: Vector3<f64>,
    pub(super) outward: Vector3<f64>,
    pub(super) forward: Vector3<f64>,
}

/// A superellipse: half widths along `outward` and `forward` \[m\], and its exponent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Oval {
    pub(super) half: [f64; 2],
    pub(super) exponent: f64,
}

impl Oval {
    /// Returns the oval whose polygon of `count` corners has this girth \[m\]; `aspect` is its
    /// width over its depth.
    pub(super) fn of_girth(girth: f64, aspect: f64, exponent: f64, count: usize) -> Self {
        let unit = Self {
            half: [aspect, 1.0],
            exponent,
        };
        let corners: Vec<_> = angles(count)
            .iter()
            .map(|angle| unit.point(*angle))
            .collect();
        let next = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(next);
        let perimeter: f64 = sides.map(|(p, q)| (q[0] - p[0]).hypot(q[1] - p[1])).sum();
        let scale = girth / perimeter;
        Self {
            half: [aspect * scale, scale],
            exponent,
        }
    }

    /// The point at an angle from forward to outward, evenly spread as on an ellipse \[m\].
    fn point(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        let n = self.exponent;
        let norm = (sin.abs().powf(n) + cos.abs().powf(n)).powf(-1.0 / n);
        [self.half[0] * sin * norm, self.half[1] * cos * norm]
    }

    /// The ring of `count` points in a frame.
    pub(super) fn ring(&self, frame: &Frame, count: usize) -> Vec<Vector3<f64>> {
        let place = |angle: &f64| {
            let [outward, forward] = self.point(*angle);
            frame.center + frame.outward * outward + frame.forward * forward
        };
        angles(count).iter().map(place).collect()
    }
}

/// Angles of the columns of a limb, from its outer side over the back: loops that limbs grow from
/// begin there too.
fn angles(count: usize) -> Vec<f64> {
    let step = TAU / count as f64;
    (0..count).map(|k| FRAC_PI_2 + k as f64 * step).collect()
}

impl Frame {
    /// The plane normal to `direction`, with the front of the body forward.
    pub(super) fn normal_to(direction: Vector3<f64>, center: Vector3<f64>) -> Self {
        let direction = direction.normalize();
        let forward = (Vector3::z() - direction * direction.z).normalize();
        Self {
            center,
            outward: forward.cross(&direction),
            forward,
        }
    }
}

/// A value along a limb: a cubic between knots that overshoots none (F. N. Fritsch, J. Butland, "A
/// method for constructing local monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput.
/// 5(2), 1984).
pub(super) fn along(knots: &[[f64; 2]], s: f64) -> f64 {
    let last = knots.len() - 1;
    let i = knots[1..last]
        .iter()
        .take_while(|knot| knot[0] <= s)
        .count();
    let [[s0, f0], [s1, f1]] = [knots[i], knots[i + 1]];
    let width = s1 - s0;
    let secant = |k: usize| (knots[k + 1][1] - knots[k][1]) / (knots[k + 1][0] - knots[k][0]);
    let slope = |k: usize| {
        if k == 0 || k == last {
            return secant(k.min(last - 1));
        }
        let (before, after) = (secant(k - 1), secant(k));
        let (h0, h1) = (knots[k][0] - knots[k - 1][0], knots[k + 1][0] - knots[k][0]);
        let share = (h0 + 2.0 * h1) / (3.0 * (h0 + h1));
        let product = before * after;
        if product > 0.0 {
            product / (share * after + (1.0 - share) * before)
        } else {
            0.0
        }
    };
    let (m0, m1) = (slope(i) * width, slope(i + 1) * width);
    let t = ((s - s0) / width).clamp(0.0, 1.0);
    hermite([f0, m0, f1, m1], t)
}

/// The cubic from value and slope at 0 to value and slope at 1.
pub(super) fn hermite([f0, m0, f1, m1]: [f64; 4], t: f64) -> f64 {
    let s = 1.0 - t;
    f0 * (1.0 + 2.0 * t) * s * s + m0 * t * s * s + f1 * (3.0 - 2.0 * t) * t * t - m1 * t * t * s
}

/// Values from the first of `knots` to the last, each of them and others between that are `step`
/// apart at most.
pub(super) fn steps(knots: &[f64], step: f64) -> Vec<f64> {
    let mut all = Vec::new();
    for pair in knots.windows(2) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lengths of a limb over a step"
        )]
        let count = ((pair[1] - pair[0]) / step).ceil().max(1.0) as usize;
        all.extend((0..count).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64));
    }
    all.extend(knots.last());
    all
}
