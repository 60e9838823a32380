//! Every script of `api/examples` against a started program: what the documentation says can be
//! copied, works.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use crate::program::Service;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// A service, and the folder that examples write into.
struct ExampleRun {
    service: Service,
    folder: TempDir,
}

impl ExampleRun {
    fn start() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let service = Service::start(&folder.path().join("data"));
        Self { service, folder }
    }

    /// Runs an example and returns what it prints.
    fn run(&self, example: &str) -> String {
        let output = Command::new(examples().join(example))
            .env("BASE", format!("http://{}", self.service.address))
            .env("OUT", self.folder.path())
            .env("SEAMSTER", env!("CARGO_BIN_EXE_seamster"))
            .output()
            .unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{example}: {errors}");
        String::from_utf8(output.stdout).unwrap()
    }

    fn file(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.folder.path().join(name)).unwrap()
    }
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("api/examples")
}

/// Each line as JSON.
fn lines(text: &str) -> Vec<Value> {
    let lines = text.lines().filter(|line| !line.is_empty());
    lines
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}")))
        .collect()
}

#[test]
fn every_example_is_run_by_a_test() {
    let run = BTreeSet::from(
        [
            "pattern.sh",
            "seams.sh",
            "suggest.sh",
            "fit.sh",
            "events.sh",
            "cancel.sh",
            "own_fabric.sh",
            "avatar.sh",
            "sew.sh",
            "study.sh",
        ]
        .map(String::from),
    );
    let files = std::fs::read_dir(examples()).unwrap();
    let there: BTreeSet<String> = files
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(there, run);
}

/// The shell blocks of the README's quick start.
fn quick_start() -> Vec<String> {
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let readme = std::fs::read_to_string(readme).unwrap();
    let (_, rest) = readme.split_once("## Quick start\n").unwrap();
    let (section, _) = rest.split_once("\n## ").unwrap();
    let blocks = section.split("```sh\n").skip(1);
    blocks
        .map(|block| block.split_once("```").unwrap().0.to_owned())
        .collect()
}

#[test]
fn quick_start_of_the_readme_is_run_by_these_tests() {
    let examples: Vec<String> = std::fs::read_dir(examples())
        .unwrap()
        .map(|file| std::fs::read_to_string(file.unwrap().path()).unwrap())
        .collect();
    let blocks = quick_start();
    // The service is started as the program here is, without make.
    let (start, calls) = blocks.split_first().unwrap();
    assert!(start.starts_with("make run ") && start.lines().count() == 1);
    assert!(!calls.is_empty());
    for call in calls {
        let is_run = examples.iter().any(|example| example.contains(call));
        assert!(is_run, "no example has these lines:\n{call}");
    }
}

#[test]
fn pattern_comes_back_with_its_panels() {
    let example = ExampleRun::start();
    let answers = lines(&example.run("pattern.sh"));
    assert_eq!(answers[0]["panels"].as_array().unwrap().len(), 3);
    assert_eq!(answers[1]["patterns"].as_array().unwrap().len(), 2);
    assert_eq!(answers[1]["patterns"][1]["id"], answers[0]["id"]);
    assert!(example.file("skirt.svg").starts_with(b"<svg "));
    assert!(example.file("skirt.aama.dxf").ends_with(b"EOF\r\n"));
    let specification = example.file("skirt_specification.json");
    let specification: Value = serde_json::from_slice(&specification).unwrap();
    assert_eq!(
        specification["pattern"]["panel_order"]
            .as_array()
            .unwrap()
            .len(),
        3
    );
}

#[test]
fn seams_are_checked_and_a_wrong_corner_is_found() {
    let example = ExampleRun::start();
    let answers = lines(&example.run("seams.sh"));
    assert_eq!(answers[0]["ok"], true, "{}", answers[0]);
    assert_eq!(answers[1]["ok"], false);
    let fault = &answers[1]["seams"][0]["errors"][0];
    assert_eq!(fault["pointer"], "/seams/0/b/to", "{}", answers[1]);
}

