//! Velocity Verlet with drag: order 2, keeps angular momentum.
//!
//! L. Verlet, Phys. Rev. 159, 1967; drag as A. Brünger, C. L. Brooks, M. Karplus, Chem. Phys. Lett.
//! 105(5), 1984: half a step with drag taken at its beginning, half a step with drag taken at its
//! end. The two halves are each other's adjoint, so the whole is symmetric and of order 2, and drag
//! does not touch the stability limit h ω <= 2. Two halves that meet are one step of the rule V =
//! (1 - ch/2) / (1 + ch/2) V + h / (1 + ch/2) F/m, X += V h on velocities half a step off: the pass
//! of the paper's method with other numbers. Velocities are brought on and off the step where a
//! block of steps begins and ends.

use crate::solver::integrate::explicit::kernel::StepRule;
use crate::solver::integrate::explicit::stepper::ExplicitStepper;
use crate::solver::integrate::integrator::{Integrator, ParticleState, StepError, accept};
use crate::solver::integrate::stability::limit;
use crate::solver::model::system::System;
use nalgebra::Vector3;

/// Steps taken at once.
const BLOCK: u64 = 100;

/// Velocity Verlet.
pub(crate) struct Verlet {
    explicit: ExplicitStepper,
    drag: f64,
    speed_limit: f64,
    force: Vec<Vector3<f64>>,
}

impl Verlet {
    /// Makes the method with drag per mass `drag` \[1/s\] and no speed above `speed_limit` \[m/s\].
    pub(crate) fn new(system: &System<'_>, drag: f64, speed_limit: f64) -> Self {
        Self {
            explicit: ExplicitStepper::new(system),
            drag,
            speed_limit,
            force: vec![Vector3::zeros(); system.particle_count()],
        }
    }

    /// Computes the acceleration of every particle into `force`.
    fn acceleration(&mut self, system: &mut System<'_>, state: &ParticleState) {
        accept(system, state);
        system.net_force(&state.x, &mut self.force);
        for (f, m) in self.force.iter_mut().zip(&system.mass) {
            *f /= *m;
        }
    }
}

impl Integrator for Verlet {
    fn order(&self) -> i32 {
        2
    }

    fn block(&self) -> u64 {
        BLOCK
    }

    fn step_bytes(&self) -> u64 {
        self.explicit.bytes()
    }

    fn operations(&self) -> f64 {
        self.explicit.operations()
    }

    fn stable_step(&mut self, system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
        limit::verlet(limit::max_eigenvalue(system, x))
    }

    /// Positions miss the third derivative, h³/6 of it; that is what the acceleration changed by
    /// over h.
    fn advance(
        &mut self,
        system: &mut System<'_>,
        state: &mut ParticleState,
        h: f64,
        count: u64,
    ) -> Result<f64, StepError> {
        let half = 0.5 * self.drag * h;
        let rule = StepRule {
            keep: (1.0 - half) / (1.0 + half),
            gain: h / (1.0 + half),
            h,
            speed_limit: self.speed_limit,
        };
        self.acceleration(system, state);
        for (v, a) in state.v.iter_mut().zip(&self.force) {
            *v = *v * (1.0 + half) - a * (0.5 * h);
        }
        self.explicit.run(system, state, rule, count);
        self.acceleration(system, state);
        let before = &self.explicit.v_before;
        let drag = self.drag;
        let mut square = 0.0;
        for ((v, a), before) in state.v.iter_mut().zip(&self.force).zip(before) {
            let last = (*v - before) / h;
            *v = (*v + a * (0.5 * h)) / (1.0 + half);
            square += (a - *v * drag - last).norm_squared();
        }
        let error = h / 6.0 * (square / state.v.len().max(1) as f64).sqrt();
        error
            .is_finite()
            .then_some(error)
            .ok_or(StepError::NotFinite)
    }
}
