//! Counters in the Prometheus text format.

use super::problem::Problem;
use super::state::App;
use crate::job::{Counts, JobKind, Status};
use axum::Router;
use axum::extract::State;
use axum::http::{Method, header};
use axum::response::IntoResponse;
use axum::routing::get;
use std::collections::BTreeMap;
use std::fmt::{self, Write};
use std::sync::{Mutex, PoisonError};

pub(super) fn router() -> Router<App> {
    Router::new().route("/metrics", get(metrics))
}

/// Requests answered, by method, route and status. Routes are those of the router, never paths: labels stay few.
#[derive(Debug, Default)]
pub(super) struct Metrics {
    // A std mutex: held for one addition, never over an await.
    requests: Mutex<BTreeMap<(String, String, u16), Served>>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Served {
    count: u64,
    seconds: f64,
}

impl Metrics {
    /// Counts one request.
    pub(super) fn add(&self, method: &Method, route: String, status: u16, seconds: f64) {
        let method = match method.as_str() {
            known @ ("GET" | "HEAD" | "POST" | "DELETE") => known,
            _ => "other",
        };
        let mut requests = self.requests.lock().unwrap_or_else(PoisonError::into_inner);
        let served = requests
            .entry((method.to_owned(), route, status))
            .or_default();
        served.count += 1;
        served.seconds += seconds;
    }

    fn write(&self, text: &mut String) -> fmt::Result {
        let name = "seamster_http_request_seconds";
        writeln!(
            text,
            "# HELP {name} Time until the head of the answer was ready.\n# TYPE {name} summary"
        )?;
        let requests = self.requests.lock().unwrap_or_else(PoisonError::into_inner);
        for ((method, route, status), served) in requests.iter() {
            let labels = format!("{{method=\"{method}\",route=\"{route}\",status=\"{status}\"}}");
            writeln!(
                text,
                "{name}_count{labels} {}\n{name}_sum{labels} {}",
                served.count, served.seconds
            )?;
        }
        Ok(())
    }
}

fn write_jobs(text: &mut String, kind: JobKind, counts: &Counts) -> fmt::Result {
    let (name, help) = match kind {
        JobKind::Fit => ("seamster_fits", "Fits by status."),
        JobKind::Study => ("seamster_studies", "Studies by status."),
    };
    writeln!(text, "# HELP {name} {help}\n# TYPE {name} gauge")?;
    for status in Status::ALL {
        let word = status.as_str();
        writeln!(text, "{name}{{status=\"{word}\"}} {}", counts.of(status))?;
    }
    Ok(())
}

fn write_version(text: &mut String) -> fmt::Result {
    let (name, version) = ("seamster_build_info", env!("CARGO_PKG_VERSION"));
    writeln!(
        text,
        "# HELP {name} The running version.\n# TYPE {name} gauge\n{name}{{version=\"{version}\"}} 1"
    )
}

/// Counters in the Prometheus text format
#[utoipa::path(get, path = "/metrics", tag = "service", responses(
    (status = 200, description = "The counters", content_type = "text/plain", body = String)))]
pub(super) async fn metrics(State(app): State<App>) -> Result<impl IntoResponse, Problem> {
    let mut text = String::new();
    for kind in JobKind::ALL {
        let counts = app.blocking(move |app| app.queue.counts(kind)).await??;
        write_jobs(&mut text, kind, &counts).map_err(Problem::internal)?;
    }
    write_version(&mut text).map_err(Problem::internal)?;
    app.metrics.write(&mut text).map_err(Problem::internal)?;
    let kind = "text/plain; version=0.0.4; charset=utf-8";
    Ok(([(header::CONTENT_TYPE, kind)], text))
}
