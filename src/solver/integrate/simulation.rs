//! The steps of a motion, from frame to frame.
//!
//! Steps end on the times of frames, so no frame is interpolated: the time between two frames is
//! divided evenly by the longest step that may be taken. A step that is not given is chosen by
//! [`crate::solver::integrate::step_control`], for explicit methods below the stability limit too.

use crate::progress::Progress;
use crate::solver::Context;
use crate::solver::integrate::auto_method::{MethodCriteria, choose_method};
use crate::solver::integrate::integrator::{Integrator, ParticleState, StepError};
use crate::solver::integrate::outcome::{MethodReason, MotionTermination, StepExcess};
use crate::solver::integrate::report::{Frame, MotionEnergy, MotionReport};
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::{IntegratorSettings, SAFETY};
use crate::solver::integrate::step_control::StepControl;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::system::System;
use crate::solver::options::{Method, SolverOptions};
use crate::solver::report::measure::energies;

/// Simulated time if none is asked for \[s\].
const DURATION: f64 = 1.0;
/// Frames per simulated second if none are asked for.
const FRAME_RATE: f64 = 30.0;
/// Residual to which implicit steps are solved, over the tolerance \[s/m\]: a net force of r times
/// the weight moves a particle by g r / 2 in a second, which then is 1 % of the tolerance.
const SOLVED: f64 = 2e-3;
/// Step that implicit methods begin with where it is chosen \[s\].
const FIRST_IMPLICIT: f64 = 1e-3;
/// Shortest step \[s\]; what a step cannot follow then is no motion of cloth.
const SHORTEST: f64 = 1e-8;
/// Blocks of steps after which the stability limit is computed anew, since cloth stiffens as it
/// stretches.
const BLOCKS_A_LIMIT: u64 = 40;

/// A motion that is being simulated.
pub(crate) struct MotionSimulation<'r, 'c, 'w> {
    pub(crate) options: &'r SolverOptions,
    pub(crate) began: f64,
    pub(crate) dof_map: &'r DofMap,
    pub(crate) frames: Vec<Frame>,
    /// The method that steps, once it is set up.
    pub(crate) method: Option<Method>,
    /// The reason for it, if it was chosen automatically.
    pub(crate) method_reason: Option<MethodReason>,
    /// Counts, times and limits, but no words.
    pub(crate) report: MotionReport,
    pub(crate) canceled: bool,
    pub(crate) context: &'c mut Context<'w>,
}

