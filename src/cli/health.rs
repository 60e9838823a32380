//! Asks the service on this machine whether it is ready: the probe of a container.

use super::exit::fail;
use seamster::config::Config;
use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::ExitCode;
use std::time::Duration;

/// Time limit of each step of the probe.
const TIMEOUT: Duration = Duration::from_secs(3);

/// Succeeds if the service answers that it is ready.
pub(super) fn health(config: &Config) -> ExitCode {
    let address = config.local_address();
    match probe(address) {
        Ok(answer) if answer.starts_with("HTTP/1.1 200") => ExitCode::SUCCESS,
        Ok(answer) => fail(&format!(
            "{address} answers: {}",
            answer.lines().next().unwrap_or("nothing")
        )),
        Err(error) => fail(&format!("{address}: {error}")),
    }
}

/// Sends the probe, and returns the beginning of the answer.
fn probe(address: SocketAddr) -> io::Result<String> {
    let mut stream = TcpStream::connect_timeout(&address, TIMEOUT)?;
    stream.set_read_timeout(Some(TIMEOUT))?;
    stream.set_write_timeout(Some(TIMEOUT))?;
    let port = address.port();
    // By a loopback name, which the service always knows itself by.
    write!(
        stream,
        "GET /health/ready HTTP/1.1\r\nHost: localhost:{port}\r\nConnection: close\r\n\r\n"
    )?;
    let mut answer = Vec::new();
    stream.take(4096).read_to_end(&mut answer)?;
    Ok(String::from_utf8_lossy(&answer).into_owned())
}
