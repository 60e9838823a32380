//! Implicit time integration.

pub(crate) mod bdf2;
pub(crate) mod euler;
pub(crate) mod incremental_potential;
