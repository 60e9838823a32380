//! Contact with the body, with friction.

mod body;
mod layer;
mod pressure;

pub(crate) use crate::solver::forces::contact::body::{BodyContact, Friction};
pub use crate::solver::forces::contact::pressure::{contact_force, contact_pressure};
