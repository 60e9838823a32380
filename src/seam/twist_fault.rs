//! A twist as it is reported, and lists of names in its sentences.

use crate::fault::Fault;
use crate::pattern::SeamPair;

/// Names listed in one sentence before it says how many more there are.
const MAX_NAMED: usize = 8;

/// One contradictory cycle.
pub(super) struct TwistFault {
    /// The seam of it that is blamed.
    pub seam: usize,
    /// Its fault.
    pub fault: Fault,
    /// The blamed seam as it could be sewn, where that is known.
    pub corrected: Option<SeamPair>,
}

/// Returns names in quotation marks, each once, with "and" before the last.
pub(super) fn quoted_list<'a>(names: impl Iterator<Item = &'a String>) -> String {
    let mut quoted: Vec<String> = vec![];
    for name in names.map(|name| format!("`{name}`")) {
        if !quoted.contains(&name) {
            quoted.push(name);
        }
    }
    if quoted.len() > MAX_NAMED {
        let more = quoted.len() - MAX_NAMED;
        quoted.truncate(MAX_NAMED);
        quoted.push(format!("{more} more"));
    }
    match quoted.pop() {
        Some(last) if !quoted.is_empty() => format!("{} and {last}", quoted.join(", ")),
        Some(last) => last,
        None => String::new(),
    }
}
