//! Exit codes and what is printed with them: 0 done, 1 did not converge, is not good or
//! failed, 2 bad input.

use std::io::Write;
use std::process::ExitCode;

/// Exit code of a command that failed, did not converge or is not good.
pub(super) const FAILED: u8 = 1;
/// Exit code of a command whose input cannot be used.
pub(super) const BAD_INPUT: u8 = 2;

/// Prints why the input cannot be used.
pub(super) fn refuse(reason: &str) -> ExitCode {
    eprintln!("seamster: {reason}");
    BAD_INPUT.into()
}

/// Prints why the command failed.
pub(super) fn fail(reason: &str) -> ExitCode {
    eprintln!("seamster: {reason}");
    FAILED.into()
}

/// Prints a text to stdout.
pub(super) fn print(text: &str) -> ExitCode {
    match writeln!(std::io::stdout(), "{}", text.trim_end()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string()),
    }
}
