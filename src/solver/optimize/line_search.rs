//! Backtracking line search with the test of sufficient decrease of L. Armijo, Pacific J. Math.
//! 16(1), 1966.

use nalgebra::Vector3;

/// Share of the decrease predicted by the slope that a step must bring.
const SUFFICIENT_DECREASE: f64 = 1e-4;

/// Steepness of the objective at the end of a step over that at its start, where the energy does
/// not tell: less than that either way is the way to a minimum.
const LESS_STEEP: f64 = 0.9;
/// Times that a step is doubled along which the objective gets steeper.
const DOUBLINGS: usize = 16;

/// Furthest that a particle moves in one iteration \[m\]; much more would carry cloth through a
/// body.
pub(crate) const MAX_DISPLACEMENT: f64 = 0.04;

/// A function that a line search decreases.
pub(crate) trait Objective {
    /// Returns its value at `x` \[J\].
    fn value(&mut self, x: &[Vector3<f64>]) -> f64;

    /// Takes a trial from `x` back to where it may be.
    fn confine(&mut self, _x: &[Vector3<f64>], _trial: &mut [Vector3<f64>]) {}

    /// Improves a trial that takes `share` of the step and decreases the objective by `decrease`;
    /// returns the decrease then \[J\].
    fn improve(&mut self, _trial: &mut [Vector3<f64>], _share: f64, decrease: f64) -> f64 {
        decrease
    }

    /// Returns the slope of the objective along the step at `trial` over that at its start; 0 if it
    /// cannot be told.
    fn steepness(&mut self, _trial: &[Vector3<f64>]) -> f64 {
        0.0
    }
}

impl<F: FnMut(&[Vector3<f64>]) -> f64> Objective for F {
    fn value(&mut self, x: &[Vector3<f64>]) -> f64 {
        self(x)
    }
}

/// A descent direction and the objective where it begins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineSearch {
    /// Objective at the start \[J\].
    pub(crate) value: f64,
    /// Decrease of the objective per share of the step at the start \[J\].
    pub(crate) slope: f64,
    /// Second derivative of the objective along the step \[J\].
    pub(crate) curvature: f64,
    /// Share of the step that is tried first.
    pub(crate) first_share: f64,
    /// Shares tried at most, each half the one before.
    pub(crate) trials: usize,
}

/// A step that decreased the objective sufficiently.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AcceptedStep {
    /// Share of the whole step.
    pub(crate) share: f64,
    /// Decrease of the objective \[J\]; none where its differences are rounding.
    pub(crate) decrease: Option<f64>,
    /// Slope at its end over that at its start, where the energy does not tell; else 0.
    pub(crate) steepness: f64,
}

impl LineSearch {
    /// Returns the difference of the objective below which it is rounding for `count` particles
    /// \[J\]: there the model is trusted.
    pub(crate) fn rounding(&self, count: usize) -> f64 {
        64.0 * f64::EPSILON * self.value.abs() * (count as f64).sqrt()
    }

    /// Returns the decrease that the quadratic model predicts for a share of the step \[J\].
    pub(crate) fn predicted(&self, share: f64) -> f64 {
        share * self.slope - 0.5 * share * share * self.curvature
    }

    /// Returns the least decrease for which a share of the step is taken \[J\].
    pub(crate) fn sufficient(&self, share: f64) -> f64 {
        SUFFICIENT_DECREASE * share * self.slope
    }

    /// Moves `x` along `step` by the first share that decreases `objective` sufficiently; leaves it
    /// if none does. `trial` is scratch.
    ///
    /// Where the predicted decrease is rounding, the slope still tells (W. W. Hager, H. Zhang, SIAM
    /// J. Optim. 16(1), 2005). It must have fallen, or a step to and fro across a kink would go on
    /// for ever; where it still descends as steeply, near a saddle, the step goes on.
    pub(crate) fn run(
        &self,
        x: &mut [Vector3<f64>],
        (step, trial): (&[Vector3<f64>], &mut [Vector3<f64>]),
        objective: &mut impl Objective,
    ) -> Option<AcceptedStep> {
        let rounding = self.rounding(x.len());
        let mut share = self.first_share;
        for number in 1..=self.trials {
            let decrease = self.try_share(share, x, (step, trial), objective);
            let decrease = objective.improve(trial, share, decrease);
            let predicted = self.predicted(share);
            let is_measurable = predicted > 4.0 * rounding;
            if decrease >= self.sufficient(share) - rounding {
                let steepness = if is_measurable || number == self.trials {
                    0.0
                } else {
                    objective.steepness(trial)
                };
                if steepness > LESS_STEEP {
                    return Some(self.go_on((share, decrease), x, (step, trial), objective));
                } else if steepness >= -LESS_STEEP {
                    x.copy_from_slice(trial);
                    let decrease = is_measurable.then_some(decrease);
                    return Some(AcceptedStep {
                        share,
                        decrease,
                        steepness,
                    });
                }
            }
            share *= 0.5;
        }
        None
    }

    /// Computes the trial that takes `share` of `step`; returns the decrease of the objective
    /// \[J\].
    fn try_share(
        &self,
        share: f64,
        x: &[Vector3<f64>],
        (step, trial): (&[Vector3<f64>], &mut [Vector3<f64>]),
        objective: &mut impl Objective,
    ) -> f64 {
        for ((t, x), d) in trial.iter_mut().zip(x).zip(step) {
            *t = x + d * share;
        }
        objective.confine(x, trial);
        self.value - objective.value(trial)
    }

