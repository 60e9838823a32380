//! The codes of files on the command line.

use super::table::fault_codes;

fault_codes! {
    /// The codes of files on the command line.
    FileCode in "file" {
        Unreadable = "unreadable":
            "A file cannot be read or is too large.",
            "Check its path and its size.";
    }
}
