//! Tests of the whole crate, by the rules and against slow exact arithmetic of another kind.

mod bodies;
mod exact;
mod meshes;
mod pairs;
pub(crate) mod random;