#[test]
fn seams_are_suggested_and_sewn() {
    let example = ExampleRun::start();
    let answers = lines(&example.run("suggest.sh"));
    let found = answers[0]["seams"].as_array().unwrap();
    assert!(!found.is_empty());
    assert!(found.iter().all(|seam| seam["because"].is_string()));
    assert_eq!(answers[1]["status"], "succeeded", "{}", answers[1]);
    let garment: Value = serde_json::from_slice(&example.file("skirt.garment.json")).unwrap();
    let ids = |seams: &Value| -> Vec<_> {
        let seams = seams.as_array().unwrap().iter();
        seams.map(|seam| seam["id"].clone()).collect()
    };
    assert_eq!(ids(&garment["seams"]), ids(&answers[0]["seams"]));
}

#[test]
fn fit_leaves_a_mesh_and_a_report() {
    let example = ExampleRun::start();
    let fit = &lines(&example.run("fit.sh"))[0];
    assert_eq!(fit["status"], "succeeded", "{fit}");
    let report: Value = serde_json::from_slice(&example.file("skirt.report.json")).unwrap();
    assert_eq!(report["converged"], true, "{report}");
    assert!(
        report["seam_gap_max_m"].as_f64().unwrap() < 1e-3,
        "{report}"
    );
    let glb = gltf::Gltf::from_slice(&example.file("skirt.glb")).unwrap();
    assert_eq!(glb.meshes().count(), 3);
    let obj = example.file("skirt.obj");
    let options = tobj::LoadOptions::default();
    let (models, _) =
        tobj::load_obj_buf(&mut obj.as_slice(), &options, |_| Ok(Default::default())).unwrap();
    assert_eq!(models.len(), 3);
}

#[test]
fn events_end_with_the_final_status() {
    let example = ExampleRun::start();
    let text = example.run("events.sh");
    let mut last = None;
    let mut progress = 0;
    for event in text.split("\n\n").filter(|event| event.contains("data:")) {
        progress += usize::from(event.contains("event: progress"));
        last = Some(event);
    }
    let last = last.unwrap();
    assert!(
        last.contains("event: status") && last.contains("\"succeeded\""),
        "{last}"
    );
    assert!(progress > 0, "{text}");
}

#[test]
fn command_line_leaves_a_mesh_and_a_report() {
    let example = ExampleRun::start();
    example.run("sew.sh");
    let report: Value = serde_json::from_slice(&example.file("skirt.report.json")).unwrap();
    assert_eq!(report["converged"], true, "{report}");
    gltf::Gltf::from_slice(&example.file("skirt.glb")).unwrap();
    assert_eq!(&example.file("skirt.png")[1..4], b"PNG");
}

#[test]
fn canceled_fit_says_so() {
    let example = ExampleRun::start();
    let fit = &lines(&example.run("cancel.sh"))[0];
    assert_eq!(fit["status"], "canceled", "{fit}");
}

#[test]
fn study_leaves_a_table_and_a_plot() {
    let example = ExampleRun::start();
    example.run("study.sh");
    let study: Value = serde_json::from_slice(&example.file("skirt.study.json")).unwrap();
    assert_eq!(study["status"], "succeeded", "{study}");
    let runs = study["report"]["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 6, "{study}");
    assert!(
        !study["report"]["recommendation"]
            .as_str()
            .unwrap()
            .is_empty()
    );
    assert!(example.file("skirt.study.svg").starts_with(b"<svg "));
}

#[test]
fn own_fabric_gets_an_id() {
    let example = ExampleRun::start();
    let answers = lines(&example.run("own_fabric.sh"));
    let shipped = answers[0]["fabrics"].as_array().unwrap();
    assert!(shipped.iter().any(|fabric| fabric["id"] == "cotton-poplin"));
    assert!(answers[1]["id"].as_str().is_some_and(|id| !id.is_empty()));
}

#[test]
fn avatar_has_landmarks_and_a_mesh() {
    let example = ExampleRun::start();
    let avatar = &lines(&example.run("avatar.sh"))[0];
    assert!(
        !avatar["landmarks"].as_object().unwrap().is_empty(),
        "{avatar}"
    );
    let glb = gltf::Gltf::from_slice(&example.file("form.glb")).unwrap();
    assert_eq!(glb.meshes().count(), 1);
}
