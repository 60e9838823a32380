//! Tests of `pattern`: DXF and GarmentCode files read as panels.

mod allowance;
mod cases;
mod copies;
mod corpus;
mod drawn_darts;
mod drawn_notches;
mod encoding;
mod folds;
mod gaps;
mod garmentcode;
mod grading;
mod import;
mod loss;
mod nested;
mod nested_blocks;
mod properties;
mod read;
mod sampled_curves;
mod spoiled;
mod statements;
mod truth;
