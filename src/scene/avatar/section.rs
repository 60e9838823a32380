//! One horizontal section of a dress form.

use std::f64::consts::PI;

/// Points that a half section is first sampled at; the mesh picks from these.
const SAMPLES: usize = 256;

/// A closed curve about (0, `centre`), symmetric in x: a superellipse whose front and back half
/// differ in depth, with a pair of soft bumps on it. Its exponent is above 2, which keeps the curve
/// smooth (C2) where the halves meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Height above the floor \[m\].
    pub(super) y: f64,
    /// Half width at the widest line \[m\].
    pub(super) half_width: f64,
    /// z of the widest line \[m\].
    pub(super) centre: f64,
    /// Depth before the widest line \[m\].
    pub(super) front: f64,
    /// Depth behind the widest line \[m\].
    pub(super) back: f64,
    /// Exponent of the superellipse.
    pub(super) exponent: f64,
    /// Bumps that stand out from it.
    pub(super) bumps: [Bump; 2],
}

/// Two bumps, one on each side, at a polar angle from +z towards +x and its mirror image.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bump {
    /// Height above the section \[m\].
    pub(super) height: f64,
    /// Polar angle of its top \[rad\].
    pub(super) angle: f64,
    /// Its standard deviation \[rad\].
    pub(super) spread: f64,
}

impl Bump {
    /// Height at a polar angle \[m\]: a von Mises bell, the Gaussian of the circle, on each side.
    fn at(&self, angle: f64) -> f64 {
        let bell = |off: f64| ((off.cos() - 1.0) / (self.spread * self.spread)).exp();
        if self.height == 0.0 {
            return 0.0;
        }
        self.height * (bell(angle - self.angle) + bell(angle + self.angle))
    }
}

impl Section {
    /// The point (x, z) at a polar angle from +z towards +x \[m\].
    pub(super) fn point(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        let depth = if cos >= 0.0 { self.front } else { self.back };
        let n = self.exponent;
        let sum = (sin / self.half_width).abs().powf(n) + (cos / depth).abs().powf(n);
        let bumps: f64 = self.bumps.iter().map(|bump| bump.at(angle)).sum();
        let radius = sum.powf(-1.0 / n) + bumps;
        [radius * sin, self.centre + radius * cos]
    }

    /// The half on the body's left, from the middle of the front to the middle of the back \[m\].
    pub(super) fn half(&self) -> Vec<[f64; 2]> {
        let aspect = 0.5 * (self.front + self.back) / self.half_width;
        let mut half: Vec<_> = (0..=SAMPLES)
            .map(|i| {
                // angles as of an ellipse, so that the points are spread about evenly on flat
                // sections as well
                let (sin, cos) = (PI * i as f64 / SAMPLES as f64).sin_cos();
                self.point(sin.atan2(aspect * cos))
            })
            .collect();
        half[0][0] = 0.0;
        half[SAMPLES][0] = 0.0;
        half
    }
}
