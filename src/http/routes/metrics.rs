//! `/metrics`: counters in the Prometheus text format.

use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::{JobCounts, JobKind, JobStatus};
use axum::extract::State;
use axum::http::header;
use axum::response::IntoResponse;
use std::fmt::{self, Write};

fn write_jobs(text: &mut String, kind: JobKind, counts: &JobCounts) -> fmt::Result {
    let (name, help) = match kind {
        JobKind::Fit => ("seamster_fits", "Fits by status."),
        JobKind::Study => ("seamster_studies", "Studies by status."),
    };
    writeln!(text, "# HELP {name} {help}\n# TYPE {name} gauge")?;
    for status in JobStatus::ALL {
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
pub(super) async fn metrics(State(state): State<AppState>) -> Result<impl IntoResponse, Problem> {
    let mut text = String::new();
    for kind in JobKind::ALL {
        let counts = state
            .run_blocking(move |app| app.queue.counts(kind))
            .await??;
        write_jobs(&mut text, kind, &counts).map_err(Problem::internal)?;
    }
    write_version(&mut text).map_err(Problem::internal)?;
    state.metrics.write(&mut text).map_err(Problem::internal)?;
    let kind = "text/plain; version=0.0.4; charset=utf-8";
    Ok(([(header::CONTENT_TYPE, kind)], text))
}
