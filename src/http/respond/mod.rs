//! Answers: problems, and representations with entity tags and ranges.

mod byte_range;
mod conversions;
mod problem;
mod representation;

pub use problem::Problem;
pub(super) use representation::{Representation, respond_computed, respond_stored};
