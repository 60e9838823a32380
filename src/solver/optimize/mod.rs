//! Minimization of the energy of a system.

pub(crate) mod newton;
