//! Threads that take jobs from the store and run them.

mod active_runs;
mod attempt;
mod child;
mod context;
mod pool;
mod run_permits;
mod run_result;
mod runner;
mod wake_signal;

pub use child::{follow_child, run_child};
pub use pool::WorkerPool;
pub use runner::{RunError, Runner, SolverRunner};
