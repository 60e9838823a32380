//! The program started as a process: its commands and its service.

#![expect(
    clippy::unwrap_used,
    reason = "a failure is a failed test, in its helpers too"
)]

use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Far above what any of this takes on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(240);

/// The program with these arguments, and without settings from the environment.
pub(crate) fn seamster(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seamster"));
    command.args(arguments);
    for name in [
        "LISTEN",
        "DATA",
        "STORE",
        "BLOBS",
        "WORKERS",
        "TOKENS",
        "HOSTS",
        "LOG",
        "LOG_FORMAT",
    ] {
        command.env_remove(format!("SEAMSTER_{name}"));
    }
    command
}

/// Runs the program to its end.
pub(crate) fn run(arguments: &[&str]) -> Output {
    seamster(arguments).output().unwrap()
}

/// Exit code of a program that ended by itself.
pub(crate) fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

/// Text that a program wrote to its standard error.
pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Path of a shipped sample.
pub(crate) fn sample(file: &str) -> String {
    format!("{}/static/samples/{file}", env!("CARGO_MANIFEST_DIR"))
}

/// The sample skirt's garment, sewn coarsely and from a fabric of its own: what is tested here is
/// not the shape.
pub(crate) fn garment() -> Value {
    let text = std::fs::read_to_string(sample("skirt.garment.json")).unwrap();
    let mut garment: Value = serde_json::from_str(&text).unwrap();
    garment["simulate"] = json!({"edge_length_m": 0.04, "tolerance": 1e-4});
    garment["default_fabric"] = json!("own");
    garment["panels"] = without_fabrics(&garment["panels"]);
    garment["fabrics"] = json!({"own": {
        "name": "own", "density_kg_m2": 0.12, "thickness_m": 0.0003,
        "stretch_warp_n_m": 2000.0, "stretch_weft_n_m": 2000.0, "shear_n_m": 60.0,
        "bending_warp_n_m": 8e-6, "bending_weft_n_m": 5e-6,
        "friction": 0.3, "damping_ratio": 0.1, "source": "made up for this test",
    }});
    garment
}

fn without_fabrics(panels: &Value) -> Value {
    let mut panels = panels.as_object().cloned().unwrap_or_default();
    for panel in panels.values_mut().filter_map(Value::as_object_mut) {
        panel.remove("fabric");
    }
    panels.into()
}

/// A running service, killed when dropped.
pub(crate) struct Service {
    child: Child,
    /// Host and port that it listens on.
    pub(crate) address: String,
    agent: ureq::Agent,
}

impl Service {
    /// Starts a service with one worker on a free port, and waits until it listens.
    pub(crate) fn start(data: &Path) -> Self {
        let data = data.to_str().unwrap();
        let mut child = seamster(&[
            "serve",
            "--listen",
            "127.0.0.1:0",
            "--data",
            data,
            "--workers",
            "1",
        ])
        .env("SEAMSTER_LOG", "info")
        .stdin(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
        let address = listening_address(child.stderr.take().unwrap());
        let agent = ureq::Agent::config_builder()
            .timeout_global(Some(TIMEOUT))
            .build();
        Self {
            child,
            address,
            agent: agent.into(),
        }
    }

    /// Body of the answer to a GET.
    pub(crate) fn get(&self, path: &str) -> Value {
        let url = format!("http://{}{path}", self.address);
        let mut answer = self.agent.get(&url).call().unwrap();
        answer.body_mut().read_json().unwrap()
    }

    /// Body of the answer to a POST of `kind`.
    pub(crate) fn post(&self, path: &str, body: &[u8], kind: &str) -> Value {
        let url = format!("http://{}{path}", self.address);
        let request = self.agent.post(&url).header("content-type", kind);
        let mut answer = request.send(body).unwrap();
        answer.body_mut().read_json().unwrap()
    }

    /// Submits the sample skirt and returns where its fit is.
    pub(crate) fn submit(&self) -> String {
        let dxf = std::fs::read(sample("skirt.dxf")).unwrap();
        let pattern = self.post("/v1/patterns", &dxf, "application/dxf");
        let mut garment = garment();
        garment["pattern"] = pattern["id"].clone();
        let body = garment.to_string();
        let fit = self.post("/v1/fits", body.as_bytes(), "application/json");
        format!("/v1/fits/{}", fit["id"].as_str().unwrap())
    }

    /// Record of a job if its status is one of these.
    pub(crate) fn has_status(&self, fit: &str, statuses: &[&str]) -> Option<Value> {
        let record = self.get(fit);
        let is_one = statuses.contains(&record["status"].as_str().unwrap());
        is_one.then_some(record)
    }

    /// Largest memory of the process so far \[bytes\].
    pub(crate) fn peak_memory(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id()));
        let status = status.unwrap();
        let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = peak.and_then(|peak| peak.trim().strip_suffix(" kB"));
        1024 * kilobytes.unwrap().trim().parse::<u64>().unwrap()
    }

    /// Id of the process.
    pub(crate) fn id(&self) -> u32 {
        self.child.id()
    }

    /// Sends a signal, named as `kill` names it.
    pub(crate) fn signal(&self, name: &str) {
        let id = self.child.id().to_string();
        let sent = Command::new("kill").args(["-s", name, &id]).status();
        assert!(sent.unwrap().success());
    }

    /// Waits for the process to end by itself.
    pub(crate) fn ended(mut self) -> Option<i32> {
        until("it ends", || self.child.try_wait().unwrap()).code()
    }
}

impl Drop for Service {
    fn drop(&mut self) {
        // It may have ended by itself: then there is nothing to kill.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads the log of a service up to the line that tells where it listens; the rest is read and
/// dropped.
fn listening_address(log: ChildStderr) -> String {
    let mut lines = BufReader::new(log).lines().map_while(Result::ok);
    let address = lines.find_map(|line| {
        let (_, address) = line.split_once("listening on http://")?;
        Some(address.trim().to_owned())
    });
    let address = address.expect("a service tells where it listens");
    std::thread::spawn(move || lines.for_each(drop));
    address
}

/// Asks `find` until it finds something; fails after a time far above what a busy machine needs.
pub(crate) fn until<T>(what: &str, mut find: impl FnMut() -> Option<T>) -> T {
    let deadline = Instant::now() + TIMEOUT;
    loop {
        if let Some(found) = find() {
            return found;
        }
        assert!(Instant::now() < deadline, "{what}: not in {TIMEOUT:?}");
        sleep(Duration::from_millis(5));
    }
}
