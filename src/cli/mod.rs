//! The command line. Exit codes: 0 done, 1 did not converge or failed, 2 bad input.

mod faults;
mod health;
mod input;
mod output;
mod serve;
mod sew;
mod study;

use clap::{Parser, Subcommand};
use seamster::config::{Config, Logging};
use std::io::{IsTerminal, Write};
use std::process::ExitCode;
use tracing_subscriber::EnvFilter;

/// It failed, or did not converge.
const FAILED: u8 = 1;
/// What was asked for cannot be done.
const BAD_INPUT: u8 = 2;

/// Sews garments without a screen: a pattern and its seams in, a garment draped on a body out.
#[derive(Parser)]
#[command(version)]
struct Program {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    logging: Logging,
}

#[derive(Subcommand)]
enum Command {
    /// Serve over HTTP and run fits and studies
    Serve(Box<Config>),
    /// Run fits for a store that many processes share
    Worker,
    /// Sew one garment, without a server
    Sew(Box<sew::SewAsked>),
    /// Compare methods, settings and meshes on one garment: error against run time
    Study(Box<study::StudyCommand>),
    /// Ask the service on this machine whether it is ready
    Health(Box<Config>),
    /// Print the description of the service, openapi.json
    Openapi,
    /// Print the JSON Schema of garment files
    Schema,
}

/// Does what the command line says.
pub(crate) fn run() -> ExitCode {
    let program = Program::parse();
    let filter = match program.logging.log.parse::<EnvFilter>() {
        Ok(filter) => filter,
        Err(error) => return refuse(&format!("--log: {error}")),
    };
    tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal())
        .init();
    match program.command {
        Command::Serve(config) => serve::serve(*config),
        Command::Worker => refuse(
            "the sqlite store is for one process: its workers run inside `seamster serve` (see --workers)",
        ),
        Command::Sew(asked) => sew::sew(&asked),
        Command::Study(asked) => study::study(&asked),
        Command::Health(config) => health::health(&config),
        Command::Openapi => print(&seamster::http::openapi_json()),
        Command::Schema => print(&seamster::fit::garment_schema_json()),
    }
}

/// Says why what was asked for cannot be done.
fn refuse(reason: &str) -> ExitCode {
    eprintln!("seamster: {reason}");
    BAD_INPUT.into()
}

/// Says why it failed.
fn fail(reason: &str) -> ExitCode {
    eprintln!("seamster: {reason}");
    FAILED.into()
}

fn print(text: &str) -> ExitCode {
    match writeln!(std::io::stdout(), "{}", text.trim_end()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string()),
    }
}
