//! The longest stable step of a method as it shows when steps are taken, beside what theory says.
//!
//! A rest shape is disturbed by far less than anything that could make it move otherwise, and steps
//! of one length are taken from there. Above the limit the disturbance of the stiffest mode grows
//! by a factor a step (symplectic Euler at 1 % above: 1.3), so a few hundred steps tell. The
//! longest step with which it stays is found by bisection of the logarithm of the step.

use crate::scene::Scene;
use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::integrate::damping;
use crate::solver::integrate::integrator::{ParticleState, StepError};
use crate::solver::integrate::outcome::StabilityFinding;
use crate::solver::integrate::select::integrator_for;
use crate::solver::integrate::settings::IntegratorSettings;
use crate::solver::integrate::stability::limit;
use crate::solver::linalg::lanczos::pseudo_random_vectors;
use crate::solver::model::build::{Model, build};
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::model::system::System;
use crate::solver::options::{Method, SolverOptions};
use crate::solver::report::motion::describe_stability;
use crate::solver::{Context, Drape};
use nalgebra::Vector3;

/// Disturbance of a particle in each direction at most \[m\].
const DISTURBANCE: f64 = 1e-10;
/// Distance of any particle from the rest shape above which explicit steps count as unstable \[m\].
/// Below the limit a disturbance is carried on, and 1 % below it at most ten times as large; what
/// is left of the net force at rest moves nothing so far in the time. Further off cloth that yields
/// to pressure, or loses touch with the body, is softer, and what grows here may not grow there.
const GROWN: f64 = 1e-7;
/// Explicit steps taken: an instability of 0.1 % above the limit, which grows by 1.09 a step, shows
/// after 80.
const STEPS: u64 = 400;
/// The bracket is narrowed to this ratio.
const NARROW: f64 = 1.01;
/// Number of times that a bracket is widened, and the factor.
const WIDENINGS: u32 = 12;
const WIDER: f64 = 1.5;
/// Share of the guess below which no limit is looked for.
const LEAST_SHARE: f64 = 0.1;
/// Steps of implicit methods that are tried \[s\], and how many of each.
const IMPLICIT: [f64; 3] = [0.01, 0.1, 1.0];
const IMPLICIT_STEPS: u64 = 20;
/// Distance from the rest shape at which implicit steps are said to leave it \[m\]. The time is
/// long: what slides freely slides.
const LEFT: f64 = 1e-3;

/// The longest stable step of one method at one rest shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StableStep {
    /// By theory, from the highest frequency at that shape \[s\]; none for methods that are stable
    /// with any step, and where nothing is stiff.
    pub theory_s: Option<f64>,
    /// The limit that `trajectory` keeps to: theory's with a margin for what it does not see \[s\].
    pub kept_to_s: Option<f64>,
    /// Longest step with which the disturbance did not grow, if with a longer one it did \[s\].
    pub found_s: Option<f64>,
    /// Longest step that was tried \[s\].
    pub tried_s: f64,
    /// True if it was stopped, by the cancel token or its time limit.
    pub stopped: bool,
    /// In words.
    pub because: String,
}

/// Result of steps of one length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum TrialOutcome {
    /// The disturbance stayed small.
    Stayed,
    /// It grew.
    Grew,
    /// The equations of a step were not solved.
    NotSolved,
    /// There was no time for it.
    Stopped,
}

/// Finds the longest stable step of the method that `options` names, near the rest shape `rest` of
/// `scene`, held there by its friction.
///
/// # Guarantees
/// Ends within the time limit of `options` and when canceled; says so. Numbers are finite.
///
/// # Limitations
/// `rest` must be at rest to about 1e-8 of the weight, or it moves by itself. Instabilities that
/// need more than a tiny disturbance (contact that is not touched yet, cloth that stiffens as it
/// stretches) do not show.
pub fn stable_step(
    scene: &Scene,
    options: &SolverOptions,
    rest: &Drape,
    context: &mut Context<'_>,
) -> StableStep {
    let mut trial = StabilityTrial {
        scene,
        options,
        rest: &rest.positions,
        anchors: &rest.anchors,
        began: (context.cpu_s)(),
        context,
    };
    let mut step = StableStep::default();
    let finding = match options.method {
        Method::SymplecticEuler | Method::Verlet => trial.search_explicit(&mut step),
        Method::ImplicitEuler | Method::Bdf2 => trial.search_implicit(&mut step),
        Method::Auto | Method::Newton => StabilityFinding::NoTimeSteps,
    };
    step.stopped = finding == StabilityFinding::Stopped;
    step.because = describe_stability(&finding);
    step
}

