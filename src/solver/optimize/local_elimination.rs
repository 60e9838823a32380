//! Nonlinear elimination of the few particles that a step got wrong.
//!
//! The quadratic model of cloth fails in few places at once: triangles that were folded are pulled
//! taut, forty thousand times stiffer, or bend too far, or meet the body. Their energy alone would
//! shorten the step of the whole garment. So the particles whose forces the step got wrong move on
//! alone, the others held, by Newton steps of their own (P. J. Lanzkron, D. J. Rose, J. T. Wilkes,
//! "An Analysis of Approximate Nonlinear Elimination", SIAM J. Sci. Comput. 17(2), 1996).
//!
//! A particle that came into contact within the step is held: friction has no anchor for it yet,
//! and it would slide without any.

use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::model::system::System;
use crate::solver::optimize::line_search::MAX_DISPLACEMENT;
use crate::solver::optimize::newton_workspace::add_inertia;
use nalgebra::Vector3;
use seamster_cholesky::{Cholesky, FactorMemory};

/// Share of the squared errors of the forces that the particles which move account for.
const COVERED: f64 = 0.99;
/// Largest share of the particles whose forces may be wrong: where more are, the whole step is.
const MOST_WRONG: f64 = 0.25;
/// Largest share of the particles that may move, those around the wrong ones among them.
const MOST_MOVING: f64 = 0.5;
/// Smallest share of the indefinite part that is projected out, where there is no factor.
const LEAST_MODIFICATION: f64 = 0.1;
/// Rounds at one trial.
pub(crate) const ROUNDS: usize = 6;
/// Shares of their step that are tried, each half the one before.
const TRIALS: usize = 4;

/// A step of all particles and the quadratic model that it is from.
#[derive(Clone, Copy)]
pub(crate) struct GlobalStep<'a> {
    pub(crate) sparsity: &'a Sparsity,
    /// Factor of the model; its order serves here too.
    pub(crate) cholesky: &'a Cholesky,
    /// Forces before the step \[N\].
    pub(crate) force: &'a [Vector3<f64>],
    /// True for each particle in contact before the step; empty without contact.
    pub(crate) touching: &'a [bool],
    /// Share of the step that was taken.
    pub(crate) share: f64,
    /// Share of the indefinite part that was projected out.
    pub(crate) modification: f64,
    /// Pseudo-time γ of its proximal term \[s\].
    pub(crate) gamma: f64,
}

/// Scratch memory of local elimination.
pub(crate) struct LocalElimination {
    hessian: BlockMatrix,
    /// Forces at the trial \[N\], and the part of them that the moving particles change.
    force: Vec<Vector3<f64>>,
    near_force: Vec<Vector3<f64>>,
    is_moving: Vec<bool>,
    /// Place of each moving particle among them.
    place: Vec<usize>,
    /// Memory of the factor of the moving particles.
    memory: FactorMemory,
}

impl LocalElimination {
    /// Takes memory for matrices of `sparsity`.
    pub(crate) fn new(sparsity: &Sparsity) -> Self {
        let count = sparsity.particle_count();
        Self {
            hessian: BlockMatrix::zeros(sparsity),
            force: vec![Vector3::zeros(); count],
            near_force: vec![Vector3::zeros(); count],
            is_moving: vec![false; count],
            place: vec![0; count],
            memory: FactorMemory::default(),
        }
    }

    /// Takes memory for matrices of another sparsity of the same particles.
    pub(crate) fn lay_out(&mut self, sparsity: &Sparsity) {
        self.hessian = BlockMatrix::zeros(sparsity);
    }

