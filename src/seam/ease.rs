//! The ease that two sides of different length leave.

use super::SeamFinding;
use crate::fault::{Fault, SeamCode, Warning};
use crate::pattern::SeamPair;

/// Differences above this are noted \[m\].
const NOTED_EASE_M: f64 = 1e-3;

/// Ease above this is much for a plain seam.
const LARGE_EASE: f64 = 0.15;

/// Ease above this is refused unless gathering is requested.
const MAX_EASE: f64 = 0.30;

/// Writes lengths and ease of a seam into its finding, with what is to be said about them.
pub(super) fn record_ease(finding: &mut SeamFinding, pair: &SeamPair, pointer: &str) {
    let (a, b) = (finding.length_a_m, finding.length_b_m);
    let (longer, shorter) = (a.max(b), a.min(b));
    finding.ease = longer / shorter - 1.0;
    finding.ease_m = longer - shorter;
    let side = if a > b { "a" } else { "b" };
    let detail = format!(
        "side {side} of seam `{}` is longer by {:.1} mm ({:.1} %): {:.1} mm to {:.1} mm",
        pair.id,
        finding.ease_m * 1e3,
        finding.ease * 1e2,
        longer * 1e3,
        shorter * 1e3,
    );
    if finding.ease > MAX_EASE && !pair.gather {
        finding.errors.push(
            Fault::new(SeamCode::EaseTooLarge, pointer, detail)
                .fix("check that the right edges are picked; set `gather` if the longer side is to be gathered"),
        );
    } else if finding.ease > LARGE_EASE && !pair.gather {
        let detail = format!("{detail}, which is much for a seam that is not gathered");
        finding
            .warnings
            .push(Warning::new(SeamCode::Ease, pointer, detail));
    } else if finding.ease_m > NOTED_EASE_M {
        let detail = format!("{detail}, which is eased in");
        finding
            .warnings
            .push(Warning::new(SeamCode::Ease, pointer, detail));
    }
}
