//! Any bytes as a DXF: `cargo fuzz run -s none import fuzz/corpus/import tests/corpus/import`.
#![no_main]

#[path = "../../tests/support/holds.rs"]
mod holds;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| holds::of_file(bytes));
