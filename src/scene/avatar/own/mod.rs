//! Bodies of one's own: from the file of a body, of any axes, unit and scale, to one that cloth is
//! draped on.
//!
//! 1. [`read`]: bytes to triangles.
//! 2. [`mend`]: vertices at one place made one, small pieces left out, triangles of one sense,
//!    holes closed.
//! 3. [`upright`] and [`scale`]: the way up and ahead, and the unit, by the body's own shape.
//! 4. [`landmarks`]: on the surface and beneath it.

mod body;
mod import;
mod landmarks;
mod limb_axis;
mod mend;
mod read;
mod scale;
mod upright;

pub use body::OwnBody;
pub use import::{BodyImport, BodyImportOptions, FileAxis, import_body};
pub use read::BodyFormat;
pub use scale::BodyUnits;
