//! Minimization of the energy of a system.

pub(crate) mod eliminated_energy;
pub(crate) mod iterate;
pub(crate) mod line_search;
pub(crate) mod local_elimination;
pub(crate) mod newton;
pub(crate) mod newton_workspace;
pub(crate) mod pseudo_transient;

#[cfg(test)]
mod local_elimination_tests;
