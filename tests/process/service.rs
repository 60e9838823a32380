//! The service as a process: what survives its end, and how it ends.

use crate::program::{Service, code, garment, run, sample, seamster, stderr, until};
use seamster::config::Limits;
use seamster_fixtures::panels::{pattern, trapezoid};
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::Stdio;

const FINAL: [&str; 3] = ["succeeded", "failed", "canceled"];

#[test]
fn killed_service_finishes_the_fit_after_a_restart() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let fit = service.submit();
    until("it runs", || service.has_status(&fit, &["running"]));
    service.signal("KILL");
    drop(service);
    let service = Service::start(data.path());
    let record = until("it ends", || service.has_status(&fit, &FINAL));
    assert_eq!(record["status"], "succeeded", "{record}");
    assert_eq!(record["attempts"], 2);
    let report = service.get(&format!("{fit}/report"));
    assert_eq!(report["converged"], true);
}

#[test]
fn killed_service_finishes_the_study_after_a_restart() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let dxf = std::fs::read(sample("skirt.dxf")).unwrap();
    let mut garment = garment();
    garment["pattern"] = service.post("/v1/patterns", &dxf, "application/dxf")["id"].clone();
    let asked = serde_json::json!({
        "garment": garment, "methods": ["newton"], "tolerances": [1e-1, 1e-2], "edge_lengths_m": [0.05],
    });
    let body = asked.to_string();
    let study = service.post("/v1/studies", body.as_bytes(), "application/json");
    let study = format!("/v1/studies/{}", study["id"].as_str().unwrap());
    until("it runs", || service.has_status(&study, &["running"]));
    service.signal("KILL");
    drop(service);
    let service = Service::start(data.path());
    let record = until("it ends", || service.has_status(&study, &FINAL));
    assert_eq!(record["status"], "succeeded", "{record}");
    assert_eq!(record["attempts"], 2);
    assert_eq!(record["report"]["runs"].as_array().unwrap().len(), 2);
}

#[test]
fn terminated_service_gives_the_fit_back_and_ends() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let fit = service.submit();
    until("it runs", || service.has_status(&fit, &["running"]));
    service.signal("TERM");
    assert_eq!(service.ended(), Some(0));
    let service = Service::start(data.path());
    let record = until("it ends", || service.has_status(&fit, &FINAL));
    assert_eq!(record["status"], "succeeded", "{record}");
    assert_eq!(record["attempts"], 2);
}

#[test]
fn health_is_well_where_a_service_listens() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let output = run(&["health", "--listen", &service.address]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
}

#[test]
fn second_service_on_the_same_folder_is_refused() {
    let data = tempfile::tempdir().unwrap();
    let _service = Service::start(data.path());
    let folder: PathBuf = data.path().to_owned();
    let output = run(&[
        "serve",
        "--listen",
        "127.0.0.1:0",
        "--data",
        folder.to_str().unwrap(),
    ]);
    assert_eq!(code(&output), Some(1));
    assert!(stderr(&output).contains("another process"));
}

/// Process ids of the processes that a service started.
fn children(service: &Service) -> Vec<String> {
    let id = service.id();
    let tasks = std::fs::read_dir(format!("/proc/{id}/task")).expect("it runs");
    let children = tasks.filter_map(|task| {
        let list = task.ok()?.path().join("children");
        std::fs::read_to_string(list).ok()
    });
    let ids = children.flat_map(|list| {
        list.split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    });
    ids.collect()
}

#[test]
fn a_fit_that_ran_through_many_deaths_of_its_service_succeeds() {
    let data = tempfile::tempdir().unwrap();
    let mut service = Service::start(data.path());
    let fit = service.submit();
    for _ in 0..5 {
        until("it runs", || {
            service.has_status(&fit, &["running", "succeeded"])
        });
        service.signal("KILL");
        drop(service);
        service = Service::start(data.path());
    }
    let record = until("it ends", || service.has_status(&fit, &FINAL));
    assert_eq!(record["status"], "succeeded", "{record}");
}

#[test]
fn a_fit_whose_own_process_dies_twice_fails_with_its_cause() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let fit = service.submit();
    until("it runs", || service.has_status(&fit, &["running"]));
    service.signal("KILL");
    drop(service);
    let service = Service::start(data.path());
    let record = until("it ends", || {
        for child in children(&service) {
            // It may have ended by itself meanwhile.
            let _ = std::process::Command::new("kill")
                .args(["-s", "ABRT", &child])
                .status();
        }
        service.has_status(&fit, &FINAL)
    });
    assert_eq!(record["status"], "failed", "{record}");
    let detail = record["error"]["detail"].as_str().unwrap();
    assert!(
        detail.contains("died 2 times") && detail.contains("signal 6"),
        "{detail}"
    );
    // The service itself lives, and serves on.
    let fit = service.submit();
    let record = until("it ends", || service.has_status(&fit, &FINAL));
    assert_eq!(record["status"], "succeeded", "{record}");
}

/// The last line that a job tells which runs in a process of its own under these limits.
fn job_under(limits: &Limits) -> Value {
    let half = |id: &str| trapezoid(id, 0.6, 0.4, 0.35);
    let run = |panel: &str, from: usize, to: usize| json!({"panel": panel, "from": from, "to": to});
    let seam = |id: &str, from: usize, to: usize| json!({"id": id, "a": run("front", from, to), "b": run("back", 3 - from, 3 - to)});
    let garment = json!({
        "pattern": pattern(vec![half("front"), half("back")]),
        "seams": [seam("left", 0, 1), seam("right", 3, 2)],
        "panels": {"front": {"placement": {"at": "skirt_front"}}, "back": {"placement": {"at": "skirt_back"}}},
        "simulate": {"edge_length_m": 0.04, "tolerance": 1e-2},
    });
    let mut child = seamster(&["run-job"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut input = child.stdin.take().expect("it is piped");
    let limits = serde_json::to_string(limits).expect("limits are numbers");
    writeln!(input, "{limits}\n\"fit\"\n{garment}").expect("it reads");
    // The end of its input would stop it.
    let output = child.wait_with_output().expect("it ends");
    drop(input);
    let output = String::from_utf8(output.stdout).expect("JSON is UTF-8");
    serde_json::from_str(output.lines().last().expect("a line")).expect("JSON")
}

#[test]
fn a_job_in_its_own_process_keeps_to_the_limits_of_its_service() {
    assert!(job_under(&Limits::default())["fit"].is_object());
    let few = Limits {
        mesh_vertices: 10,
        ..Limits::default()
    };
    assert!(job_under(&few)["refused"].is_array());
}
