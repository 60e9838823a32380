//! Tests of `pattern`: DXF and GarmentCode files read as panels.

mod allowance;
mod copies;
mod corpus;
mod courses;
mod folds;
mod garmentcode;
mod grading;
mod import;
mod loss;
mod nested;
mod properties;
mod read;
mod spoiled;
mod truth;
