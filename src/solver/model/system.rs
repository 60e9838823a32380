//! The particles of a garment and the force terms that act on them: only those that the scene
//! needs.

use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Vector3;

/// Standard gravity, by which residuals are scaled \[m/s²\].
pub(crate) const STANDARD_GRAVITY: f64 = 9.80665;

/// Particles and the terms that act on them.
pub(crate) struct System<'a> {
    /// Mass of each particle \[kg\]; `#P`.
    pub(crate) mass: Vec<f64>,
    /// True for each particle that does not move; `#P`.
    pub(crate) is_fixed: Vec<bool>,
    /// The coordinate in which no particle moves.
    pub(crate) fixed_axis: Option<usize>,
    /// The terms, with the CPU time spent in each.
    pub(crate) terms: Vec<TimedTerm>,
    /// The only clock \[CPU s\].
    pub(crate) clock: &'a dyn Fn() -> f64,
}

/// A term and the CPU time spent in it.
pub(crate) struct TimedTerm {
    pub(crate) potential: Box<dyn Potential>,
    pub(crate) cpu_s: f64,
}

impl System<'_> {
    /// Returns the number of particles.
    pub(crate) fn particle_count(&self) -> usize {
        self.mass.len()
    }

    /// Returns the sparsity of the Hessian, after every term has looked up its blocks in it.
    pub(crate) fn bind(&mut self) -> Sparsity {
        let mut pairs = Vec::new();
        for term in &self.terms {
            term.potential.add_coupled_pairs(&mut pairs);
        }
        let sparsity = Sparsity::from_pairs(self.particle_count(), pairs);
        self.for_each(|force| force.bind(&sparsity));
        sparsity
    }

    /// Returns true if every force has an energy.
    pub(crate) fn is_conservative(&self) -> bool {
        self.terms
            .iter()
            .all(|term| term.potential.is_conservative())
    }

    /// Writes to `out` the antisymmetric part of the negative derivative of all forces at `x`,
    /// times `d`, which is zero for fixed particles.
    pub(crate) fn antisymmetric_product(
        &self,
        x: &[Vector3<f64>],
        d: &[Vector3<f64>],
        out: &mut [Vector3<f64>],
    ) {
        out.fill(Vector3::zeros());
        for term in &self.terms {
            term.potential.add_antisymmetric_product(x, d, out);
        }
        self.zero_fixed(out);
    }

    /// Takes `x` as an accepted shape; returns true if anything slipped on the body, or other
    /// layers of cloth touch than before.
    pub(crate) fn accept(&mut self, x: &[Vector3<f64>]) -> bool {
        let mut slipped = false;
        for term in &mut self.terms {
            slipped |= term.potential.accept(x);
        }
        slipped
    }

    /// Returns true if moves may have to be cut short.
    pub(crate) fn is_confined(&self) -> bool {
        self.has(TermKind::SelfContact)
    }

    /// Cuts the moves of particles from `from` to `to` short where cloth would pass through cloth.
    pub(crate) fn confine(&mut self, from: &[Vector3<f64>], to: &mut [Vector3<f64>]) {
        if self.is_confined() {
            self.for_each(|term| term.confine(from, to));
        }
    }

    /// Moves particles of `x` apart where cloth passes through cloth, as far as that can be done;
    /// returns true if it did anywhere.
    pub(crate) fn untangle(&mut self, x: &mut [Vector3<f64>]) -> bool {
        let mut was_tangled = false;
        for term in &mut self.terms {
            was_tangled |= term.potential.untangle(x, &self.is_fixed);
        }
        was_tangled
    }

    /// Returns true if the matrices have to be laid out anew for the accepted shape.
    pub(crate) fn has_outgrown(&self) -> bool {
        self.terms.iter().any(|term| term.potential.has_outgrown())
    }

    /// Returns true if a term of this kind acts.
    pub(crate) fn has(&self, kind: TermKind) -> bool {
        self.terms.iter().any(|term| term.potential.kind() == kind)
    }

    /// Returns true for each particle in contact at `x`; `#P`.
    pub(crate) fn touching(&mut self, x: &[Vector3<f64>]) -> Vec<bool> {
        let mut touching = vec![false; x.len()];
        for term in &mut self.terms {
            term.potential.mark_touching(x, &mut touching);
        }
        touching
    }

    /// Returns the points that friction holds the particles by; empty without friction.
    pub(crate) fn anchors(&self) -> FrictionAnchors {
        let mut anchors = self.terms.iter().map(|term| term.potential.anchors());
        anchors.find_map(|held| held).unwrap_or_default()
    }

    /// Sets the velocities of the particles \[m/s\] at `time` \[s\]; without it they rest in the
    /// mean wind.
    pub(crate) fn set_motion(&mut self, velocity: &[Vector3<f64>], time: f64) {
        for term in &mut self.terms {
            term.potential.set_motion(velocity, time);
        }
    }

    /// Returns the energy of all terms \[J\].
    pub(crate) fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.for_each(|force| sum += force.energy(x));
        sum
    }

    /// Returns the energy of the terms of this kind \[J\], 0 if there is none.
    pub(crate) fn energy_of(&mut self, kind: TermKind, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.for_each(|force| {
            if force.kind() == kind {
                sum += force.energy(x);
            }
        });
        sum
    }

    /// Computes the net force on each particle \[N\], zero on those that are fixed.
    pub(crate) fn net_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        force.fill(Vector3::zeros());
        self.for_each(|term| term.add_force(x, force));
        self.zero_fixed(force);
    }

    /// Adds the forces of all terms that are not marked in `except` \[N\].
    pub(crate) fn add_forces_except(
        &mut self,
        except: &[bool],
        x: &[Vector3<f64>],
        force: &mut [Vector3<f64>],
    ) {
        let mut except = except.iter();
        self.for_each(|term| {
            if except.next() != Some(&true) {
                term.add_force(x, force);
            }
        });
    }

    /// Sets to zero the vectors of fixed particles, and the coordinate along the fixed axis.
    pub(crate) fn zero_fixed(&self, vectors: &mut [Vector3<f64>]) {
        for (v, _) in vectors
            .iter_mut()
            .zip(&self.is_fixed)
            .filter(|(_, is_fixed)| **is_fixed)
        {
            *v = Vector3::zeros();
        }
        if let Some(axis) = self.fixed_axis {
            vectors.iter_mut().for_each(|v| v[axis] = 0.0);
        }
    }

    /// Removes what is fixed from `hessian`: its rows and columns become those of the identity.
    pub(crate) fn constrain(&self, sparsity: &Sparsity, hessian: &mut BlockMatrix) {
        hessian.constrain(sparsity, &self.is_fixed);
        if let Some(axis) = self.fixed_axis {
            hessian.constrain_axis(sparsity, axis);
        }
    }

    /// Computes the Hessian of the energy, less the share `hessian_modification` of the part that
    /// may be indefinite.
    pub(crate) fn hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        hessian.clear();
        self.for_each(|force| force.add_hessian(x, hessian_modification, hessian));
    }

    /// Evaluates only what has a particle of `moving`, until it is called without: energies are
    /// then right up to a constant, forces and Hessians on those particles.
    pub(crate) fn narrow(&mut self, moving: Option<&[bool]>) {
        for term in &mut self.terms {
            term.potential.narrow(moving);
        }
    }

    /// Returns a bound on the stiffness of each particle in the rest shape \[N/m\].
    pub(crate) fn stiffness(&mut self) -> Vec<f64> {
        let mut sum = vec![0.0; self.particle_count()];
        self.for_each(|force| force.add_stiffness_bound(&mut sum));
        sum
    }

    /// Returns the mean weight of a particle under standard gravity \[N\].
    fn mean_weight(&self) -> f64 {
        self.mass.iter().sum::<f64>() * STANDARD_GRAVITY / self.particle_count().max(1) as f64
    }

    /// Returns `r = sqrt(sum |f_i|² / n) / (M 9.80665 / n)`: the net force on a particle over its
    /// weight.
    pub(crate) fn residual(&self, force: &[Vector3<f64>]) -> f64 {
        let count = force.len() as f64;
        let weight = self.mean_weight();
        (force.iter().map(Vector3::norm_squared).sum::<f64>() / count).sqrt() / weight
    }

    /// Returns the residual below which forces are rounding: k eps |x| / (m g), k the stiffness of
    /// a particle.
    pub(crate) fn residual_floor(&mut self, x: &[Vector3<f64>]) -> f64 {
        let stiffness = self.stiffness();
        let count = x.len() as f64;
        let weight = self.mean_weight();
        // Each of the ~10 differences that make up a force is rounded on its own, so the errors add
        // as squares.
        let rounding = stiffness
            .iter()
            .zip(x)
            .map(|(k, x)| (k * f64::EPSILON * x.norm()).powi(2) / 10.0)
            .sum::<f64>();
        (rounding / count).sqrt() / weight
    }

    fn for_each(&mut self, mut run: impl FnMut(&mut dyn Potential)) {
        let mut before = (self.clock)();
        for term in &mut self.terms {
            run(term.potential.as_mut());
            let now = (self.clock)();
            term.cpu_s += now - before;
            before = now;
        }
    }
}
