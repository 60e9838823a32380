//! Faults of a seam allowance that cannot be cut away.

use crate::fault::{Fault, PatternCode};
use crate::pattern::Panel;

/// Returns a fault; its pointer is empty.
pub(super) fn refuse(detail: String, fix: &str) -> Fault {
    Fault::new(PatternCode::Allowance, "", detail).fix(fix)
}

/// Returns the fault for a panel of which nothing is left.
pub(super) fn nothing_left(panel: &Panel, width: f64) -> Fault {
    let detail = format!(
        "with {width} m cut away, nothing of panel {} is left",
        panel.id
    );
    refuse(detail, "give a smaller allowance")
}
