//! The codes of placements.

use super::table::fault_codes;

fault_codes! {
    /// The codes of placements.
    PlacementCode in "placement" {
        Unknown = "unknown":
            "The name of a panel does not say where on the body it goes.",
            "Give `at`, or take suggested placements.";
    }
}
