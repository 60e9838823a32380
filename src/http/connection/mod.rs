//! What slow clients may hold: time, and bytes in flight.

mod byte_budget;
mod patience;
mod patient_stream;

pub(super) use byte_budget::{ByteBudget, HeldBytes, held};
pub(super) use patience::Patience;
pub(super) use patient_stream::PatientStream;
