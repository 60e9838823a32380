//! Limits of the step: by theory, by trial, and by the number of steps allowed.

pub(crate) mod feasibility;
pub(crate) mod limit;
pub(crate) mod trial;
