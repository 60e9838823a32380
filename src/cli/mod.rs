//! The command line.

mod child;
mod exit;
mod faults;
mod health;
mod import;
mod input;
mod output;
mod picture;
mod serve;
mod sew;
mod study;

use clap::{Parser, Subcommand};
use exit::{print, refuse};
use seamster::config::{Config, LogFormat, Logging};
use std::io::IsTerminal;
use std::process::ExitCode;
use tracing_subscriber::EnvFilter;

/// Sews garments without a screen: a pattern and its seams in, a garment draped on a body out.
#[derive(Parser)]
#[command(version)]
struct Cli {
    #[command(subcommand)]
    command: CliCommand,
    #[command(flatten)]
    logging: Logging,
}

#[derive(Subcommand)]
enum CliCommand {
    /// Serve over HTTP and run fits and studies
    Serve(Box<Config>),
    /// Run one job for `serve`, told on standard input
    #[command(hide = true)]
    RunJob,
    /// Run fits for a store that many processes share
    Worker,
    /// Read a pattern file: print its panels and what was decided, write its drawing or other files
    Import(Box<import::ImportCommand>),
    /// Sew one garment, without a server
    Sew(Box<sew::SewCommand>),
    /// Compare methods, settings and meshes on one garment: error against run time
    Study(Box<study::StudyCommand>),
    /// Ask the service on this machine whether it is ready
    Health(Box<Config>),
    /// Print the description of the service, openapi.json
    Openapi,
    /// Print the JSON Schema of garment files
    Schema,
}

/// Runs the command that the command line names.
pub(crate) fn run() -> ExitCode {
    let cli = Cli::parse();
    let filter = match cli.logging.log.parse::<EnvFilter>() {
        Ok(filter) => filter,
        Err(error) => return refuse(&format!("--log: {error}")),
    };
    let log = tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(std::io::stderr);
    match cli.logging.log_format {
        LogFormat::Text => log.with_ansi(std::io::stderr().is_terminal()).init(),
        LogFormat::Json => log.json().init(),
    }
    match cli.command {
        CliCommand::Serve(config) => serve::serve(*config),
        CliCommand::RunJob => child::run_job(),
        CliCommand::Worker => refuse(
            "the sqlite store is for one process: its workers run inside `seamster serve` (see --workers)",
        ),
        CliCommand::Import(command) => import::import(&command),
        CliCommand::Sew(command) => sew::sew(&command),
        CliCommand::Study(command) => study::study(&command),
        CliCommand::Health(config) => health::health(&config),
        CliCommand::Openapi => print(&seamster::http::openapi_json()),
        CliCommand::Schema => print(&seamster::fit::garment_schema_json()),
    }
}
