//! The longest step with which explicit methods are stable.
//!
//! The highest frequency ω is that of M⁻¹ H in the shape at hand. ω² is found by Lanczos iteration
//! on differences of forces, so no matrix is needed. Its mean error
//! ([`crate::solver::linalg::lanczos`]) is added twice, as is the share by which a shape may
//! stiffen before the limit is updated. Contact, which may not act yet, is added by its bound, and
//! cloth that yields to pressure is taken as taut: it may be in the next step (of poplin hung by
//! two corners, slack at first, the limit is half of that of the slack shape). Gershgorin's bound,
//! which needs no iteration, is twice too high for cloth: its steps are 1.4 times shorter.

use crate::solver::forces::TermKind;
use crate::solver::linalg::lanczos::{
    LanczosLimits, RitzValue, largest_ritz_value, pseudo_random_vectors,
};
use crate::solver::model::system::{System, TimedTerm};
use nalgebra::Vector3;

/// Lanczos iteration for a bound.
const BOUND: LanczosLimits = LanczosLimits {
    products: 48,
    tolerance: 0.0,
};
/// Lanczos iteration for the highest frequency itself.
const CONVERGED: LanczosLimits = LanczosLimits {
    products: 600,
    tolerance: 1e-5,
};
/// Share by which ω² may grow until the limit is computed anew.
const STIFFENING: f64 = 0.05;
/// Furthest that a particle is moved to take differences of forces \[m\]: far below an edge, far
/// above rounding.
const PROBE: f64 = 1e-7;
/// The same where the frequency at that very shape is wanted: cloth that yields to pressure is not
/// linear further off.
const NEAR_PROBE: f64 = 1e-9;

/// Returns a bound on the largest eigenvalue ω² of M⁻¹ H of `system` at `x` \[1/s²\].
pub(crate) fn max_eigenvalue(system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
    let contact = contact_eigenvalue(system);
    set_taut(system, true);
    let unknowns = 3.0 * x.len() as f64;
    let mut probe = HessianProbe::new(system, x, false, PROBE);
    let largest = probe.largest_eigenvalue(BOUND);
    set_taut(system, false);
    let k = largest.products.max(2) as f64 - 1.0;
    let mean_error = if (largest.products as f64) < unknowns.min(BOUND.products as f64) {
        // The iteration ended by itself: the Ritz value is the eigenvalue.
        0.0
    } else {
        0.103 * ((unknowns * k.powi(4)).ln() / k).powi(2)
    };
    largest.value.max(0.0) * (1.0 + 2.0 * mean_error + STIFFENING) + contact
}

/// Takes cloth as taut where it yields to pressure, or no longer does.
fn set_taut(system: &mut System<'_>, taut: bool) {
    for term in &mut system.terms {
        term.potential.set_taut(taut);
    }
}

/// Returns the largest eigenvalue ω² of M⁻¹ H of `system` at `x`, contact as it is there \[1/s²\]:
/// no bound, but the converged value.
pub(crate) fn local_max_eigenvalue(system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
    HessianProbe::new(system, x, true, NEAR_PROBE)
        .largest_eigenvalue(CONVERGED)
        .value
}

/// Returns the longest stable step of symplectic Euler \[s\]: with drag c it is stable while
/// h² ω² + 2 c h <= 4.
pub(crate) fn symplectic_euler(max_eigenvalue: f64, drag: f64) -> f64 {
    if max_eigenvalue == 0.0 {
        if drag == 0.0 {
            f64::INFINITY
        } else {
            2.0 / drag
        }
    } else {
        ((drag * drag + 4.0 * max_eigenvalue).sqrt() - drag) / max_eigenvalue
    }
}

/// Returns the longest stable step of velocity Verlet \[s\]: with drag taken at both ends of the
/// step, h ω <= 2.
pub(crate) fn verlet(max_eigenvalue: f64) -> f64 {
    2.0 / max_eigenvalue.sqrt()
}

/// Returns the bound of contact on the square of a particle's frequency \[1/s²\].
fn contact_eigenvalue(system: &System<'_>) -> f64 {
    let mut stiffness = vec![0.0; system.mass.len()];
    for term in system.terms.iter().filter(|term| is_contact(term)) {
        term.potential.add_stiffness_bound(&mut stiffness);
    }
    let squares = stiffness.iter().zip(&system.mass).map(|(k, m)| k / m);
    squares.fold(0.0, f64::max)
}

fn is_contact(term: &TimedTerm) -> bool {
    term.potential.kind() == TermKind::Contact
}

/// Products of M^-½ H M^-½ with vectors by differences of forces, contact left out or not.
struct HessianProbe<'s, 'a, 'x> {
    system: &'s mut System<'a>,
    x: &'x [Vector3<f64>],
    contact: bool,
    /// \[m\]
    reach: f64,
    moved: Vec<Vector3<f64>>,
    here: Vec<Vector3<f64>>,
    there: Vec<Vector3<f64>>,
}

impl<'s, 'a, 'x> HessianProbe<'s, 'a, 'x> {
    fn new(system: &'s mut System<'a>, x: &'x [Vector3<f64>], contact: bool, reach: f64) -> Self {
        let zero = vec![Vector3::zeros(); x.len()];
        let mut probe = Self {
            system,
            x,
            contact,
            reach,
            moved: x.to_vec(),
            here: zero.clone(),
            there: zero,
        };
        probe.force_at_moved();
        std::mem::swap(&mut probe.here, &mut probe.there);
        probe
    }

    /// Writes the forces at `moved` to `there`.
    fn force_at_moved(&mut self) {
        self.there.fill(Vector3::zeros());
        for term in &mut self.system.terms {
            if self.contact || !is_contact(term) {
                term.potential.add_force(&self.moved, &mut self.there);
            }
        }
        self.system.zero_fixed(&mut self.there);
    }

    /// Writes M^-½ H M^-½ `z` to `product`.
    fn multiply(&mut self, z: &[Vector3<f64>], product: &mut [Vector3<f64>]) {
        let mass = &self.system.mass;
        let reach = z
            .iter()
            .zip(mass)
            .map(|(z, m)| z.amax() / m.sqrt())
            .fold(f64::MIN_POSITIVE, f64::max);
        let share = self.reach / reach;
        for (((moved, x), z), m) in self.moved.iter_mut().zip(self.x).zip(z).zip(mass) {
            *moved = x + z * (share / m.sqrt());
        }
        self.force_at_moved();
        let mass = &self.system.mass;
        for (((p, here), there), m) in product
            .iter_mut()
            .zip(&self.here)
            .zip(&self.there)
            .zip(mass)
        {
            *p = (here - there) / (share * m.sqrt());
        }
    }

    /// Returns the largest eigenvalue of M^-½ H M^-½.
    fn largest_eigenvalue(&mut self, limits: LanczosLimits) -> RitzValue {
        let mut start = pseudo_random_vectors(self.x.len());
        self.system.zero_fixed(&mut start);
        largest_ritz_value(start, limits, &mut |z, product| self.multiply(z, product))
    }
}
