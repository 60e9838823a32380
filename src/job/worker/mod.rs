//! Threads that take jobs from the store and run them.

mod active_runs;
mod attempt;
mod context;
mod pool;
mod run_result;
mod runner;
mod wake_signal;

pub use pool::WorkerPool;
pub use runner::{Runner, SolverRunner};
