//! The command `study`: studies one garment without a server.

use super::exit::{BAD_INPUT, FAILED, fail, print};
use super::faults;
use super::input::{FileFaults, Input, parse_word};
use super::output::write;
use super::sew::stage_logger;
use clap::Args;
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::ShippedAssets;
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::{Context, Method};
use seamster::study::{self, ResolvedStudy, Study, StudyRequest};
use std::path::PathBuf;
use std::process::ExitCode;

/// Arguments of `study`: the garment, the methods and settings, and the files to write.
#[derive(Args)]
pub(super) struct StudyCommand {
    #[command(flatten)]
    input: Input,
    /// File to write the study to
    #[arg(short, long, value_name = "OUT.json")]
    output: PathBuf,
    /// File to write the plot of error against run time to
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,
    /// Methods, as in the garment's `simulate.method`, with commas between them
    #[arg(long, value_delimiter = ',', value_parser = parse_word::<Method>)]
    methods: Vec<Method>,
    /// Tolerances, as in the garment's `simulate.tolerance`
    #[arg(long, value_delimiter = ',')]
    tolerances: Vec<f64>,
    /// Fixed steps of a motion [s]
    #[arg(long, value_delimiter = ',')]
    steps: Vec<f64>,
    /// Lengths of mesh edges [m]; the garment's if not given
    #[arg(long, value_delimiter = ',')]
    edge_lengths: Vec<f64>,
    /// CPU time of the whole study [s]
    #[arg(long)]
    time_limit: Option<f64>,
}

/// Studies a garment; the exit code tells whether every run was made.
pub(super) fn study(command: &StudyCommand) -> ExitCode {
    let limits = Limits::default();
    match make_study(command, &limits) {
        Ok(study) => write_output(command, &study),
        Err((file, faults)) => {
            faults::print_faults(file, &faults);
            BAD_INPUT.into()
        }
    }
}

fn make_study<'a>(command: &'a StudyCommand, limits: &Limits) -> Result<Study, FileFaults<'a>> {
    let file = command.input.file();
    let request = StudyRequest {
        garment: command.input.garment(limits)?,
        methods: command.methods.clone(),
        tolerances: command.tolerances.clone(),
        steps_s: command.steps.clone(),
        edge_lengths_m: command.edge_lengths.clone(),
        time_limit_s: command.time_limit,
    };
    let resolved =
        study::resolve(request, &ShippedAssets, limits).map_err(|faults| (file, faults))?;
    faults::print_suggested(file, resolved.suggested());
    faults::print_warnings(file, resolved.warnings());
    run(&resolved, limits).map_err(|faults| (file, faults))
}

fn run(resolved: &ResolvedStudy, limits: &Limits) -> Result<Study, Faults> {
    let began = thread_cpu_s();
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &CancelToken::new(),
        progress: &mut stage_logger(),
        limits,
    };
    study::run(resolved, &mut context)
}

fn write_output(command: &StudyCommand, study: &Study) -> ExitCode {
    if let Err(error) = write_all(command, study) {
        return fail(&error);
    }
    let printed = print(&study.recommendation);
    if study.complete {
        return printed;
    }
    for left_out in &study.left_out {
        let (what, because) = (&left_out.what, &left_out.because);
        eprintln!("seamster: left out: {what}: {because}");
    }
    FAILED.into()
}

fn write_all(command: &StudyCommand, study: &Study) -> Result<(), String> {
    let json = serde_json::to_vec_pretty(study).map_err(|error| error.to_string())?;
    write(&command.output, &json)?;
    match &command.plot {
        Some(path) => write(path, study::plot_svg(study).as_bytes()),
        None => Ok(()),
    }
}
