//! Middleware: access control, log, counters.

pub(super) mod access;
mod access_policy;
pub(super) mod answer_bytes;
pub(super) mod observe;
mod request_metrics;
pub(super) mod unread_body;

pub(super) use access_policy::AccessPolicy;
pub(super) use request_metrics::RequestMetrics;
