//! Measures of a drape and the sentences of its report.

pub(crate) mod cost_model;
pub(crate) mod describe;
pub(crate) mod history;
pub(crate) mod measure;
pub(crate) mod schema;
pub(crate) mod unfinished;
