//! Findings of an import: faults and warnings, each at its JSON Pointer.

use crate::fault::{Fault, PatternCode, Warning};

/// Largest number of faults, and of warnings, that are reported of one file.
const MOST: usize = 100;

/// The faults and warnings of one file.
#[derive(Default)]
pub(super) struct SpecFindings {
    /// Faults that keep it from being read.
    pub(super) faults: Vec<Fault>,
    /// Warnings for the user.
    pub(super) warnings: Vec<Warning>,
    /// Number of points of all outlines so far.
    pub(super) points: usize,
    /// Number of faults beyond [`MOST`].
    left_out: usize,
}

impl SpecFindings {
    /// Adds a fault.
    pub(super) fn fault(&mut self, fault: Fault) {
        if self.faults.len() < MOST {
            self.faults.push(fault);
        } else {
            self.left_out += 1;
        }
    }

    /// Adds a warning.
    pub(super) fn warn(&mut self, code: PatternCode, pointer: &str, detail: impl Into<String>) {
        if self.warnings.len() < MOST {
            self.warnings.push(Warning::new(code, pointer, detail));
        }
    }

    /// Returns all faults, with the number of those that are left out.
    pub(super) fn into_faults(mut self) -> Vec<Fault> {
        if self.left_out > 0 {
            let detail = format!("and {} more faults", self.left_out);
            self.faults.push(Fault::new(PatternCode::More, "", detail));
        }
        self.faults
    }
}
