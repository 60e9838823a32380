//! How long a step may be, and whether the steps that a motion needs are within the limits.

pub(crate) mod feasibility;
pub(crate) mod limit;
pub(crate) mod trial;
