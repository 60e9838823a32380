//! Any bytes as the seams of a pattern: `cargo fuzz run -s none seams fuzz/corpus/seams
//! tests/corpus/seams`.
#![no_main]

use seamster_fixtures::holds;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| holds::of_seams(bytes));
