//! The codes of placements.

use super::table::fault_codes;

fault_codes! {
    /// The codes of placements.
    PlacementCode in "placement" {
        Lifted = "lifted":
            "Panels start higher than they are put, so that their seams do not close through shoulders or feet.",
            "Put them at `origin` in the garment to have them start where they are put.";
        Moved = "moved":
            "Panels that would stand flat beside an arm or a leg start rolled about that of the body at hand.",
            "Give the panels a placement in the garment, with `\"wrap\": \"flat\"` for legs, to choose their start.";
        SewnFirst = "sewn_first":
            "Panels at the top of a garment are sewn to each other first and held while the rest is sewn to them.",
            "Give seams a `stage` of their own to sew them in another order; with 1 for all, at once.";
        Turned = "turned":
            "A band or sleeve starts turned by quarters from how it is drawn, where its seams are shorter.",
            "Give `up_deg` in the panel's placement to choose the direction that is up.";
        Unknown = "unknown":
            "The name of a panel does not say where on the body it goes.",
            "Give `at`, or take suggested placements.";
    }
}
