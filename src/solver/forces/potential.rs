//! The terms that a system is made of: an energy of particle positions, its force and its Hessian.

use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::forces::pair::PairForces;
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Vector3;

/// Kind of a term of the energy: what it is reported as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum TermKind {
    /// Stretch and shear of the membrane.
    Stretch,
    /// Bending.
    Bend,
    /// Weight.
    Gravity,
    /// Moving air.
    Wind,
    /// Stitches.
    Seam,
    /// The body, with its friction.
    Contact,
    /// Contact of cloth with cloth.
    SelfContact,
}

impl TermKind {
    /// Returns the name that reports give it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Stretch => "stretch",
            Self::Bend => "bend",
            Self::Gravity => "gravity",
            Self::Wind => "wind",
            Self::Seam => "seam",
            Self::Contact => "contact",
            Self::SelfContact => "self_contact",
        }
    }
}

/// One term of the energy of a garment.
///
/// `x` are particle positions \[m\], `#P`. Energies are in joules, forces in newtons, Hessians in
/// newtons per meter. A force that is not conservative, such as wind, has an energy of its own
/// around each accepted shape, see `wind.rs`.
pub(crate) trait Potential {
    /// Returns what the term is reported as.
    fn kind(&self) -> TermKind;

    /// Appends every pair of particles that act on each other through the term.
    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>);

    /// Looks up the blocks of `sparsity` that the Hessian of the term is added to.
    fn bind(&mut self, sparsity: &Sparsity);

    /// Returns the energy \[J\].
    fn energy(&mut self, x: &[Vector3<f64>]) -> f64;

    /// Adds the negative gradient of the energy to `force` \[N\].
    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]);

    /// Adds the Hessian of the energy, less the share `hessian_modification` of the part that may
    /// be indefinite: at 0 the true Hessian, at 1 a positive semidefinite one.
    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    );

    /// Adds to each particle a bound on the row sum of the Hessian in the rest shape \[N/m\]: it
    /// limits explicit steps and scales the rounding of forces.
    fn add_stiffness_bound(&self, stiffness: &mut [f64]);

    /// Returns true if the force is the gradient of one energy everywhere, so that its Jacobian is
    /// symmetric.
    fn is_conservative(&self) -> bool {
        true
    }

    /// Adds to `out` the antisymmetric part of the negative Jacobian of the force at `x`, times
    /// `d`; nothing if the term is conservative.
    fn add_antisymmetric_product(
        &self,
        _x: &[Vector3<f64>],
        _d: &[Vector3<f64>],
        _out: &mut [Vector3<f64>],
    ) {
    }

    /// Takes `x` as an accepted shape, from which lagged quantities are computed anew; returns true
    /// if anything slipped on the way there, or touches that did not.
    fn accept(&mut self, _x: &[Vector3<f64>]) -> bool {
        false
    }

    /// Cuts the moves of particles from `from` to `to` short where cloth would pass through cloth.
    fn confine(&mut self, _from: &[Vector3<f64>], _to: &mut [Vector3<f64>]) {}

    /// Returns true if particles act on each other in the accepted shape whose blocks the sparsity
    /// lacks.
    fn has_outgrown(&self) -> bool {
        false
    }

    /// Moves particles of `x` that are not fixed apart where cloth passes through cloth, as far as
    /// that can be done; returns true if it did anywhere.
    fn untangle(&mut self, _x: &mut [Vector3<f64>], _is_fixed: &[bool]) -> bool {
        false
    }

    /// Marks the particles that are in contact at `x`.
    fn mark_touching(&mut self, _x: &[Vector3<f64>], _touching: &mut [bool]) {}

    /// Returns the points that friction holds the particles by; none without friction.
    fn anchors(&self) -> Option<FrictionAnchors> {
        None
    }

    /// Evaluates only what has a particle of `moving`, until it is called without: energies are
    /// then right up to a constant, forces and Hessians on those particles. A term may ignore it.
    fn narrow(&mut self, _moving: Option<&[bool]>) {}

    /// Sets the velocities of the particles \[m/s\] and the time \[s\], for forces that depend on
    /// either.
    fn set_motion(&mut self, _velocity: &[Vector3<f64>], _time: f64) {}

    /// Makes the term act, while `taut`, as stiffly as in any shape near the one at hand: what
    /// yields under compression does not.
    fn set_taut(&mut self, _taut: bool) {}

    /// Adds the term to `pair_forces` if it consists of pair forces and constant forces only;
    /// returns false, and adds nothing, if it does not.
    fn add_to_pair_forces(&self, _pair_forces: &mut PairForces) -> bool {
        false
    }
}