/// Returns the longest step that `trajectory` allows the method of `options` at the shape `shape`
/// \[m; `#V`\] of `scene` \[s\]; none for methods that are stable with any step.
pub fn allowed_step(
    scene: &Scene,
    options: &SolverOptions,
    shape: &[Vector3<f64>],
    context: &mut Context<'_>,
) -> Option<f64> {
    if !options.method.is_explicit() {
        return None;
    }
    let trial = StabilityTrial {
        scene,
        options,
        rest: shape,
        anchors: &FrictionAnchors::default(),
        began: 0.0,
        context,
    };
    trial.kept_to()
}

/// Steps from one disturbed rest shape.
struct StabilityTrial<'a, 'c, 'w> {
    scene: &'a Scene,
    options: &'a SolverOptions,
    rest: &'a [Vector3<f64>],
    anchors: &'a FrictionAnchors,
    began: f64,
    context: &'c mut Context<'w>,
}

impl StabilityTrial<'_, '_, '_> {
    /// Searches about the limit of theory, which it notes in `step`.
    fn search_explicit(&mut self, step: &mut StableStep) -> StabilityFinding {
        let square = self.with_system(limit::local_max_eigenvalue);
        let drag = self.drag();
        let theory = match self.options.method {
            Method::Verlet => limit::verlet(square),
            _ => limit::symplectic_euler(square, drag),
        };
        if !(theory.is_finite() && theory > 0.0) {
            return StabilityFinding::Unbounded;
        }
        step.theory_s = Some(theory);
        step.kept_to_s = self.kept_to();
        self.bisect(theory, step)
    }

    /// Narrows a bracket round the limit that begins about `guess` \[s\] and is widened until it
    /// holds it.
    fn bisect(&mut self, guess: f64, step: &mut StableStep) -> StabilityFinding {
        let (mut low, mut high) = (guess / WIDER, guess * WIDER.powi(2));
        let (mut low_known, mut high_known) = (false, false);
        for _ in 0..2 * WIDENINGS {
            // What moves with steps of any length is not driven by them.
            if (low_known && high_known) || low < LEAST_SHARE * guess {
                break;
            }
            let h = if low_known { high } else { low };
            step.tried_s = step.tried_s.max(h);
            match self.steps(h, STEPS, GROWN) {
                TrialOutcome::Stopped => return StabilityFinding::Stopped,
                TrialOutcome::Stayed if low_known => (low, high) = (high, high * WIDER),
                TrialOutcome::Stayed => low_known = true,
                _ if low_known => high_known = true,
                _ => {
                    (high, low) = (low, low / WIDER);
                    high_known = true;
                }
            }
        }
        if !low_known {
            return StabilityFinding::NotAtRest { step_s: low };
        }
        if !high_known {
            return StabilityFinding::NoneExplicit {
                tried_s: step.tried_s,
            };
        }
        while high > NARROW * low {
            let middle = (low * high).sqrt();
            match self.steps(middle, STEPS, GROWN) {
                TrialOutcome::Stopped => return StabilityFinding::Stopped,
                TrialOutcome::Stayed => low = middle,
                _ => high = middle,
            }
        }
        step.found_s = Some(low);
        StabilityFinding::Bracketed {
            steps: STEPS,
            disturbance_m: DISTURBANCE,
            stable_s: low,
            unstable_s: high,
        }
    }

    /// Tries implicit steps, ever longer ones.
    fn search_implicit(&mut self, step: &mut StableStep) -> StabilityFinding {
        for h in IMPLICIT {
            match self.steps(h, IMPLICIT_STEPS, LEFT) {
                TrialOutcome::Stayed => step.tried_s = h,
                TrialOutcome::Stopped => return StabilityFinding::Stopped,
                TrialOutcome::Grew => {
                    return StabilityFinding::LeftRest {
                        tried_s: step.tried_s,
                        step_s: h,
                    };
                }
                TrialOutcome::NotSolved => {
                    return StabilityFinding::NotSolved {
                        tried_s: step.tried_s,
                        step_s: h,
                    };
                }
            }
        }
        StabilityFinding::NoneImplicit {
            tried_s: step.tried_s,
        }
    }

    /// Returns the drag per mass \[1/s\].
    fn drag(&self) -> f64 {
        self.scene.drag.unwrap_or_else(|| damping::drag(self.scene))
    }

    /// Returns the limit that `trajectory` keeps to \[s\].
    fn kept_to(&self) -> Option<f64> {
        let (method, settings) = (self.options.method, self.settings());
        let step = self.with_system(
            |system, x| match integrator_for(system, method, &settings) {
                Ok(Some(mut integrator)) => integrator.stable_step(system, x),
                _ => f64::INFINITY,
            },
        );
        step.is_finite().then_some(step)
    }

    /// Returns the parameters of the integrator.
    fn settings(&self) -> IntegratorSettings {
        IntegratorSettings {
            drag: self.drag(),
            speed_limit: f64::INFINITY,
            residual: 0.0,
        }
    }

    /// Takes `count` steps of `h` \[s\] from the disturbed rest shape, or fewer if it is further
    /// than `grown` \[m\] away before.
    fn steps(&mut self, h: f64, count: u64, grown: f64) -> TrialOutcome {
        let (method, settings) = (self.options.method, self.settings());
        let (began, allowed) = (
            self.began,
            self.options.time_limit_s.unwrap_or(f64::INFINITY),
        );
        let (clock, cancel) = (self.context.cpu_s, self.context.cancel);
        let allowed = allowed.min(self.context.limits.fit_cpu_s);
        let is_over = move || cancel.is_canceled() || clock() - began > allowed;
        self.with_system(|system, rest| {
            let mut shape = rest.to_vec();
            disturb(&mut shape);
            let mut moved: Vec<_> = shape.iter().zip(rest).map(|(x, r)| x - r).collect();
            system.zero_fixed(&mut moved);
            for ((x, r), m) in shape.iter_mut().zip(rest).zip(&moved) {
                *x = r + m;
            }
            let mut state = ParticleState::at_rest(&shape);
            let Ok(Some(mut integrator)) = integrator_for(system, method, &settings) else {
                return TrialOutcome::NotSolved;
            };
            let mut taken = 0;
            while taken < count {
                if is_over() {
                    return TrialOutcome::Stopped;
                }
                let before = state.clone();
                let block = integrator.block().min(count - taken);
                match integrator.advance(system, &mut state, h, block) {
                    Ok(_) if state.is_finite() => {}
                    Err(StepError::NotConverged) => {
                        return TrialOutcome::NotSolved;
                    }
                    _ => return TrialOutcome::Grew,
                }
                integrator.accept(&before, h);
                taken += block;
                if max_distance(&state.x, rest) > grown {
                    return TrialOutcome::Grew;
                }
            }
            TrialOutcome::Stayed
        })
    }

    /// Calls `f` with a system that remembers nothing of other trials, and the rest shape of its
    /// particles.
    fn with_system<T>(&self, f: impl FnOnce(&mut System<'_>, &[Vector3<f64>]) -> T) -> T {
        let sewing = self.options.sewing_stiffness();
        let build_options = BuildOptions {
            seams: Seams::closed(self.options, sewing),
            hold: None,
            gravity: true,
            friction: Some(self.anchors),
            explicit: self.options.method.is_explicit(),
            least_thickness: None,
            finest: true,
        };
        let Model {
            dof_map,
            mut system,
        } = build(self.scene, self.options, &build_options, self.context.cpu_s);
        f(&mut system, &dof_map.average(self.rest))
    }
}

/// Returns the largest distance of a particle between two shapes \[m\].
fn max_distance(x: &[Vector3<f64>], y: &[Vector3<f64>]) -> f64 {
    let apart = x.iter().zip(y).map(|(x, y)| (x - y).norm_squared());
    apart.fold(0.0, f64::max).sqrt()
}

/// Moves every particle by at most the disturbance in each direction, the same every time.
fn disturb(shape: &mut [Vector3<f64>]) {
    let moves = pseudo_random_vectors(shape.len());
    for (x, m) in shape.iter_mut().zip(moves) {
        *x += m * (2.0 * DISTURBANCE);
    }
}
