//! Findings of an import: faults, warnings, and counts of the entities that are not read.

use crate::fault::{Fault, Faults, PatternCode, Warning};
use std::collections::BTreeMap;

/// Largest number of faults, and of warnings, that are reported of one file.
const MOST: usize = 100;

/// Returns the pointer of a line of the file.
pub(super) fn at_line(line: usize) -> String {
    format!("line {line}")
}

/// Returns at most 40 characters of a text of the file, for a message.
pub(super) fn excerpt(text: &str) -> String {
    text.trim().chars().take(40).collect()
}

/// The faults and warnings of one file.
#[derive(Default)]
pub(super) struct DxfFindings {
    /// Faults that keep the file from being read.
    pub(super) faults: Vec<Fault>,
    /// True if what would be mended or left out is refused.
    is_strict: bool,
    /// Faults that keep single pieces from being read, each with the number of their entities.
    refused: Vec<(Fault, usize)>,
    /// Warnings for the user.
    pub(super) warnings: Vec<Warning>,
    /// Number of warnings beyond those.
    more: usize,
    /// Number of entities of a kind that were not read, and the line of the first.
    skipped: BTreeMap<String, (usize, usize)>,
    /// Number of outlines inside others by what they were taken as, and the line of the first.
    inside: BTreeMap<&'static str, (usize, usize)>,
    /// Number of entities that were not flat, and the line of the first.
    projected: Option<(usize, usize)>,
}

impl DxfFindings {
    /// Returns no findings. `is_strict`: what would be mended or left out is refused.
    pub(super) fn new(is_strict: bool) -> Self {
        Self {
            is_strict,
            ..Self::default()
        }
    }

    /// Adds a warning.
    pub(super) fn warn(&mut self, code: PatternCode, line: usize, detail: impl Into<String>) {
        if self.warnings.len() < MOST {
            self.warnings
                .push(Warning::new(code, at_line(line), detail));
        } else {
            self.more += 1;
        }
    }

    /// Leaves a piece of so many entities, or a hole of it, out for a fault.
    pub(super) fn leave_out(&mut self, fault: Fault, entities: usize) {
        self.refused.push((fault, entities));
    }

    /// Warns of what was mended; where the caller is strict it is a fault.
    pub(super) fn mend(&mut self, code: PatternCode, line: usize, detail: String) {
        if self.is_strict {
            let fault = Fault::new(code, at_line(line), detail);
            self.faults.push(fault.fix("mend it in the CAD program"));
        } else {
            self.warn(code, line, detail);
        }
    }

    /// Makes warnings of the faults of pieces that were left out; faults of the file where the
    /// caller is strict, or `is_all`: nothing is left.
    pub(super) fn settle_left_out(&mut self, is_all: bool) {
        for (fault, entities) in std::mem::take(&mut self.refused) {
            if self.is_strict || is_all {
                self.faults.push(fault);
            } else if self.warnings.len() < MOST {
                let fix = fault.fix.as_deref().unwrap_or("mend it in the CAD program");
                let detail = format!(
                    "{entities} entities left out: {}; {fix}, or state strict=true to refuse such files",
                    fault.detail
                );
                let code = PatternCode::PieceLeftOut;
                self.warnings
                    .push(Warning::new(code, fault.pointer, detail));
            } else {
                self.more += 1;
            }
        }
    }

    /// Notes an entity that is not read.
    pub(super) fn skip(&mut self, kind: &str, line: usize) {
        self.skip_many(kind, line, 1);
    }

    /// Notes several entities of a kind that are not read.
    pub(super) fn skip_many(&mut self, kind: &str, line: usize, count: usize) {
        let kind = excerpt(kind);
        let kind = if self.skipped.len() < MOST || self.skipped.contains_key(&kind) {
            kind
        } else {
            "other kinds".to_owned()
        };
        self.skipped.entry(kind).or_insert((0, line)).0 += count;
    }

    /// Notes an outline inside another by what it was taken as.
    pub(super) fn note_inside(&mut self, taken_as: &'static str, line: usize) {
        self.inside.entry(taken_as).or_insert((0, line)).0 += 1;
    }

    /// Notes an entity whose z is not 0.
    pub(super) fn note_projected(&mut self, line: usize) {
        self.projected.get_or_insert((0, line)).0 += 1;
    }

    /// Returns true if anything keeps the file from being read.
    pub(super) fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    /// Takes out all warnings, those with counts too.
    pub(super) fn take_warnings(&mut self) -> Vec<Warning> {
        let mut warnings = std::mem::take(&mut self.warnings);
        for (kind, (count, line)) in std::mem::take(&mut self.skipped) {
            let detail = format!("{count} of {kind} left out, the first here");
            warnings.push(Warning::new(
                PatternCode::EntityIgnored,
                at_line(line),
                detail,
            ));
        }
        for (taken_as, (count, line)) in std::mem::take(&mut self.inside) {
            let detail =
                format!("{count} outlines inside others, the first here, were taken as {taken_as}");
            let code = PatternCode::OutlineInside;
            warnings.push(Warning::new(code, at_line(line), detail));
        }
        if let Some((count, line)) = self.projected.take() {
            let detail = format!(
                "{count} entities with z other than 0 were taken as seen from above, the first here"
            );
            warnings.push(Warning::new(PatternCode::NotFlat, at_line(line), detail));
        }
        if self.more > 0 {
            let detail = format!("and {} more warnings", self.more);
            warnings.push(Warning::new(PatternCode::More, "line 1", detail));
        }
        warnings
    }

    /// Returns `value`, unless there is a fault.
    pub(super) fn into_result<T>(self, value: T) -> Result<T, Faults> {
        Faults(capped(self.faults)).or(value)
    }

    /// Returns the faults with `fault` after them.
    pub(super) fn into_faults_with(self, fault: Fault) -> Faults {
        let mut faults = self.faults;
        faults.push(fault);
        Faults(capped(faults))
    }

    /// Returns the fault of a file without pieces: an outline that is wrong, else that there is
    /// none.
    pub(super) fn no_outline(&mut self) -> Fault {
        let refused = std::mem::take(&mut self.refused).into_iter();
        self.faults.extend(refused.map(|(fault, _)| fault));
        if let Some(last) = self.faults.pop() {
            return last;
        }
        let hint = self.skipped.keys().next().map_or_else(String::new, |kind| {
            format!(" (it has {kind}, which is not read)")
        });
        let detail = format!("the file holds no closed outline{hint}");
        Fault::new(PatternCode::NoOutline, "line 1", detail)
            .fix("export the pieces as closed polylines, in blocks on layer 1 (AAMA or ASTM)")
    }
}

fn capped(mut faults: Vec<Fault>) -> Vec<Fault> {
    let more = faults.len().saturating_sub(MOST);
    faults.truncate(MOST);
    if more > 0 {
        let detail = format!("and {more} more faults");
        faults.push(Fault::new(PatternCode::More, "line 1", detail));
    }
    faults
}
