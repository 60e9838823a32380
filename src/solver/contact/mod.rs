//! Contact with the body, with friction.

mod body;

pub(crate) use body::{BodyContact, Friction};
