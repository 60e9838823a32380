//! The shipped samples, prepared for a fit.

#![allow(
    dead_code,
    reason = "each test program takes what it needs of these builders"
)]
#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use seamster::config::Limits;
use seamster::fit::{Garment, PatternAsked, Prepared, Shipped, prepare};
use seamster::pattern::{ImportOptions, import};
use seamster::progress::{CancelToken, Progress};
use seamster::solver::Context;
use serde_json::Value;

/// The sample `name` with the fields of `changes` put over those of its garment file, ready for a fit.
pub(crate) fn sample(name: &str, changes: Value) -> Prepared {
    prepare(garment(name, changes), &Shipped, &Limits::default()).unwrap()
}

/// The same, whole but not checked.
pub(crate) fn garment(name: &str, changes: Value) -> Garment {
    let folder = format!("{}/static/samples", env!("CARGO_MANIFEST_DIR"));
    let dxf = std::fs::read(format!("{folder}/{name}.dxf")).unwrap();
    let text = std::fs::read_to_string(format!("{folder}/{name}.garment.json")).unwrap();
    let mut garment: Value = serde_json::from_str(&text).unwrap();
    for (key, value) in changes.as_object().unwrap() {
        garment[key] = value.clone();
    }
    let mut garment: Garment = serde_json::from_value(garment).unwrap();
    let pattern = import(&dxf, &ImportOptions::default(), &Limits::default()).unwrap();
    garment.pattern = Some(PatternAsked::Whole(Box::new(pattern)));
    garment
}

/// Calls `run` with a context of its own.
pub(crate) fn with_context<T>(
    limits: &Limits,
    cancel: &CancelToken,
    mut told: impl FnMut(Progress),
    run: impl FnOnce(&mut Context<'_>) -> T,
) -> T {
    let began = std::time::Instant::now();
    let mut context = Context {
        cpu_s: &|| began.elapsed().as_secs_f64(),
        cancel,
        progress: &mut told,
        limits,
    };
    run(&mut context)
}
