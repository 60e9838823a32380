//! Tests of `study`: methods compared on one garment.

mod runs;
