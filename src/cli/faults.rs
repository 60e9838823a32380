//! Faults, warnings and suggested seams as lines for a person or a script.

use seamster::fault::{Fault, Faults, Warning};
use seamster::seam::suggest::SuggestedSeam;
use std::path::Path;

/// Writes a fault as one line: file, place, code, detail and fix.
fn fault_line(file: &Path, fault: &Fault) -> String {
    let mut line = format!(
        "{} {}: {}: {}",
        file.display(),
        shown_pointer(&fault.pointer),
        fault.code,
        fault.detail
    );
    if let Some(fix) = &fault.fix {
        line.push_str("; fix: ");
        line.push_str(fix);
    }
    without_controls(&line)
}

/// Replaces control characters: one fault is one line, whatever a name in a file holds.
fn without_controls(line: &str) -> String {
    line.replace(|c: char| c.is_control(), " ")
}

fn shown_pointer(pointer: &str) -> &str {
    if pointer.is_empty() { "/" } else { pointer }
}

/// Prints every fault of a file to stderr.
pub(super) fn print_faults(file: &Path, faults: &Faults) {
    for fault in &faults.0 {
        eprintln!("{}", fault_line(file, fault));
    }
}

/// Prints every warning about a file to stderr.
pub(super) fn print_warnings(file: &Path, warnings: &[Warning]) {
    for warning in warnings {
        let fault = Fault::new(warning.code.clone(), &warning.pointer, &warning.detail);
        eprintln!("warning: {}", fault_line(file, &fault));
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

#[cfg(test)]
mod tests {
    use super::*;
    use seamster::fault::SeamCode;

    #[test]
    fn fault_is_one_line_with_all_that_is_known() {
        let fault = Fault::new(SeamCode::Twisted, "/seams/0", "a\nb\u{1b}[31m").fix("turn it");
        let text = fault_line(Path::new("g.json"), &fault);
        assert_eq!(
            text,
            "g.json /seams/0: seam/twisted: a b [31m; fix: turn it"
        );
    }
}
