//! The end of a process that ran one job and left no result.

use std::fmt;

/// The cause of the death of a process that ran one job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProcessDeath {
    /// It wanted more memory than it may have.
    Memory,
    /// It was ended by this signal.
    Signal(i32),
    /// It ended by itself, without a result.
    NoResult,
}

/// The number of SIGKILL, by which the system ends processes when memory is short.
const KILL: i32 = 9;

impl fmt::Display for ProcessDeath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Memory => f.write_str("it wanted more memory than it may have"),
            Self::Signal(KILL) => {
                f.write_str("it was ended by signal 9, as the system does when memory is short")
            }
            Self::Signal(number) => write!(f, "it was ended by signal {number}"),
            Self::NoResult => f.write_str("it ended without a result"),
        }
    }
}
