//! The length of the next step, from the error of the last.
//!
//! Steps are chosen so that the estimated local error of position over the step's length stays
//! below the tolerance ("error per unit step": E. Hairer, S. P. Nørsett, G. Wanner, "Solving
//! Ordinary Differential Equations I", II.4), so that what adds up over a simulated second is about
//! the tolerance. The estimates compare a step with the derivatives that its own velocities and
//! forces show: nothing is computed twice, as step doubling would (three solves for two), and no
//! second method is carried along.
//!
//! # Limitations
//! Errors of velocity move later positions; where motion is faster than 1 rad/s they add to what is
//! estimated here.

/// Share of the tolerance that is aimed at.
const AIM: f64 = 0.7;
/// Factors by which a step may grow and shrink at once; more than twice would make BDF2 unstable.
const GROWTH: f64 = 2.0;
const SHRINKING: f64 = 0.2;

/// Controller of the step length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepControl {
    /// The error allowed over the time that it is made in \[m/s\]; none for a fixed step.
    tolerance: Option<f64>,
    order: i32,
    /// The step that is not chosen \[s\].
    fixed: f64,
    /// The longest step allowed \[s\].
    longest: f64,
    /// The step that is wanted next \[s\].
    wanted: f64,
}

impl StepControl {
    /// Starts with the step `first` \[s\], and stays with it if there is no tolerance.
    pub(crate) fn new(tolerance: Option<f64>, order: i32, first: f64) -> Self {
        Self {
            tolerance,
            order,
            fixed: first,
            longest: f64::INFINITY,
            wanted: first,
        }
    }

    /// Forbids steps longer than `longest` \[s\], if steps are chosen.
    pub(crate) fn limit(&mut self, longest: f64) {
        if self.tolerance.is_some() {
            self.longest = longest;
        }
    }

    /// Returns the next step \[s\], and how often it fits: `remaining` \[s\] is divided evenly by
    /// the longest step that may be taken.
    pub(crate) fn next(&self, remaining: f64) -> (f64, u64) {
        let wanted = self.wanted.min(self.longest);
        // A share of 1e-9 is rounding, not another step.
        let parts = (remaining / wanted - 1e-9).ceil().max(1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at least 1; the cast saturates far above any limit of steps"
        )]
        let count = parts as u64;
        (remaining / parts, count)
    }

    /// Returns true if a step of `h` \[s\] with this error over its length \[m/s\] is accepted, and
    /// chooses the next one by it.
    pub(crate) fn accepts(&mut self, h: f64, error: f64) -> bool {
        let Some(tolerance) = self.tolerance else {
            self.wanted = self.fixed;
            return true;
        };
        let share =
            (AIM * tolerance / error.max(f64::MIN_POSITIVE)).powf(1.0 / f64::from(self.order));
        self.wanted = (h * share.clamp(SHRINKING, GROWTH)).min(self.longest);
        error <= tolerance
    }

    /// Requests a shorter step than `h` \[s\], which could not be taken.
    pub(crate) fn shorten(&mut self, h: f64) {
        self.wanted = 0.25 * h;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fixed_step_divides_the_time_evenly() {
        let control = StepControl::new(None, 2, 0.003);
        assert_eq!(control.next(0.01), (0.0025, 4));
        assert_eq!(control.next(0.003), (0.003, 1));
        assert_eq!(control.next(0.003 * 7.0).1, 7);
    }

    /// With an error of k h^p over the step's length the step that is aimed at is (0.7 tolerance /
    /// k)^(1/p).
    #[test]
    fn steps_settle_where_the_error_is_what_is_aimed_at() {
        for order in [1, 2] {
            let (k, tolerance) = (3.0, 1e-4);
            let mut control = StepControl::new(Some(tolerance), order, 1e-6);
            for _ in 0..40 {
                let h = control.wanted;
                control.accepts(h, k * h.powi(order));
            }
            let aimed = (0.7 * tolerance / k).powf(1.0 / f64::from(order));
            assert!((control.wanted / aimed - 1.0).abs() < 1e-9);
        }
    }
}
