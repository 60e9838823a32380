//! Tests of `job`: the queue, its store and its workers.

mod counted_renewals;
mod queue;
