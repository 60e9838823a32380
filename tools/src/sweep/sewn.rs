//! One garment sewn in this process.

use super::garment::SweepGarment;
use super::line::{NEAR, SweepLine};
use super::options::SweepOptions;
use seamster::config::Limits;
use seamster::fit::{self, FitOutcome, ResolvedGarment, SelfContact, ShippedAssets};
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::{Context, ErrorPoint};
use serde_json::json;
use std::error::Error;
use std::fs;
use std::path::Path;

/// Sews a garment at the first of the edge lengths, and draws it into a folder.
pub(super) fn sew(
    garment: &SweepGarment,
    folder: &Path,
    options: &SweepOptions,
    pictures: &Path,
) -> SweepLine {
    let line = options.line(garment, options.edge_lengths[0]);
    let sewn = run(garment, folder, options).and_then(|(resolved, outcome)| {
        draw(
            &resolved,
            &outcome,
            &pictures.join(format!("{}.png", garment.name)),
        )?;
        Ok(outcome)
    });
    match sewn {
        Ok(outcome) => measured(line, &outcome),
        Err(error) => SweepLine {
            error: Some(error.to_string()),
            ..line
        },
    }
}

fn run(
    garment: &SweepGarment,
    folder: &Path,
    options: &SweepOptions,
) -> Result<(ResolvedGarment, FitOutcome), Box<dyn Error>> {
    let limits = Limits::default();
    let mut garment = garment.garment(folder, &options.form)?;
    garment.simulate.edge_length_m = options.edge_lengths[0];
    if options.no_self_contact {
        garment.self_contact = SelfContact::Off;
    }
    garment.simulate.time_limit_s = Some(options.time_limit);
    let resolved = fit::resolve(garment, &ShippedAssets, &limits)?;
    let began = thread_cpu_s();
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits: &limits,
    };
    let outcome = fit::run(&resolved, &mut context)?;
    Ok((resolved, outcome))
}

fn draw(
    garment: &ResolvedGarment,
    outcome: &FitOutcome,
    file: &Path,
) -> Result<(), Box<dyn Error>> {
    let shape = (&outcome.mesh, &outcome.report);
    let sheet = fit::picture(garment, shape, (None, None), &Limits::default())?;
    Ok(fs::write(file, sheet.png())?)
}

fn measured(line: SweepLine, outcome: &FitOutcome) -> SweepLine {
    let report = outcome.report.clone();
    let good = report.good.unwrap_or_default();
    let word = |fault| json!(fault).as_str().map(str::to_owned);
    SweepLine {
        vertices: report.vertices,
        converged: report.converged,
        good: good.ok,
        failed: good.failed.into_iter().filter_map(word).collect(),
        because: good.because,
        residual: report.residual,
        seam_gap_m: report.seam_gap_max_m,
        penetration_m: report.penetration_max_m,
        crossings: report.self_intersections,
        degenerate_triangles: report.degenerate_triangles,
        body_crossings: report.body_intersections,
        vertices_inside: report.vertices_inside_body,
        strain_max: report.strain_max,
        worn: report.support.ok == Some(true),
        worn_because: report.support.because,
        newton_iterations: report.newton_iterations,
        error_estimate_m: report
            .error_estimate_m
            .filter(|_| report.error_estimate_valid),
        mesh_error_m: report.mesh_error_m,
        near_cpu_s: near_cpu_s(&report.error_against_run_time).filter(|_| report.converged),
        why: report.why,
        cpu_s: report.cpu_s.total,
        memory_bytes: report.memory_peak_bytes,
        ..line
    }
}

/// Returns the first of the times from which on the shape stayed near the last one \[CPU s\].
fn near_cpu_s(points: &[ErrorPoint]) -> Option<f64> {
    let is_near = |point: &&ErrorPoint| point.rms_error_m <= NEAR;
    let near = points.iter().rev().take_while(is_near);
    near.last().map(|point| point.cpu_s)
}
