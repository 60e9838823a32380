//! The lengths of steps toward rest: pseudo-time and the modification of the second derivative.
//!
//! Pseudo-transient continuation (C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35(2), 1998): the
//! proximal term M / (2 γ²) `|x - x_n|²` keeps a step short where the quadratic model is not to be
//! trusted, and γ grows as the model predicts better. The share of the indefinite part that is
//! projected out of the second derivative is controlled beside γ.

/// γ at the start \[s\]: about the time in which seams close.
pub(crate) const FIRST_GAMMA: f64 = 0.01;
/// γ at the start from a shape near the solution \[s\]: slow enough for a garment's sway.
pub(crate) const NEAR_GAMMA: f64 = 1.0;
/// γ beyond which the proximal term is lost in rounding \[s\].
const LARGEST_GAMMA: f64 = 1e4;
const SMALLEST_GAMMA: f64 = 1e-7;
/// Share of the indefinite part that is projected out at least after a step that went too far.
const BACKTRACK_MODIFICATION: f64 = 0.4;
/// Factor of that share from one step to the next, and after a step whose factorization failed.
const DECAY: f64 = 0.5;
const AFTER_FAILURE: f64 = 0.9;
/// Smallest share of the indefinite part that is projected out, if any is.
const LEAST_MODIFICATION: f64 = 0.02;

/// Pseudo-time and the modification of the second derivative, adapted from step to step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PseudoTransient {
    /// γ \[s\].
    pub(crate) gamma: f64,
    /// Share of the indefinite part that is projected out of the second derivative.
    pub(crate) modification: f64,
}

impl PseudoTransient {
    /// Starts with the true second derivative and the pseudo-time `gamma` \[s\].
    pub(crate) fn new(gamma: f64) -> Self {
        Self {
            gamma,
            modification: 0.0,
        }
    }

    /// Returns true if steps cannot be made shorter any more.
    pub(crate) fn is_exhausted(&self) -> bool {
        self.gamma <= SMALLEST_GAMMA
    }

    /// Projects out more of the indefinite part; returns false if all of it was projected out
    /// already.
    pub(crate) fn modify_more(&mut self) -> bool {
        if self.modification < 1.0 {
            self.modification = (2.0 * self.modification).clamp(LEAST_MODIFICATION, 1.0);
            return true;
        }
        false
    }

    /// Projects out less in the next step, slowly if a factorization `failed` in this one.
    pub(crate) fn modify_less(&mut self, failed: bool) {
        self.modification *= if failed { AFTER_FAILURE } else { DECAY };
        if self.modification < LEAST_MODIFICATION {
            self.modification = 0.0;
        }
    }

    /// Adapts to a whole step that ended short of the minimum along it, where the objective is
    /// rounding and only its slope tells.
    pub(crate) fn lengthen(&mut self) {
        self.gamma = (3.0 * self.gamma).min(LARGEST_GAMMA);
    }

    /// Adapts to a step of which `share` could be taken, whose objective fell by `decrease` where
    /// `predicted` was predicted.
    ///
    /// Where only a share of the step could be taken, the model was too soft along some wrinkle
    /// that is about to form: projecting out more of what makes it soft shortens the next step
    /// there, while a smaller γ would shorten it everywhere.
    pub(crate) fn adapt(&mut self, share: f64, decrease: f64, predicted: f64) {
        let gamma = if share < 1.0 {
            self.modification = (2.0 * self.modification).clamp(BACKTRACK_MODIFICATION, 1.0);
            0.7 * self.gamma
        } else if decrease > 0.75 * predicted {
            3.0 * self.gamma
        } else if decrease > 0.25 * predicted {
            1.5 * self.gamma
        } else {
            0.7 * self.gamma
        };
        self.gamma = gamma.clamp(SMALLEST_GAMMA * 10.0, LARGEST_GAMMA);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_steps_lengthen_up_to_the_largest_pseudo_time() {
        let mut pseudo_transient = PseudoTransient::new(FIRST_GAMMA);
        pseudo_transient.lengthen();
        assert_eq!(pseudo_transient.gamma, 3.0 * FIRST_GAMMA);
        for _ in 0..20 {
            pseudo_transient.lengthen();
        }
        assert_eq!(pseudo_transient.gamma, LARGEST_GAMMA);
    }
}
