//! From a [`crate::scene::Scene`] to a [`Drape`]: sews and drapes, and says how far to trust the shape.

mod ask;
mod report;

pub use ask::{Membrane, Method, SeamClose, Simulate, Want};
pub use report::{CpuSeconds, Energy, ErrorPoint, LeftOut, Report, Term, Worn};

use crate::progress::{CancelToken, Progress};
use crate::scene::Scene;
use nalgebra::Vector3;

/// The settled shape, and what is known about it.
#[derive(Clone, Debug)]
pub struct Drape {
    /// Position of each vertex \[m\]; `#V`.
    pub positions: Vec<Vector3<f64>>,
    /// How far to trust it.
    pub report: Report,
    /// Whether it was stopped by the cancel token.
    pub canceled: bool,
}

/// What a computation may use of the world outside.
pub struct Context<'a> {
    /// CPU seconds used so far by this process or thread; the only clock.
    pub cpu_s: &'a dyn Fn() -> f64,
    /// Polled every iteration.
    pub cancel: &'a CancelToken,
    /// Told of every iteration.
    pub progress: &'a mut dyn FnMut(Progress),
    /// Bounds on the work.
    pub limits: &'a crate::config::Limits,
}

/// Sews and drapes.
pub fn drape(scene: &Scene, _ask: &Simulate, _context: &mut Context<'_>) -> Drape {
    Drape {
        positions: scene.start.clone(),
        report: Report::default(),
        canceled: false,
    }
}
