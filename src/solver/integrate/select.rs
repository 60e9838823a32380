//! The integrator of each method.

use crate::solver::integrate::explicit::symplectic_euler::SymplecticEuler;
use crate::solver::integrate::explicit::verlet::Verlet;
use crate::solver::integrate::implicit::bdf2::Bdf2;
use crate::solver::integrate::implicit::euler::ImplicitEuler;
use crate::solver::integrate::integrator::Integrator;
use crate::solver::integrate::settings::IntegratorSettings;
use crate::solver::model::system::System;
use crate::solver::options::Method;
use seamster_cholesky::OutOfMemory;

/// Returns the integrator of `method`, `None` if the method takes no steps of time.
///
/// # Errors
/// [`OutOfMemory`] if there is none for the matrix factor of an implicit method.
pub(crate) fn integrator_for(
    system: &mut System<'_>,
    method: Method,
    settings: &IntegratorSettings,
) -> Result<Option<Box<dyn Integrator>>, OutOfMemory> {
    let IntegratorSettings {
        drag,
        speed_limit,
        residual,
    } = *settings;
    Ok(Some(match method {
        Method::SymplecticEuler => Box::new(SymplecticEuler::new(system, drag, speed_limit)),
        Method::Verlet => Box::new(Verlet::new(system, drag, speed_limit)),
        Method::ImplicitEuler => Box::new(ImplicitEuler::new(system, drag, residual)?),
        Method::Bdf2 => Box::new(Bdf2::new(system, drag, residual)?),
        Method::Auto | Method::Newton => return Ok(None),
    }))
}
