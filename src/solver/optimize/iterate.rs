//! The interface of iterations toward rest: iterates, the caller's test of them, and the reasons to
//! end.

use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Reason why an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Termination {
    /// The caller's convergence test was met.
    Reached,
    /// No step lowers the energy any more.
    Stalled,
    /// The limit of iterations was reached.
    IterationLimit,
    /// The caller asked to stop.
    Interrupted,
    /// There was no memory for the factor.
    OutOfMemory,
    /// Forces were not finite.
    NotFinite,
}

/// The current iterate, as the caller sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Iterate<'a> {
    /// Iterations before this one.
    pub(crate) number: usize,
    /// Net force on a particle over its weight, RMS.
    pub(crate) residual: f64,
    /// Position of each particle \[m\].
    pub(crate) positions: &'a [Vector3<f64>],
    /// False if the second derivative at the iterate before had no Cholesky factor.
    pub(crate) convex: bool,
    /// False if particles slipped, or came into contact or lost it, in the step to the iterate.
    pub(crate) contact_settled: bool,
    /// Estimate of the distance from the iterate before to the solution \[m, RMS\], where its step
    /// told.
    pub(crate) estimate_before: Option<f64>,
}

/// A caller's test of every iterate: continue, or break with the reason.
pub(crate) type Callback<'f> = dyn FnMut(Iterate<'_>) -> ControlFlow<Termination> + 'f;
