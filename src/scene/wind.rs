//! Wind: the velocity of the air round the garment, steady or gusting the same way every time.

use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Moving air, the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Mean velocity \[m/s\].
    pub velocity: Vector3<f64>,
    /// Size of the gusts as a share of the mean speed; 0 is steady.
    pub gust: f64,
}

/// Frequency \[Hz\] and phase \[rad\] of the sines that a gust is made of. No frequency is a simple
/// multiple of another, so that the gust does not repeat within minutes.
const SINES: [[f64; 2]; 4] = [[0.13, 0.4], [0.31, 2.3], [0.73, 4.1], [1.70, 5.6]];

impl Wind {
    /// Velocity at `time` \[s\] after the start \[m/s\]: the mean times 1 + gust g(t), |g| <= 1.
    ///
    /// The sines of g have amplitudes that fall as f^(-1/3): the power per octave of turbulence of
    /// A. N. Kolmogorov's f^(-5/3) spectrum (1941).
    pub fn at(&self, time: f64) -> Vector3<f64> {
        if self.gust == 0.0 {
            return self.velocity;
        }
        let (mut sum, mut most) = (0.0, 0.0);
        for [frequency, phase] in SINES {
            let amplitude = 1.0 / frequency.cbrt();
            sum += amplitude * (TAU * frequency * time + phase).sin();
            most += amplitude;
        }
        self.velocity * (1.0 + self.gust * sum / most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slowest sine has a period of 7.7 s: 0.02 s apart over 10 minutes sees every swing.
    #[test]
    fn a_gust_swings_about_the_mean_by_no_more_than_its_share() {
        let wind = Wind {
            velocity: Vector3::new(0.0, 0.0, 4.0),
            gust: 0.5,
        };
        let speeds: Vec<f64> = (0..30_000)
            .map(|i| wind.at(0.02 * f64::from(i)).z)
            .collect();
        let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
        let (least, most) = speeds
            .iter()
            .fold((f64::MAX, 0.0_f64), |(a, b), v| (a.min(*v), b.max(*v)));
        assert!((2.0..2.4).contains(&least) && (5.6..=6.0).contains(&most));
        // Each sine averages to at most its amplitude over 2 pi times its cycles, 78 or more.
        assert!((mean - 4.0).abs() < 0.01, "{mean}");
        let steady = Wind { gust: 0.0, ..wind };
        assert_eq!(steady.at(1.23), wind.velocity);
    }
}
