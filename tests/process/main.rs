//! Tests that need a process of their own: they read its memory, so that nothing else may run in it.
//!
//! cargo-nextest runs every test in its own process; `cargo test` must run this program with `--test-threads=1`.

mod import_memory;
