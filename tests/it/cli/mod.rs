//! Tests of `cli`: the program run as a process.

mod commands;
