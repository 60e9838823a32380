//! The report of a drape: its measures, its convergence history, and its sentences, which
//! [`describe`] makes after the solve.

pub(crate) mod contact_force;
pub(crate) mod cost_model;
pub(crate) mod describe;
pub(crate) mod history;
pub(crate) mod measure;
pub(crate) mod motion;
pub(crate) mod schema;
