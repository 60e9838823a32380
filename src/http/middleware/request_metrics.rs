//! Counts of requests, in the Prometheus text format.

use axum::http::Method;
use std::collections::BTreeMap;
use std::fmt::{self, Write};
use std::sync::{Mutex, PoisonError};

/// Number and time of requests by method, route and status. Routes are those of the router, never
/// paths: labels stay few.
#[derive(Debug, Default)]
pub(in crate::http) struct RequestMetrics {
    // A std mutex: held for one addition, never over an await.
    requests: Mutex<BTreeMap<(String, String, u16), RequestStats>>,
}

#[derive(Clone, Copy, Debug, Default)]
struct RequestStats {
    count: u64,
    seconds: f64,
}

impl RequestMetrics {
    /// Counts one request.
    pub(super) fn add(&self, method: &Method, route: String, status: u16, seconds: f64) {
        let method = match method.as_str() {
            known @ ("GET" | "HEAD" | "POST" | "DELETE") => known,
            _ => "other",
        };
        let mut requests = self.requests.lock().unwrap_or_else(PoisonError::into_inner);
        let stats = requests
            .entry((method.to_owned(), route, status))
            .or_default();
        stats.count += 1;
        stats.seconds += seconds;
    }

    /// Writes the counts.
    pub(in crate::http) fn write(&self, text: &mut String) -> fmt::Result {
        let name = "seamster_http_request_seconds";
        writeln!(
            text,
            "# HELP {name} Time until the head of the answer was ready.\n# TYPE {name} summary"
        )?;
        let requests = self.requests.lock().unwrap_or_else(PoisonError::into_inner);
        for ((method, route, status), stats) in requests.iter() {
            let labels = format!("{{method=\"{method}\",route=\"{route}\",status=\"{status}\"}}");
            writeln!(
                text,
                "{name}_count{labels} {}\n{name}_sum{labels} {}",
                stats.count, stats.seconds
            )?;
        }
        Ok(())
    }
}
