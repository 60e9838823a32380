//! The command `sew`: sews one garment without a server.

use super::exit::{BAD_INPUT, FAILED, fail};
use super::faults;
use super::input::{FileFaults, Input};
use super::output::{MeshOutput, write};
use super::picture::PictureOptions;
use clap::Args;
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::{self, FitOutcome, ResolvedGarment, ShippedAssets};
use seamster::job::thread_cpu_s;
use seamster::progress::{CancelToken, Progress};
use seamster::solver::Context;
use std::path::PathBuf;
use std::process::ExitCode;

/// Arguments of `sew`: the garment, and the files to write.
#[derive(Args)]
pub(super) struct SewCommand {
    #[command(flatten)]
    input: Input,
    /// File to write the mesh to; its name gives the format: .glb, .obj or .json
    #[arg(short, long, value_name = "OUT.glb")]
    output: MeshOutput,
    /// File to write the report to
    #[arg(long, value_name = "R.json")]
    report: Option<PathBuf>,
    /// File to write the assembled scene to
    #[arg(long, value_name = "S.json")]
    scene: Option<PathBuf>,
    #[command(flatten)]
    picture: PictureOptions,
}

/// Sews a garment; the exit code tells whether it came to rest and is good.
pub(super) fn sew(command: &SewCommand) -> ExitCode {
    let limits = Limits::default();
    let ran = resolve(command, &limits).and_then(|resolved| {
        run(command, &resolved, &limits).map_err(|faults| (command.input.file(), faults))
    });
    match ran {
        Ok(sewn) => write_output(command, &sewn),
        Err((file, faults)) => {
            faults::print_faults(file, &faults);
            BAD_INPUT.into()
        }
    }
}

/// Reads both files and checks the garment whole.
fn resolve<'a>(
    command: &'a SewCommand,
    limits: &Limits,
) -> Result<ResolvedGarment, FileFaults<'a>> {
    let file = command.input.file();
    let garment = command.input.garment(limits)?;
    let resolved =
        fit::resolve(garment, &ShippedAssets, limits).map_err(|faults| (file, faults))?;
    faults::print_suggested(file, resolved.suggested());
    faults::print_warnings(file, resolved.warnings());
    Ok(resolved)
}

/// An outcome, and the scene and the picture where they are requested.
struct SewOutput {
    outcome: FitOutcome,
    scene: Option<Vec<u8>>,
    picture: Option<Vec<u8>>,
}

fn run(
    command: &SewCommand,
    resolved: &ResolvedGarment,
    limits: &Limits,
) -> Result<SewOutput, Faults> {
    let began = thread_cpu_s();
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &CancelToken::new(),
        progress: &mut stage_logger(),
        limits,
    };
    let outcome = fit::run(resolved, &mut context)?;
    let scene = command.scene.is_some();
    let scene = scene.then(|| fit::scene_json(resolved, &context));
    Ok(SewOutput {
        scene: scene.transpose()?,
        picture: command.picture.draw(resolved, &outcome, limits)?,
        outcome,
    })
}

/// Returns a progress callback that logs each stage as it begins.
pub(super) fn stage_logger() -> impl FnMut(Progress) {
    let mut stage = String::new();
    move |progress| {
        if progress.stage != stage {
            tracing::info!(cpu_s = progress.cpu_s, "{}", progress.stage);
            stage = progress.stage;
        }
    }
}

fn write_output(command: &SewCommand, sewn: &SewOutput) -> ExitCode {
    if let Err(error) = write_all(command, sewn) {
        return fail(&error);
    }
    let report = &sewn.outcome.report;
    if !report.converged {
        eprintln!("seamster: it did not converge: {}", report.why);
        return FAILED.into();
    }
    let faults = report.good.iter().flat_map(|good| &good.because);
    let mut exit = ExitCode::SUCCESS;
    for fault in faults {
        eprintln!("seamster: it is at rest, but {fault}");
        exit = FAILED.into();
    }
    exit
}

fn write_all(command: &SewCommand, sewn: &SewOutput) -> Result<(), String> {
    let outcome = &sewn.outcome;
    command.output.write(&outcome.mesh)?;
    if let Some(path) = &command.report {
        let json = serde_json::to_vec_pretty(&outcome.report).map_err(|error| error.to_string())?;
        write(path, &json)?;
    }
    if let (Some(path), Some(json)) = (&command.scene, &sewn.scene) {
        write(path, json)?;
    }
    match &sewn.picture {
        Some(png) => command.picture.write(png),
        None => Ok(()),
    }
}