    /// Moves the few particles that the step to `trial` got wrong, round by round, while a round
    /// decreases the energy by `worth_another` \[J\] and more; returns the decrease \[J\].
    pub(crate) fn run(
        &mut self,
        system: &mut System<'_>,
        global: &GlobalStep<'_>,
        trial: &mut [Vector3<f64>],
        worth_another: f64,
    ) -> f64 {
        let mut decrease = 0.0;
        system.net_force(trial, &mut self.force);
        for _ in 0..ROUNDS {
            let Some(particles) = self.find_moving(system, global, trial) else {
                break;
            };
            system.narrow(Some(&self.is_moving));
            let gain = self.run_round(system, global, &particles, trial);
            system.narrow(None);
            let Some(gain) = gain else { break };
            decrease += gain;
            if gain < worth_another {
                break;
            }
        }
        decrease
    }

    /// Moves `particles` by one Newton step of their own, and brings the forces up to date; returns
    /// the decrease of the energy \[J\], none if they cannot lower it.
    fn run_round(
        &mut self,
        system: &mut System<'_>,
        global: &GlobalStep<'_>,
        particles: &[usize],
        trial: &mut [Vector3<f64>],
    ) -> Option<f64> {
        let step = self.local_step(system, global, particles, trial)?;
        system.net_force(trial, &mut self.near_force);
        for (force, near) in self.force.iter_mut().zip(&self.near_force) {
            *force -= near;
        }
        let decrease = move_along(system, particles, &step, trial);
        system.net_force(trial, &mut self.near_force);
        for (force, near) in self.force.iter_mut().zip(&self.near_force) {
            *force += near;
        }
        decrease
    }

    /// Returns the forces at `x` \[N\].
    pub(crate) fn force_at(
        &mut self,
        system: &mut System<'_>,
        x: &[Vector3<f64>],
    ) -> &[Vector3<f64>] {
        system.net_force(x, &mut self.force);
        &self.force
    }

    /// Returns the particles whose forces are not what the step should have left over, and all that
    /// act on them; none if they are too many.
    fn find_moving(
        &mut self,
        system: &mut System<'_>,
        global: &GlobalStep<'_>,
        trial: &[Vector3<f64>],
    ) -> Option<Vec<usize>> {
        let count = trial.len();
        let left_over = 1.0 - global.share;
        let mut errors: Vec<(f64, usize)> = self
            .force
            .iter()
            .zip(global.force)
            .enumerate()
            .map(|(i, (after, before))| ((after - before * left_over).norm_squared(), i))
            .collect();
        let total: f64 = errors.iter().map(|error| error.0).sum();
        if !total.is_finite() {
            return None;
        }
        errors.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut is_wrong = vec![false; count];
        let mut covered = 0.0;
        for (square, i) in errors {
            if covered > COVERED * total {
                break;
            }
            covered += square;
            is_wrong[i] = true;
        }
        let wrong = is_wrong.iter().filter(|is_wrong| **is_wrong).count();
        if wrong as f64 > (MOST_WRONG * count as f64).max(1.0) {
            return None;
        }
        self.spread(global.sparsity, &is_wrong);
        self.hold(system, global.touching, trial);
        let particles: Vec<usize> = (0..count).filter(|&i| self.is_moving[i]).collect();
        let is_few = particles.len() as f64 <= MOST_MOVING * count as f64;
        (is_few && !particles.is_empty()).then_some(particles)
    }

    /// Lets the wrong particles and those that act on them move.
    fn spread(&mut self, sparsity: &Sparsity, is_wrong: &[bool]) {
        self.is_moving.copy_from_slice(is_wrong);
        for column in 0..is_wrong.len() {
            for (row, _) in sparsity.column(column) {
                self.is_moving[column] |= is_wrong[row];
                self.is_moving[row] |= is_wrong[column];
            }
        }
    }

    /// Holds fixed particles, and those that came into contact within the step.
    fn hold(&mut self, system: &mut System<'_>, touched: &[bool], trial: &[Vector3<f64>]) {
        for (is_moving, is_fixed) in self.is_moving.iter_mut().zip(&system.is_fixed) {
            *is_moving &= !is_fixed;
        }
        if touched.is_empty() {
            return;
        }
        let touching = system.touching(trial);
        for ((is_moving, touching), touched) in self.is_moving.iter_mut().zip(touching).zip(touched)
        {
            *is_moving &= *touched || !touching;
        }
    }

