//! Tests on whole processes: the program as it is started and killed, and the memory of the test
//! itself.
//!
//! cargo-nextest runs every test in a process of its own. `cargo test` must run this program with
//! `--test-threads=1`, so that nothing else takes memory while it is measured, and no two services
//! compete for the machine.

mod api_examples;
mod commands;
mod hostile;
mod import_memory;
mod program;
mod service;
