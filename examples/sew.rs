//! Sews the pattern of a DXF file round the default dress form and writes a GLB:
//! `cargo run --release --example sew -- skirt.dxf skirt.glb [skirt.garment.json]`.
//!
//! Without a garment file the seams are suggested from the outlines and the names of the panels.

use seamster::config::Limits;
use seamster::export::glb;
use seamster::fit::{self, Garment, ShippedAssets};
use seamster::pattern::{ImportOptions, import};
use seamster::progress::CancelToken;
use seamster::solver::Context;
use serde_json::{Value, json};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (dxf, out, garment) = match arguments.as_slice() {
        [dxf, out] => (dxf, out, json!({ "seams": "suggest" })),
        [dxf, out, file] => (dxf, out, serde_json::from_slice(&std::fs::read(file)?)?),
        _ => return Err("usage: sew PATTERN.dxf OUT.glb [GARMENT.json]".into()),
    };
    let limits = Limits::default();
    let pattern = import(&std::fs::read(dxf)?, &ImportOptions::default(), &limits)?;
    let garment = with_pattern(garment, serde_json::to_value(&pattern)?)?;

    // Every fault of the garment is found here, before anything is simulated.
    let resolved = fit::resolve(garment, &ShippedAssets, &limits)?;
    for seam in resolved.suggested() {
        println!("suggested: {}, {}", seam.pair.id, seam.because);
    }

    let start = Instant::now();
    let mut context = Context {
        cpu_s: &|| start.elapsed().as_secs_f64(),
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits: &limits,
    };
    let outcome = fit::run(&resolved, &mut context)?;
    let report = &outcome.report;
    println!(
        "{} vertices, converged: {}, residual {:.1e}, widest seam gap {:.2} mm",
        report.vertices,
        report.converged,
        report.residual,
        1e3 * report.seam_gap_max_m
    );
    std::fs::write(out, glb(&outcome.mesh))?;
    Ok(())
}

/// Puts a pattern into a garment file, whose other fields have defaults.
fn with_pattern(mut garment: Value, pattern: Value) -> serde_json::Result<Garment> {
    garment["pattern"] = pattern;
    serde_json::from_value(garment)
}
