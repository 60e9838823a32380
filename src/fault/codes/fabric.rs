//! The codes of fabrics.

use super::table::fault_codes;

fault_codes! {
    /// The codes of fabrics.
    FabricCode in "fabric" {
        Coefficient = "coefficient":
            "A coefficient is not that of a cloth.",
            "Give a value within the range that the fault names; mind the unit in the name.";
        NameTooLong = "name_too_long":
            "The name of a fabric has too many characters.",
            "Shorten it.";
    }
}
