//! Times whole fits of the shipped samples over mesh edge lengths, one JSON line a run:
//! `cargo run --release -p seamster-tools bench-samples`.
//!
//! A time says nothing without the error reached: every line has the residual and the error
//! estimate beside it.

use seamster::config::Limits;
use seamster::fit;
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster_fixtures::samples::{sample, with_context};
use serde_json::json;
use std::time::Instant;

/// Prints a line for each sample and length.
pub(crate) fn main() {
    for name in ["skirt", "top"] {
        for edge_length in [0.03, 0.02, 0.012] {
            let simulate = json!({"edge_length_m": edge_length});
            let prepared = sample(name, json!({ "simulate": simulate }));
            let (began, cpu_began) = (Instant::now(), thread_cpu_s());
            let run = with_context(
                &Limits::default(),
                &CancelToken::new(),
                |_| {},
                |context| fit::run(&prepared, context),
            );
            let report = run.expect("the shipped samples can be sewn").report;
            let line = json!({
                "scene": name,
                "method": report.method,
                "membrane": "continuum",
                "setting": simulate,
                "vertices": report.vertices,
                "cpu_s": thread_cpu_s() - cpu_began,
                "wall_s": began.elapsed().as_secs_f64(),
                "threads": 1,
                "residual": report.residual,
                "estimate_m": report.error_estimate_m,
                "gap_m": report.seam_gap_max_m,
                "penetration_m": report.penetration_max_m,
                "strain_max": report.strain_max,
                "memory_peak_bytes": report.memory_peak_bytes,
                "converged": report.converged,
            });
            println!("{line}");
        }
    }
}
