//! This program again, in a process of its own that is ended when it takes too long.

use std::io::{self, Read};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Output of a process that ended by itself.
pub(crate) struct ChildOutput {
    /// True if its exit code was 0.
    pub(crate) success: bool,
    /// Text that it printed, which is to be short enough for a pipe to hold (64 kB).
    pub(crate) text: String,
}

/// Runs this program with other arguments; none if it had to be ended.
///
/// # Errors
/// A process that cannot be started, or whose output is no text.
pub(crate) fn run(
    arguments: &[&str],
    allowed: Duration,
    stderr: Stdio,
) -> io::Result<Option<ChildOutput>> {
    let mut child = Command::new(std::env::current_exe()?)
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(stderr)
        .spawn()?;
    let Some(success) = wait(&mut child, allowed)? else {
        return Ok(None);
    };
    let mut text = String::new();
    if let Some(mut out) = child.stdout.take() {
        out.read_to_string(&mut text)?;
    }
    Ok(Some(ChildOutput { success, text }))
}

/// Returns true if the process ended well, `None` if it had to be ended.
fn wait(child: &mut Child, allowed: Duration) -> io::Result<Option<bool>> {
    let began = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status.success()));
        }
        if began.elapsed() > allowed {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(Duration::from_millis(5));
    }
}
