//! A twist as it is reported.

use crate::fault::Fault;
use crate::pattern::SeamPair;

/// One contradictory cycle.
pub(super) struct TwistFault {
    /// The seam of it that is blamed.
    pub seam: usize,
    /// Its fault.
    pub fault: Fault,
    /// The blamed seam as it could be sewn, where that is known.
    pub corrected: Option<SeamPair>,
}
