//! Sews one garment without a server.

use super::output::{MeshOutput, write};
use super::{BAD_INPUT, FAILED, faults};
use clap::Args;
use seamster::config::Limits;
use seamster::fault::{Fault, Faults};
use seamster::fit::{self, Garment, Outcome, PatternAsked, Prepared, Shipped};
use seamster::job::thread_cpu_s;
use seamster::pattern::{self, ImportOptions, Pattern, RotationOrder, Units};
use seamster::progress::{CancelToken, Progress};
use seamster::solver::Context;
use serde::de::DeserializeOwned;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What to sew, and where to write it.
#[derive(Args)]
pub(super) struct SewAsked {
    /// The pattern (DXF or a GarmentCode specification), and the garment without its pattern; or a saved garment alone
    #[arg(required = true, num_args = 1..=2, value_names = ["PATTERN", "GARMENT.json"])]
    inputs: Vec<PathBuf>,
    /// Where to write the mesh; the name says the format: .glb, .obj or .json
    #[arg(short, long, value_name = "OUT.glb")]
    output: MeshOutput,
    /// Where to write the report
    #[arg(long, value_name = "R.json")]
    report: Option<PathBuf>,
    /// Where to write the assembled scene
    #[arg(long, value_name = "S.json")]
    scene: Option<PathBuf>,
    /// Unit of the pattern's coordinates, overriding what it says: mm, cm, m or inch
    #[arg(long, value_parser = word::<Units>)]
    units: Option<Units>,
    /// Size to sew of a graded pattern; its sample size if not given
    #[arg(long)]
    size: Option<String>,
    /// How the three angles of a GarmentCode panel make up its rotation: xyz (Rx Ry Rz, as it writes) or zyx
    #[arg(long, value_parser = word::<RotationOrder>)]
    rotation_order: Option<RotationOrder>,
}

fn word<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_value(text.into()).map_err(|error| error.to_string())
}

/// Why nothing was sewn: the file at fault, and its faults.
type Refused<'a> = (&'a Path, Faults);

/// Sews a garment, and says by the exit code what came of it.
pub(super) fn sew(asked: &SewAsked) -> ExitCode {
    let limits = Limits::default();
    let ran = prepared(asked, &limits).and_then(|prepared| {
        run(asked, &prepared, &limits).map_err(|faults| (asked.garment(), faults))
    });
    match ran {
        Ok(sewn) => written(asked, &sewn),
        Err((file, faults)) => {
            faults::tell(file, &faults);
            BAD_INPUT.into()
        }
    }
}

impl SewAsked {
    fn garment(&self) -> &Path {
        self.inputs.last().expect("clap asks for at least one")
    }

    fn pattern(&self) -> Option<&Path> {
        match self.inputs.as_slice() {
            [pattern, _] => Some(pattern),
            _ => None,
        }
    }
}

/// Reads both files and checks the garment whole.
fn prepared<'a>(asked: &'a SewAsked, limits: &Limits) -> Result<Prepared, Refused<'a>> {
    let file = asked.garment();
    let in_garment = |faults| (file, faults);
    let mut garment = read_garment(file, limits).map_err(in_garment)?;
    if let Some(file) = asked.pattern() {
        if garment.pattern.is_some() {
            let detail = "the pattern is given as a file and in the garment too";
            let fault = Fault::new("fit/two_patterns", "/pattern", detail);
            return Err(in_garment(fault.fix("leave it out of the garment").into()));
        }
        let pattern = read_pattern(file, asked, limits).map_err(|faults| (file, faults))?;
        faults::warn(file, &pattern.warnings);
        garment.pattern = Some(PatternAsked::Whole(Box::new(pattern)));
    }
    let prepared = fit::prepare(garment, &Shipped, limits).map_err(in_garment)?;
    faults::tell_suggested(file, prepared.suggested());
    faults::warn(file, prepared.warnings());
    Ok(prepared)
}

fn read_garment(file: &Path, limits: &Limits) -> Result<Garment, Faults> {
    let bytes = read(file, limits.json_bytes)?;
    fit::read_garment(&bytes).map_err(Faults::from)
}

fn read_pattern(file: &Path, asked: &SewAsked, limits: &Limits) -> Result<Pattern, Faults> {
    // The import knows what it is, and bounds each kind.
    let bytes = read(file, limits.dxf_bytes.max(limits.json_bytes))?;
    let name = file.file_stem().and_then(|name| name.to_str());
    let options = ImportOptions {
        name: name.map(str::to_owned),
        units: asked.units,
        size: asked.size.clone(),
        rotation_order: asked.rotation_order.unwrap_or_default(),
    };
    pattern::import(&bytes, &options, limits)
}

/// The bytes of a file, at most `limit`.
fn read(file: &Path, limit: usize) -> Result<Vec<u8>, Faults> {
    let cannot = |detail: String| Faults::from(Fault::new("file/unreadable", "", detail));
    let mut bytes = Vec::new();
    File::open(file)
        .and_then(|file| file.take(limit as u64 + 1).read_to_end(&mut bytes))
        .map_err(|error| cannot(error.to_string()))?;
    if bytes.len() > limit {
        return Err(cannot(format!("it has more than {limit} bytes")));
    }
    Ok(bytes)
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
fn teller() -> impl FnMut(Progress) {
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
