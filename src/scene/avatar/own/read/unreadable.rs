//! The fault of a file that cannot be read.

use crate::fault::{AvatarCode, Fault};

/// The fault of a file at a place: `line 7`, `byte 120`, `/meshes/0`.
pub(super) fn unreadable(place: impl Into<String>, detail: impl Into<String>) -> Fault {
    let fault = Fault::new(AvatarCode::File, place, detail);
    fault.fix("export the body again, as an OBJ, a binary glTF 2.0 or a PLY file")
}
