//! The cost of a drape that led to another one, which its report is to name.

use crate::solver::{DrapeReport, TermTime};

/// Adds to the report of a drape what the one before it took: iterations, levels and times.
pub(super) fn add(report: &mut DrapeReport, earlier: DrapeReport) {
    report.newton_iterations += earlier.newton_iterations;
    report.levels.splice(0..0, earlier.levels);
    report.cpu_s.sew += earlier.cpu_s.sew;
    report.cpu_s.drape += earlier.cpu_s.drape;
    for TermTime { name, cpu_s } in earlier.terms {
        match report.terms.iter_mut().find(|term| term.name == name) {
            Some(term) => term.cpu_s += cpu_s,
            None => report.terms.push(TermTime { name, cpu_s }),
        }
    }
}
