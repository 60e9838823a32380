//! Bounds on what slow clients hold: time, and bytes in flight.

mod byte_budget;
mod client;
mod patience;
mod patient_stream;

pub(super) use byte_budget::{ByteBudget, HeldBytes, held};
pub(super) use client::Client;
pub(super) use patience::Patience;
pub(super) use patient_stream::PatientStream;
