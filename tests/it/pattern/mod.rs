//! Tests of `pattern`: DXF and GarmentCode files read as panels.

mod allowance;
mod copies;
mod corpus;
mod encoding;
mod gaps;
mod garmentcode;
mod import;
mod loss;
mod nested_blocks;
mod properties;
mod statements;
mod truth;
