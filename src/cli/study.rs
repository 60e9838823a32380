//! Studies one garment without a server.

use super::input::{Input, Refused, word};
use super::output::write;
use super::sew::teller;
use super::{BAD_INPUT, FAILED, faults};
use clap::Args;
use seamster::config::Limits;
use seamster::fit::Shipped;
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::{Context, Method};
use seamster::study::{self, PreparedStudy, Study, StudyAsked};
use std::path::PathBuf;
use std::process::ExitCode;

/// What to study, and where to write it.
#[derive(Args)]
pub(super) struct StudyCommand {
    #[command(flatten)]
    input: Input,
    /// Where to write the study
    #[arg(short, long, value_name = "OUT.json")]
    output: PathBuf,
    /// Where to write the plot of error against run time
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,
    /// Methods, as in the garment's `simulate.method`, with commas between them
    #[arg(long, value_delimiter = ',', value_parser = word::<Method>)]
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

/// Studies a garment, and says by the exit code whether all of it was done.
pub(super) fn study(asked: &StudyCommand) -> ExitCode {
    let limits = Limits::default();
    match made(asked, &limits) {
        Ok(study) => written(asked, &study),
        Err((file, faults)) => {
            faults::tell(file, &faults);
            BAD_INPUT.into()
        }
    }
}

fn made<'a>(asked: &'a StudyCommand, limits: &Limits) -> Result<Study, Refused<'a>> {
    let file = asked.input.file();
    let whole = StudyAsked {
        garment: asked.input.garment(limits)?,
        methods: asked.methods.clone(),
        tolerances: asked.tolerances.clone(),
        steps_s: asked.steps.clone(),
        edge_lengths_m: asked.edge_lengths.clone(),
        time_limit_s: asked.time_limit,
    };
    let prepared = study::prepare(whole, &Shipped, limits).map_err(|faults| (file, faults))?;
    faults::tell_suggested(file, prepared.suggested());
    faults::warn(file, prepared.warnings());
    run(&prepared, limits).map_err(|faults| (file, faults))
}

fn run(prepared: &PreparedStudy, limits: &Limits) -> Result<Study, seamster::fault::Faults> {
    let began = thread_cpu_s();
    let mut context = Context {
        cpu_s: &|| thread_cpu_s() - began,
        cancel: &CancelToken::new(),
        progress: &mut teller(),
        limits,
    };
    study::run(prepared, &mut context)
}

fn written(asked: &StudyCommand, study: &Study) -> ExitCode {
    if let Err(error) = write_all(asked, study) {
        return super::fail(&error);
    }
    let said = super::print(&study.recommendation);
    if study.complete {
        return said;
    }
    for left_out in &study.left_out {
        let (what, because) = (&left_out.what, &left_out.because);
        eprintln!("seamster: left out: {what}: {because}");
    }
    FAILED.into()
}

fn write_all(asked: &StudyCommand, study: &Study) -> Result<(), String> {
    let json = serde_json::to_vec_pretty(study).map_err(|error| error.to_string())?;
    write(&asked.output, &json)?;
    match &asked.plot {
        Some(path) => write(path, study::plot_svg(study).as_bytes()),
        None => Ok(()),
    }
}
