//! One run and how far it stopped from rest.

use super::garment::Kind;
use seamster::config::Limits;
use seamster::fit;
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::{self, Context, SolverOptions, rms_distance};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Residual asked of the reference: below any floor, which then is what stops it.
const TO_THE_FLOOR: f64 = 1e-300;
/// A distance between coordinates of about 1 m that is rounding \[m\].
const ROUNDING: f64 = 1e-15;

/// Outcome of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct AccuracyLine {
    pub(crate) garment: String,
    pub(crate) vertices: usize,
    pub(crate) tolerance: f64,
    pub(crate) time_limit_s: Option<f64>,
    /// Of the whole fit, from the pattern to the report.
    pub(crate) cpu_s: f64,
    pub(crate) expected_cpu_s: Option<f64>,
    pub(crate) levels: Vec<usize>,
    pub(crate) residual: f64,
    pub(crate) estimate_m: Option<f64>,
    pub(crate) valid: bool,
    pub(crate) mesh_error_m: Option<f64>,
    /// Distance that it moved on to rest.
    pub(crate) error_m: f64,
    /// Residual of the reference over the round-off floor.
    pub(crate) reference_floors: f64,
    /// True if the reference came to rest.
    pub(crate) referred: bool,
}

impl AccuracyLine {
    pub(crate) fn same_run(&self, other: &Self) -> bool {
        (
            &self.garment,
            self.vertices,
            self.tolerance,
            self.time_limit_s,
        ) == (
            &other.garment,
            other.vertices,
            other.tolerance,
            other.time_limit_s,
        )
    }

    /// The error that was stated over the true one; none where the shape was at the floor already.
    pub(crate) fn ratio(&self) -> Option<f64> {
        let told = self.error_m > ROUNDING;
        self.estimate_m
            .filter(|_| told)
            .map(|estimate| estimate / self.error_m)
    }
}

/// Sews and drapes, and then drapes on from where it stopped to the floor.
pub(crate) fn measured(
    kind: &Kind,
    folder: &Path,
    edge_length: f64,
    tolerance: f64,
    time_limit: Option<f64>,
) -> AccuracyLine {
    let prepared = kind.prepared(folder, edge_length);
    let began = thread_cpu_s();
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    let scene = fit::scene(&prepared, &context).expect("the mesh is within the limits");
    let assembled = (context.cpu_s)();
    let options = SolverOptions {
        tolerance,
        time_limit_s: time_limit.map(|limit| limit - assembled),
        ..prepared.garment().simulate.clone()
    };
    let drape = solver::drape(&scene, &options, &mut context);
    let cpu_s = (context.cpu_s)();
    let on = SolverOptions {
        tolerance: TO_THE_FLOOR,
        time_limit_s: None,
        ..options
    };
    let reference = solver::drape_on(&scene, &on, &drape, &mut context);
    let (report, end) = (drape.report, reference.report);
    AccuracyLine {
        garment: kind.name.to_owned(),
        vertices: report.vertices,
        tolerance,
        time_limit_s: time_limit,
        cpu_s,
        expected_cpu_s: report.plan.expected_cpu_s.map(|s| s + assembled),
        levels: report.levels.iter().map(|level| level.vertices).collect(),
        residual: report.residual,
        estimate_m: report.error_estimate_m,
        valid: report.error_estimate_valid,
        mesh_error_m: report.mesh_error_m,
        error_m: rms_distance(&drape.positions, &reference.positions),
        reference_floors: end.residual / end.residual_floor,
        referred: end.converged,
    }
}
