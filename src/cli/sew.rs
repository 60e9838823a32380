//! Sews one garment without a server.

use super::input::{Input, Refused};
use super::output::{MeshOutput, write};
use super::{BAD_INPUT, FAILED, faults};
use clap::Args;
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::{self, Outcome, Prepared, Shipped};
use seamster::job::thread_cpu_s;
use seamster::progress::{CancelToken, Progress};
use seamster::solver::Context;
use std::path::PathBuf;
use std::process::ExitCode;

/// What to sew, and where to write it.
#[derive(Args)]
pub(super) struct SewAsked {
    #[command(flatten)]
    input: Input,
    /// Where to write the mesh; the name says the format: .glb, .obj or .json
    #[arg(short, long, value_name = "OUT.glb")]
    output: MeshOutput,
    /// Where to write the report
    #[arg(long, value_name = "R.json")]
    report: Option<PathBuf>,
    /// Where to write the assembled scene
    #[arg(long, value_name = "S.json")]
    scene: Option<PathBuf>,
}

/// Sews a garment, and says by the exit code what came of it.
pub(super) fn sew(asked: &SewAsked) -> ExitCode {
    let limits = Limits::default();
    let ran = prepared(asked, &limits).and_then(|prepared| {
        run(asked, &prepared, &limits).map_err(|faults| (asked.input.file(), faults))
    });
    match ran {
        Ok(sewn) => written(asked, &sewn),
        Err((file, faults)) => {
            faults::tell(file, &faults);
            BAD_INPUT.into()
        }
    }
}

/// Reads both files and checks the garment whole.
fn prepared<'a>(asked: &'a SewAsked, limits: &Limits) -> Result<Prepared, Refused<'a>> {
    let file = asked.input.file();
    let garment = asked.input.garment(limits)?;
    let prepared = fit::prepare(garment, &Shipped, limits).map_err(|faults| (file, faults))?;
    faults::tell_suggested(file, prepared.suggested());
    faults::warn(file, prepared.warnings());
    Ok(prepared)
}

/// What came of it, and the scene where it is asked for.
struct Sewn {
    outcome: Outcome,
    scene: Option<Vec<u8>>,
}

fn run(asked: &SewAsked, prepared: &Prepared, limits: &Limits) -> Result<Sewn, Faults> {
    let began = thread_cpu_s();
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &CancelToken::new(),
        progress: &mut teller(),
        limits,
    };
    let outcome = fit::run(prepared, &mut context)?;
    let scene = asked.scene.is_some();
    let scene = scene.then(|| fit::scene_json(prepared, &context));
    Ok(Sewn {
        outcome,
        scene: scene.transpose()?,
    })
}

/// Logs each stage as it begins.
pub(super) fn teller() -> impl FnMut(Progress) {
    let mut stage = String::new();
    move |progress| {
        if progress.stage != stage {
            tracing::info!(cpu_s = progress.cpu_s, "{}", progress.stage);
            stage = progress.stage;
        }
    }
}

fn written(asked: &SewAsked, sewn: &Sewn) -> ExitCode {
    if let Err(error) = write_all(asked, sewn) {
        return super::fail(&error);
    }
    let report = &sewn.outcome.report;
    if !report.converged {
        eprintln!("seamster: it did not converge: {}", report.why);
        return FAILED.into();
    }
    ExitCode::SUCCESS
}

fn write_all(asked: &SewAsked, Sewn { outcome, scene }: &Sewn) -> Result<(), String> {
    asked.output.write(&outcome.mesh)?;
    if let Some(path) = &asked.report {
        let json = serde_json::to_vec_pretty(&outcome.report).map_err(|error| error.to_string())?;
        write(path, &json)?;
    }
    if let (Some(path), Some(json)) = (&asked.scene, scene) {
        write(path, json)?;
    }
    Ok(())
}
