//! Faults as single lines of text, for a person or a script.

use super::Fault;
use std::path::Path;

impl Fault {
    /// Returns the fault of `file` as one line: file, place, code, detail and fix.
    pub fn line(&self, file: &Path) -> String {
        let pointer = if self.pointer.is_empty() {
            "/"
        } else {
            &self.pointer
        };
        let mut line = format!(
            "{} {pointer}: {}: {}",
            file.display(),
            self.code,
            self.detail
        );
        if let Some(fix) = &self.fix {
            line.push_str("; fix: ");
            line.push_str(fix);
        }
        without_controls(&line)
    }
}

/// Replaces control characters by blanks: one fault is one line, whatever a name in a file holds.
pub fn without_controls(line: &str) -> String {
    line.replace(|c: char| c.is_control(), " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::SeamCode;

    #[test]
    fn fault_is_one_line_with_all_that_is_known() {
        let fault = Fault::new(SeamCode::Twisted, "/seams/0", "a\nb\u{1b}[31m").fix("turn it");
        assert_eq!(
            fault.line(Path::new("g.json")),
            "g.json /seams/0: seam/twisted: a b [31m; fix: turn it"
        );
    }
}
