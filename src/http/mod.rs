//! The service.

mod json_schema;
mod nearest;
mod problem;
mod shape;

pub use problem::Problem;