impl MotionSimulation<'_, '_, '_> {
    /// Steps from frame to frame.
    ///
    /// # Errors
    /// The reason why it ended before the last frame.
    pub(crate) fn run(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        frequency: f64,
    ) -> Result<(), MotionTermination> {
        let duration = self.options.duration_s.unwrap_or(DURATION);
        let rate = self.options.frame_rate_hz.unwrap_or(FRAME_RATE);
        let count = self.frame_count(duration, rate)?;
        self.add_frame(system, state);
        let (mut integrator, mut control) = self.set_up(system, state, frequency)?;
        for frame in 1..=count {
            let end = (frame as f64 / rate).min(duration);
            self.step_to(system, state, end, (integrator.as_mut(), &mut control))?;
            state.time = end;
            self.report.simulated_s = end;
            self.report.newton_iterations = integrator.newton_iterations();
            self.add_frame(system, state);
        }
        self.report.complete = true;
        Ok(())
    }

    /// Returns the number of frames after the first.
    fn frame_count(&self, duration: f64, rate: f64) -> Result<u64, MotionTermination> {
        let plausible = |v: f64| v.is_finite() && v > 0.0;
        if !(plausible(duration) && plausible(rate)) {
            return Err(MotionTermination::InvalidTimes);
        }
        // A share of 1e-9 is rounding, not another frame.
        let count = (duration * rate - 1e-9).ceil().max(1.0);
        let most = self.context.limits.trajectory_positions;
        if (count + 1.0) * self.dof_map.of_vertex.len() as f64 > most as f64 {
            return Err(MotionTermination::TooManyFrames {
                count,
                positions_allowed: most,
            });
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "positive, and bounded by the limit above"
        )]
        let count = count as u64;
        Ok(count)
    }

    /// Makes the integrator and its step control.
    fn set_up(
        &mut self,
        system: &mut System<'_>,
        state: &ParticleState,
        frequency: f64,
    ) -> Result<(Box<dyn Integrator>, StepControl), MotionTermination> {
        let settings = IntegratorSettings {
            drag: self.report.drag_1_s,
            speed_limit: f64::INFINITY,
            residual: SOLVED * self.options.tolerance,
        };
        let mut method = self.options.method;
        if method == Method::Auto {
            let criteria = MethodCriteria {
                step: self.options.step_s,
                tolerance: self.options.tolerance,
                frequency,
            };
            let chosen = choose_method(system, &state.x, &settings, &criteria);
            method = chosen.0;
            self.method_reason = Some(chosen.1);
        }
        let mut integrator = integrator_for(system, method, &settings)
            .map_err(|_| MotionTermination::OutOfMemory)?
            .ok_or(MotionTermination::NoTimeSteps)?;
        self.method = Some(method);
        self.report.step_bytes = integrator.step_bytes();
        let stable = integrator.stable_step(system, &state.x);
        self.report.stability_limit_s = stable.is_finite().then_some(stable);
        let first = match self.options.step_s {
            Some(asked) if asked > stable => {
                return Err(MotionTermination::StepAboveLimit { limit_s: stable });
            }
            Some(asked) => asked,
            None => (SAFETY * stable).min(FIRST_IMPLICIT),
        };
        // What may be the longest step later on: chosen implicit steps have no such bound.
        let longest = self.options.step_s.unwrap_or(SAFETY * stable);
        let duration = self.options.duration_s.unwrap_or(DURATION);
        if let Some(excess) = StepExcess::of(duration, longest, self.context.limits.steps) {
            return Err(MotionTermination::TooManySteps(excess));
        }
        let tolerance = self
            .options
            .step_s
            .is_none()
            .then_some(self.options.tolerance);
        let mut control = StepControl::new(tolerance, integrator.order(), first);
        control.limit(SAFETY * stable);
        Ok((integrator, control))
    }

    /// Steps to the time `end`.
    fn step_to(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        end: f64,
        (integrator, control): (&mut dyn Integrator, &mut StepControl),
    ) -> Result<(), MotionTermination> {
        let mut before = state.clone();
        let mut blocks = 0;
        // What is left is counted in steps, so that rounding of times adds no step.
        let mut remaining = end - state.time;
        while remaining > 0.0 {
            self.check_limits(state)?;
            let (h, parts) = control.next(remaining);
            let count = parts.min(integrator.block());
            before.copy_from(state);
            let error = match integrator.advance(system, state, h, count) {
                Ok(error) if state.is_finite() => error,
                Ok(_) | Err(StepError::NotFinite) if self.options.step_s.is_some() => {
                    state.copy_from(&before);
                    return Err(MotionTermination::NotFinite { step_s: h });
                }
                Ok(_) | Err(_) => f64::INFINITY,
            };
            let solved = error.is_finite();
            let accepted = solved && control.accepts(h, error);
            if !accepted {
                state.copy_from(&before);
                self.report.rejected += count;
                if !solved {
                    control.shorten(h);
                }
                if h < SHORTEST {
                    return Err(MotionTermination::StepTooShort { step_s: h });
                }
                continue;
            }
            integrator.accept(&before, h);
            self.count(h, count, error);
            remaining = if count == parts {
                0.0
            } else {
                remaining - h * count as f64
            };
            blocks += 1;
            if integrator.block() > 1 && u64::is_multiple_of(blocks, BLOCKS_A_LIMIT) {
                let stable = integrator.stable_step(system, &state.x);
                self.report.within_limits &= h <= stable;
                control.limit(SAFETY * stable);
            }
        }
        Ok(())
    }

    /// Adds accepted steps to the report.
    fn count(&mut self, h: f64, count: u64, error: f64) {
        let report = &mut self.report;
        report.steps += count;
        report.step_min_s = report.step_min_s.min(h);
        report.step_max_s = report.step_max_s.max(h);
        report.local_errors_m += error * h * count as f64;
    }

    /// Reports progress, and ends the motion if it was canceled or has used up what it may.
    fn check_limits(&mut self, state: &ParticleState) -> Result<(), MotionTermination> {
        let cpu_s = (self.context.cpu_s)() - self.began;
        let duration = self.options.duration_s.unwrap_or(DURATION);
        (self.context.progress)(Progress {
            stage: "motion".to_owned(),
            fraction: (state.time / duration).clamp(0.0, 1.0),
            cpu_s,
            ..Progress::default()
        });
        self.canceled = self.context.cancel.is_canceled();
        let limits = self.context.limits;
        let allowed = self.options.time_limit_s.unwrap_or(f64::INFINITY);
        let time_s = state.time;
        if self.canceled {
            Err(MotionTermination::Canceled { time_s })
        } else if cpu_s > allowed.min(limits.fit_cpu_s) {
            Err(MotionTermination::OutOfTime { time_s })
        } else if self.report.steps + self.report.rejected >= limits.steps {
            Err(MotionTermination::StepLimit { time_s })
        } else {
            Ok(())
        }
    }

    /// Adds a frame.
    fn add_frame(&mut self, system: &mut System<'_>, state: &ParticleState) {
        let moving = state.v.iter().zip(&system.mass);
        let kinetic = 0.5 * moving.map(|(v, m)| m * v.norm_squared()).sum::<f64>();
        self.frames.push(Frame {
            time_s: state.time,
            positions: self.dof_map.scatter(&state.x),
            velocities: self.dof_map.scatter(&state.v),
            energy: MotionEnergy {
                kinetic,
                potential: energies(system, &state.x),
            },
        });
    }
}