    /// Returns the Newton step of `particles` at `trial`; none if their Hessian has no factor.
    fn local_step(
        &mut self,
        system: &mut System<'_>,
        global: &GlobalStep<'_>,
        particles: &[usize],
        trial: &[Vector3<f64>],
    ) -> Option<Vec<Vector3<f64>>> {
        let sparsity = self.local_sparsity(global.sparsity, particles);
        let mass: Vec<f64> = particles.iter().map(|&i| system.mass[i]).collect();
        let mut local = BlockMatrix::zeros(&sparsity);
        let memory = std::mem::take(&mut self.memory);
        let mut cholesky = sparsity
            .cholesky_within(global.cholesky, particles, memory)
            .ok()?;
        let mut modification = global.modification;
        let is_definite = loop {
            system.hessian(trial, modification, &mut self.hessian);
            self.gather(global.sparsity, particles, &sparsity, &mut local);
            let weight = |mass| mass / (global.gamma * global.gamma);
            add_inertia(&mut local, &sparsity, &mass, weight);
            if let Some(axis) = system.fixed_axis {
                local.constrain_axis(&sparsity, axis);
            }
            let is_definite = cholesky.factorize(&local.blocks).is_ok();
            if is_definite || modification >= 1.0 {
                break is_definite;
            }
            modification = (2.0 * modification).clamp(LEAST_MODIFICATION, 1.0);
        };
        let step = is_definite.then(|| {
            let mut step: Vec<_> = particles.iter().map(|&i| self.force[i]).collect();
            cholesky.solve(&mut step);
            step
        });
        self.memory = cholesky.take_memory();
        step
    }

    fn local_sparsity(&mut self, sparsity: &Sparsity, particles: &[usize]) -> Sparsity {
        for (k, &i) in particles.iter().enumerate() {
            self.place[i] = k;
        }
        let mut pairs = Vec::new();
        for (k, &column) in particles.iter().enumerate() {
            let rows = sparsity.column(column).map(|(row, _)| row);
            let moving = rows.filter(|&row| self.is_moving[row]);
            pairs.extend(moving.map(|row| (k, self.place[row])));
        }
        Sparsity::from_pairs(particles.len(), pairs)
    }

    /// Copies the blocks of the moving particles.
    fn gather(
        &self,
        sparsity: &Sparsity,
        particles: &[usize],
        local_sparsity: &Sparsity,
        local: &mut BlockMatrix,
    ) {
        local.clear();
        for (k, &column) in particles.iter().enumerate() {
            let moving = sparsity
                .column(column)
                .filter(|&(row, _)| self.is_moving[row]);
            for (row, block) in moving {
                let slot = local_sparsity.slot(self.place[row], k);
                local.add(slot, &self.hessian.blocks[block]);
            }
        }
    }
}

/// Moves `particles` along their step as far as the energy allows; returns its decrease \[J\], none
/// if it allows nothing.
fn move_along(
    system: &mut System<'_>,
    particles: &[usize],
    step: &[Vector3<f64>],
    trial: &mut [Vector3<f64>],
) -> Option<f64> {
    let before = system.energy(trial);
    let start: Vec<_> = particles.iter().map(|&i| trial[i]).collect();
    let whole = system.is_confined().then(|| trial.to_vec());
    let longest = step.iter().map(Vector3::norm).fold(0.0, f64::max);
    let mut share = (MAX_DISPLACEMENT / longest).min(1.0);
    for _ in 0..TRIALS {
        for ((&i, start), d) in particles.iter().zip(&start).zip(step) {
            trial[i] = start + d * share;
        }
        if let Some(whole) = &whole {
            system.confine(whole, trial);
        }
        let decrease = before - system.energy(trial);
        if decrease > 0.0 {
            return Some(decrease);
        }
        share *= 0.5;
    }
    for (&i, start) in particles.iter().zip(&start) {
        trial[i] = *start;
    }
    None
}