    /// Moves `x` on from a share of `step` that decreases the objective by `decrease` \[J\] and at
    /// which it still descends, as far as it goes on descending. `trial` is there already.
    fn go_on(
        &self,
        (mut share, mut decrease): (f64, f64),
        x: &mut [Vector3<f64>],
        (step, trial): (&[Vector3<f64>], &mut [Vector3<f64>]),
        objective: &mut impl Objective,
    ) -> AcceptedStep {
        let longest = step.iter().map(Vector3::norm).fold(0.0, f64::max);
        let rounding = self.rounding(x.len());
        let mut furthest = trial.to_vec();
        for _ in 0..DOUBLINGS {
            if 2.0 * share * longest > MAX_DISPLACEMENT {
                break;
            }
            let further = self.try_share(2.0 * share, x, (step, trial), objective);
            if further < decrease - rounding || objective.steepness(trial) <= 0.0 {
                break;
            }
            (share, decrease) = (2.0 * share, further);
            furthest.copy_from_slice(trial);
        }
        x.copy_from_slice(&furthest);
        AcceptedStep {
            share,
            decrease: (decrease > 4.0 * rounding).then_some(decrease),
            steepness: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A saddle whose energy is rounding beside what it is measured from, down to an edge.
    struct Saddle {
        edge: f64,
    }

    impl Saddle {
        const LEVEL: f64 = 1e6;
        /// The start, and the length of the step.
        const START: f64 = 1e-9;
    }

    impl Objective for Saddle {
        fn value(&mut self, x: &[Vector3<f64>]) -> f64 {
            Self::LEVEL - 0.5 * x[0].x.min(self.edge).powi(2)
        }

        fn steepness(&mut self, trial: &[Vector3<f64>]) -> f64 {
            if trial[0].x < self.edge {
                trial[0].x / Self::START
            } else {
                -1.0
            }
        }
    }

    /// The step is as long as the way from the saddle, as that of a modified second derivative is.
    /// From 1 on it is doubled to 16, which leads to 17: 32 would lead beyond the edge at 20.
    #[test]
    fn a_step_away_from_a_saddle_goes_on_while_it_descends() {
        let search = LineSearch {
            value: Saddle::LEVEL,
            slope: Saddle::START.powi(2),
            curvature: Saddle::START.powi(2),
            first_share: 1.0,
            trials: 6,
        };
        let most = f64::from(1_u32 << DOUBLINGS);
        for (edge, share) in [(20.0 * Saddle::START, 16.0), (1.0, most)] {
            let (mut x, mut trial) = ([Vector3::x() * Saddle::START], [Vector3::zeros()]);
            let step = x;
            let found = search.run(&mut x, (&step, &mut trial), &mut Saddle { edge });
            let found = found.expect("it descends");
            assert_eq!((found.share, found.decrease), (share, None));
            assert_eq!(x[0], step[0] + step[0] * share);
        }
    }

    /// A bowl whose depth is rounding beside what it is measured from.
    struct ShallowBowl;

    impl Objective for ShallowBowl {
        fn value(&mut self, x: &[Vector3<f64>]) -> f64 {
            Saddle::LEVEL + 0.5 * x[0].norm_squared()
        }

        fn steepness(&mut self, trial: &[Vector3<f64>]) -> f64 {
            trial[0].x / Saddle::START
        }
    }

    /// The step leads a quarter of the way to the minimum of x²/2, whose slope is x.
    #[test]
    fn a_step_that_ends_short_tells_how_steep_it_is_there() {
        let square = Saddle::START.powi(2);
        let search = LineSearch {
            value: Saddle::LEVEL,
            slope: 0.25 * square,
            curvature: square / 16.0,
            first_share: 1.0,
            trials: 6,
        };
        let (mut x, mut trial) = ([Vector3::x() * Saddle::START], [Vector3::zeros()]);
        let step = [x[0] * -0.25];
        let found = search.run(&mut x, (&step, &mut trial), &mut ShallowBowl);
        let found = found.expect("it descends");
        assert_eq!(
            (found.share, found.decrease, found.steepness),
            (1.0, None, 0.75)
        );
    }

    /// Of x²/2 the step from 1 to -3 overshoots: its half, to -1, brings nothing, its quarter leads
    /// to the minimum.
    #[test]
    fn a_step_is_halved_until_it_descends() {
        let search = LineSearch {
            value: 0.5,
            slope: 4.0,
            curvature: 4.0,
            first_share: 1.0,
            trials: 3,
        };
        let (mut x, mut trial) = ([Vector3::x()], [Vector3::zeros()]);
        let mut half_square = |x: &[Vector3<f64>]| 0.5 * x[0].norm_squared();
        let found = search.run(
            &mut x,
            (&[Vector3::x() * -4.0], &mut trial),
            &mut half_square,
        );
        let found = found.expect("a quarter of the step descends");
        assert_eq!((found.share, found.decrease), (0.25, Some(0.5)));
        assert_eq!(x[0], Vector3::zeros());
        let fewer = LineSearch {
            trials: 2,
            ..search
        };
        let mut x = [Vector3::x()];
        assert!(
            fewer
                .run(
                    &mut x,
                    (&[Vector3::x() * -4.0], &mut trial),
                    &mut half_square
                )
                .is_none()
        );
        assert_eq!(x[0], Vector3::x());
    }
}
