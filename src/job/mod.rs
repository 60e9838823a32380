//! Fits queued, stored and run by workers.
