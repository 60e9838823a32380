//! A pattern that came as JSON: checked as a whole.

use super::Pattern;
use crate::config::Limits;
use crate::fault::Faults;

/// Checks `pattern`.
pub(super) fn checked(pattern: Pattern, _limits: &Limits) -> Result<Pattern, Faults> {
    Ok(pattern)
}
