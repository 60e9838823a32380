//! Minimization of the energy of a system.

pub(crate) mod iterate;
pub(crate) mod newton;
