//! The world outside, as a computation may use it: clock, cancel token, progress, limits.

use crate::config::Limits;
use crate::progress::{CancelToken, Progress};

/// The world outside, as a computation may use it.
pub struct Context<'a> {
    /// CPU seconds used so far by the caller's thread: the only clock.
    pub cpu_s: &'a dyn Fn() -> f64,
    /// Cancel token, polled every iteration.
    pub cancel: &'a CancelToken,
    /// Receiver of the progress of every iteration.
    pub progress: &'a mut dyn FnMut(Progress),
    /// Limits on the work.
    pub limits: &'a Limits,
}
