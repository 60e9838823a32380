//! Any bytes as a DXF: `cargo fuzz run -s none import fuzz/corpus/import tests/corpus/import`.
#![no_main]

use seamster_fixtures::holds;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| holds::of_file(bytes));
