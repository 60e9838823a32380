//! Faults, warnings and suggested seams as lines for a person or a script.

use seamster::fault::{Fault, Faults, Warning, without_controls};
use seamster::seam::suggest::SuggestedSeam;
use std::path::Path;

/// Prints every fault of a file to stderr.
pub(super) fn print_faults(file: &Path, faults: &Faults) {
    for fault in &faults.0 {
        eprintln!("{}", fault.line(file));
    }
}

/// Prints every warning about a file to stderr.
pub(super) fn print_warnings(file: &Path, warnings: &[Warning]) {
    for warning in warnings {
        let fault = Fault::new(warning.code.clone(), &warning.pointer, &warning.detail);
        eprintln!("warning: {}", fault.line(file));
    }
}

/// Prints every suggested seam to stderr: the garment's file, place, id, confidence and reason.
pub(super) fn print_suggested(file: &Path, seams: &[SuggestedSeam]) {
    for (i, seam) in seams.iter().enumerate() {
        let file = file.display();
        let SuggestedSeam {
            pair,
            confidence,
            because,
        } = seam;
        let line = format!(
            "{file} /seams/{i}: {}: confidence {confidence}: {because}",
            pair.id
        );
        eprintln!("suggested: {}", without_controls(&line));
    }
}
