//! Faults as lines for a person or a script.

use seamster::fault::{Fault, Faults, Warning};
use seamster::seam::suggest::SuggestedSeam;
use std::path::Path;

/// One line: the file, where in it, what kind, what is wrong and what to do.
fn line(file: &Path, fault: &Fault) -> String {
    let mut line = format!(
        "{} {}: {}: {}",
        file.display(),
        place(&fault.pointer),
        fault.code,
        fault.detail
    );
    if let Some(fix) = &fault.fix {
        line.push_str("; fix: ");
        line.push_str(fix);
    }
    plain(&line)
}

/// One fault is one line, whatever a name in a file holds.
fn plain(line: &str) -> String {
    line.replace(|c: char| c.is_control(), " ")
}

fn place(pointer: &str) -> &str {
    if pointer.is_empty() { "/" } else { pointer }
}

/// Writes every fault of a file to stderr.
pub(super) fn tell(file: &Path, faults: &Faults) {
    for fault in &faults.0 {
        eprintln!("{}", line(file, fault));
    }
}

/// Writes every warning about a file to stderr.
pub(super) fn warn(file: &Path, warnings: &[Warning]) {
    for warning in warnings {
        let fault = Fault::new(&warning.code, &warning.pointer, &warning.detail);
        eprintln!("warning: {}", line(file, &fault));
    }
}

/// Writes every seam that was suggested to stderr: the garment's file, its place, its id, how sure it is and why.
pub(super) fn tell_suggested(file: &Path, seams: &[SuggestedSeam]) {
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
        eprintln!("suggested: {}", plain(&line));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fault_is_one_line_with_all_that_is_known() {
        let fault = Fault::new("seam/twisted", "/seams/0", "a\nb\u{1b}[31m").fix("turn it");
        let text = line(Path::new("g.json"), &fault);
        assert_eq!(
            text,
            "g.json /seams/0: seam/twisted: a b [31m; fix: turn it"
        );
    }
}
