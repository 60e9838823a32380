//! What was noticed on the way: faults, warnings, and counts of what was left out.

use crate::fault::{Fault, Faults, Warning};
use std::collections::BTreeMap;

/// At most this many faults, and as many warnings, are told of one file.
const MOST: usize = 100;

/// A place in a file.
pub(super) fn at_line(line: usize) -> String {
    format!("line {line}")
}

/// Everything noticed in one file.
#[derive(Default)]
pub(super) struct Findings {
    /// What keeps the file from being read.
    pub(super) faults: Vec<Fault>,
    /// What the user should know.
    pub(super) warnings: Vec<Warning>,
    /// How many warnings there are beyond those.
    more: usize,
    /// How many entities of a kind were left out, and the line of the first.
    left_out: BTreeMap<String, (usize, usize)>,
    /// How many entities were not flat, and the line of the first.
    projected: Option<(usize, usize)>,
}

impl Findings {
    /// Notes something that the user should know.
    pub(super) fn warn(&mut self, code: &str, line: usize, detail: impl Into<String>) {
        if self.warnings.len() < MOST {
            self.warnings
                .push(Warning::new(code, at_line(line), detail));
        } else {
            self.more += 1;
        }
    }

    /// Notes an entity that is not read.
    pub(super) fn left_out(&mut self, kind: &str, line: usize) {
        self.left_out_many(kind, line, 1);
    }

    /// Notes several entities of a kind that are not read.
    pub(super) fn left_out_many(&mut self, kind: &str, line: usize, count: usize) {
        let kind = super::tags::shown(kind);
        let kind = if self.left_out.len() < MOST || self.left_out.contains_key(&kind) {
            kind
        } else {
            "other kinds".to_owned()
        };
        self.left_out.entry(kind).or_insert((0, line)).0 += count;
    }

    /// Notes an entity whose z is not 0.
    pub(super) fn projected(&mut self, line: usize) {
        self.projected.get_or_insert((0, line)).0 += 1;
    }

    /// Whether anything keeps the file from being read.
    pub(super) fn refused(&self) -> bool {
        !self.faults.is_empty()
    }

    /// All warnings, those with counts too.
    pub(super) fn take_warnings(&mut self) -> Vec<Warning> {
        let mut warnings = std::mem::take(&mut self.warnings);
        for (kind, (count, line)) in std::mem::take(&mut self.left_out) {
            let detail = format!("{count} of {kind} left out, the first here");
            warnings.push(Warning::new(
                "pattern/entity_ignored",
                at_line(line),
                detail,
            ));
        }
        if let Some((count, line)) = self.projected.take() {
            let detail = format!(
                "{count} entities with z other than 0 were taken as seen from above, the first here"
            );
            warnings.push(Warning::new("pattern/not_flat", at_line(line), detail));
        }
        if self.more > 0 {
            let detail = format!("and {} more warnings", self.more);
            warnings.push(Warning::new("pattern/more", "line 1", detail));
        }
        warnings
    }

    /// `value`, unless there is a fault.
    pub(super) fn or<T>(self, value: T) -> Result<T, Faults> {
        Faults(capped(self.faults)).or(value)
    }

    /// The faults with `fault` after them.
    pub(super) fn and(self, fault: Fault) -> Faults {
        let mut faults = self.faults;
        faults.push(fault);
        Faults(capped(faults))
    }

    /// The fault for a file without pieces: an outline that is wrong, else that there is none.
    pub(super) fn none_found(&mut self) -> Fault {
        if let Some(last) = self.faults.pop() {
            return last;
        }
        let hint = self
            .left_out
            .keys()
            .next()
            .map_or_else(String::new, |kind| {
                format!(" (it has {kind}, which is not read)")
            });
        Fault::new(
            "pattern/no_outline",
            "line 1",
            format!("the file holds no closed outline{hint}"),
        )
        .fix("export the pieces as closed polylines, in blocks on layer 1 (AAMA or ASTM)")
    }
}

fn capped(mut faults: Vec<Fault>) -> Vec<Fault> {
    let more = faults.len().saturating_sub(MOST);
    faults.truncate(MOST);
    if more > 0 {
        faults.push(Fault::new(
            "pattern/more",
            "line 1",
            format!("and {more} more faults"),
        ));
    }
    faults
}
