//! Contact with the body, with friction.

mod body;
mod layer;
mod pressure;

pub use body::Anchors;
pub(crate) use body::{BodyContact, Friction};
pub use pressure::{contact_force, contact_pressure};
