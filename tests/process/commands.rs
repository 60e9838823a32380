//! The program's commands: what they write, what they print, and their exit codes.

#![expect(
    clippy::unwrap_used,
    reason = "a failure is a failed test, in its helpers too"
)]

use crate::program::{code, garment, run, sample, seamster, stderr};
use serde_json::{Value, json};
use std::net::TcpListener;
use std::path::Path;
use std::process::Output;

fn written(folder: &Path, name: &str, garment: &Value) -> String {
    let path = folder.join(name);
    std::fs::write(&path, garment.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn sew_writes_mesh_report_scene_and_picture() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let garment = written(folder.path(), "garment.json", &garment());
    let dxf = sample("skirt.dxf");
    let (mesh, report, scene) = (at("out.glb"), at("r.json"), at("s.json"));
    let picture = at("out.png");
    let output = run(&[
        "sew",
        &dxf,
        &garment,
        "-o",
        &mesh,
        "--report",
        &report,
        "--scene",
        &scene,
        "--picture",
        &picture,
    ]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert_eq!(&std::fs::read(mesh).unwrap()[..4], b"glTF");
    let report: Value = serde_json::from_slice(&std::fs::read(report).unwrap()).unwrap();
    assert_eq!(report["converged"], true);
    let scene: Value = serde_json::from_slice(&std::fs::read(scene).unwrap()).unwrap();
    assert!(scene.is_object());
    assert_eq!(&std::fs::read(picture).unwrap()[1..4], b"PNG");
}

#[test]
fn sew_refuses_a_picture_that_it_cannot_draw_before_it_sews() {
    let inputs = ["sew", "absent.dxf", "absent.json", "-o", "out.glb"];
    let wrong: [(&[&str], &str); 3] = [
        (&["--picture", "out.jpg"], "must end in .png"),
        (&["--picture", "out.png", "--view", "below"], "`front`"),
        (&["--view", "front"], "--picture"),
    ];
    for (options, why) in wrong {
        let output = run(&[&inputs, options].concat());
        assert_eq!(code(&output), Some(2), "{options:?}");
        assert!(stderr(&output).contains(why), "{}", stderr(&output));
    }
}

/// The lines that tell what was suggested.
fn suggested(output: &Output) -> Vec<String> {
    let told = stderr(output);
    let lines = told
        .lines()
        .filter_map(|line| line.strip_prefix("suggested: "));
    lines.map(str::to_owned).collect()
}

#[test]
fn sew_tells_the_seams_that_it_suggests() {
    let folder = tempfile::tempdir().unwrap();
    let mut asked = garment();
    asked["seams"] = json!("suggest");
    asked["panels"] = json!({});
    let asked = written(folder.path(), "suggest.json", &asked);
    let mesh = folder.path().join("out.glb");
    let output = run(&[
        "sew",
        &sample("skirt.dxf"),
        &asked,
        "-o",
        mesh.to_str().unwrap(),
    ]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let lines = suggested(&output);
    assert!(!lines.is_empty(), "{}", stderr(&output));
    for (i, line) in lines.iter().enumerate() {
        let (place, why) = line.split_once(": confidence ").unwrap();
        assert!(
            place.contains(&format!("suggest.json /seams/{i}: ")),
            "{line}"
        );
        let (confidence, because) = why.split_once(": ").unwrap();
        assert!((0.0..=1.0).contains(&confidence.parse::<f64>().unwrap()));
        assert!(!because.is_empty());
    }
    assert!(mesh.exists());
}

/// A skirt of two trapezia as `GarmentCode` writes it, without stitches \[cm\].
fn drafted_skirt() -> Value {
    let edge = |from: usize| json!({"endpoints": [from, (from + 1) % 4]});
    let panel = |z: f64, turn: f64| {
        json!({
            "translation": [0, 100, z], "rotation": [0, turn, 0],
            "vertices": [[-19, 0], [19, 0], [35, -50], [-35, -50]],
            "edges": [edge(0), edge(1), edge(2), edge(3)],
        })
    };
    json!({
        "pattern": {"panels": {"skirt_front": panel(25.0, 0.0), "skirt_back": panel(-25.0, 180.0)}, "stitches": []},
        "properties": {"units_in_meter": 100, "normalized_edge_loops": true},
    })
}

#[test]
fn sew_takes_a_specification_and_finds_its_seams() {
    let folder = tempfile::tempdir().unwrap();
    let pattern = written(folder.path(), "skirt_specification.json", &drafted_skirt());
    let mut asked = garment();
    asked["seams"] = json!("suggest");
    asked["panels"] = json!({});
    let asked = written(folder.path(), "suggest.json", &asked);
    let mesh = folder.path().join("out.glb");
    let output = run(&["sew", &pattern, &asked, "-o", mesh.to_str().unwrap()]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert_eq!(suggested(&output).len(), 2, "{}", stderr(&output));
    assert!(mesh.exists());
}

#[test]
fn sew_tells_every_fault_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let mut bad = garment();
    bad["default_fabric"] = json!("no-such-fabric");
    bad["seams"][0]["a"]["panel"] = json!("no-such-panel");
    let bad = written(folder.path(), "bad.json", &bad);
    let output = run(&["sew", &sample("skirt.dxf"), &bad, "-o", "/nowhere/out.glb"]);
    let told = stderr(&output);
    assert_eq!(code(&output), Some(2), "{told}");
    for place in ["bad.json /default_fabric: ", "bad.json /seams/0/a"] {
        assert!(told.lines().any(|line| line.contains(place)), "{told}");
    }
}

#[test]
fn sew_tells_all_that_is_misshapen_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let mut bad = garment();
    bad["simulate"]["edge_lenght_m"] = json!(0.01);
    bad["seams"][0]["a"]["from"] = json!({"edge": 1, "at": 0.5, "notch": 2});
    bad["seams"][1]["b"].as_object_mut().unwrap().remove("to");
    bad["friction"] = json!("little");
    let bad = written(folder.path(), "bad.json", &bad);
    let output = run(&["sew", &sample("skirt.dxf"), &bad, "-o", "/nowhere/out.glb"]);
    let told = stderr(&output);
    assert_eq!(code(&output), Some(2), "{told}");
    for fault in [
        "bad.json /simulate/edge_lenght_m: request/unknown_field",
        "bad.json /seams/0/a/from/notch: request/unknown_field",
        "bad.json /seams/1/b/to: request/missing_field",
        "bad.json /friction: request/wrong_type",
    ] {
        assert!(told.lines().any(|line| line.contains(fault)), "{told}");
    }
    assert!(told.contains("did you mean \"edge_length_m\"?"), "{told}");
    let cut_off = folder.path().join("cut.json");
    std::fs::write(&cut_off, "{\n").unwrap();
    let output = run(&["sew", cut_off.to_str().unwrap(), "-o", "/nowhere/out.glb"]);
    assert_eq!(code(&output), Some(2));
    assert!(stderr(&output).contains("cut.json line 2 column"));
}

#[test]
fn sew_names_the_file_that_is_at_fault() {
    let folder = tempfile::tempdir().unwrap();
    let good = written(folder.path(), "good.json", &garment());
    let junk = written(folder.path(), "junk.dxf", &json!("not a drawing"));
    let cases = [
        (vec![junk.as_str(), &good], "junk.dxf"),
        (vec!["absent.dxf", &good], "absent.dxf"),
        (vec![junk.as_str(), "absent.json"], "absent.json"),
        (vec![good.as_str()], "/pattern"),
    ];
    for (inputs, named) in cases {
        let output = run(&[&["sew", "-o", "out.glb"], inputs.as_slice()].concat());
        assert_eq!(code(&output), Some(2), "{named}");
        assert!(stderr(&output).contains(named), "{}", stderr(&output));
    }
}

#[test]
fn pattern_where_a_garment_must_be_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let spec = written(folder.path(), "skirt_specification.json", &drafted_skirt());
    let dxf = sample("skirt.dxf");
    for command in ["sew", "study"] {
        for inputs in [
            vec![spec.as_str()],
            vec![dxf.as_str()],
            vec![spec.as_str(), &dxf],
        ] {
            let output = run(&[&[command, "-o", "out.glb"], inputs.as_slice()].concat());
            assert_eq!(code(&output), Some(2), "{inputs:?}");
            let told = stderr(&output);
            assert_eq!(told.lines().count(), 1, "{told}");
            assert!(
                told.contains("fit/no_garment") && told.contains("garment file"),
                "{told}"
            );
        }
    }
}

#[test]
fn import_prints_panels_and_decisions_and_writes_files() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let dxf = sample("skirt.dxf");
    let (drawing, out, specification) = (at("d.svg"), at("o.dxf"), at("s.json"));
    let output = run(&[
        "import",
        &dxf,
        "--drawing",
        &drawing,
        "--dxf",
        &out,
        "--specification",
        &specification,
    ]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    for part in [
        "3 panels",
        "notches",
        "units: mm",
        "--units",
        "size: M",
        "seam allowance",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    assert!(std::fs::read_to_string(drawing).unwrap().contains("</svg>"));
    assert!(stderr(&output).contains("s.json: not in this file: "));
    let printed = |file: &str| {
        let output = run(&["import", file, "--json"]);
        assert_eq!(code(&output), Some(0), "{}", stderr(&output));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let names = |pattern: &Value| -> Vec<Value> {
        let panels = pattern["panels"].as_array().unwrap().iter();
        panels.map(|panel| panel["name"].clone()).collect()
    };
    let first = printed(&dxf);
    for file in [&out, &specification] {
        assert_eq!(names(&printed(file)), names(&first));
    }
}

#[test]
fn import_takes_the_options_of_the_service_and_tells_faults() {
    let dxf = sample("skirt.dxf");
    let output = run(&["import", &dxf, "--json", "--units", "cm"]);
    let pattern: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(pattern["source"]["scale_to_m"], 0.01);
    let wrong: [(&[&str], &str); 6] = [
        (&["--encoding", "ell"], "--encoding"),
        (&["--size", "XXL"], "pattern/unknown_size"),
        (&["--units", "m"], "--units mm would make it"),
        (&["--units", "ell"], "--units"),
        (&["--rotation-order", "yxz"], "--rotation-order"),
        (&["second.dxf"], "second.dxf"),
    ];
    for (options, why) in wrong {
        let output = run(&[&["import", dxf.as_str()], options].concat());
        assert_eq!(code(&output), Some(2), "{options:?}");
        assert!(stderr(&output).contains(why), "{}", stderr(&output));
    }
    let absent = run(&["import", "absent.dxf"]);
    assert_eq!(code(&absent), Some(2));
    assert!(stderr(&absent).contains("absent.dxf"));
    let unwritable = run(&["import", &dxf, "--dxf", "/nowhere/out.dxf"]);
    assert_eq!(code(&unwritable), Some(1));
}

#[test]
fn study_writes_a_table_and_a_plot_and_recommends() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let garment = written(folder.path(), "garment.json", &garment());
    let (study, plot) = (at("study.json"), at("study.svg"));
    let output = run(&[
        "study",
        &sample("skirt.dxf"),
        &garment,
        "-o",
        &study,
        "--plot",
        &plot,
        "--methods",
        "newton",
        "--tolerances",
        "0.1,0.001",
        "--edge-lengths",
        "0.06",
        "--time-limit",
        "20",
    ]);
    // One method alone confirms no reference within the time, maybe: then it says what it left out.
    let done = code(&output);
    assert!(
        done == Some(0) || stderr(&output).contains("left out"),
        "{}",
        stderr(&output)
    );
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let study: Value = serde_json::from_str(&std::fs::read_to_string(study).unwrap()).unwrap();
    assert_eq!(said.trim(), study["recommendation"].as_str().unwrap());
    assert!(said.contains("newton"), "{said}");
    assert_eq!(study["runs"].as_array().unwrap().len(), 2);
    assert!(std::fs::read_to_string(plot).unwrap().contains("</svg>"));
    let refused = run(&[
        "study",
        &sample("skirt.dxf"),
        &garment,
        "-o",
        "x",
        "--tolerances",
        "-1",
    ]);
    assert_eq!(code(&refused), Some(2), "{}", stderr(&refused));
}

#[test]
fn sew_refuses_an_unknown_format_before_it_sews() {
    let output = run(&["sew", "absent.dxf", "absent.json", "-o", "out.stl"]);
    assert_eq!(code(&output), Some(2));
    assert!(stderr(&output).contains(".glb, .obj, .ply or .json"));
}

#[test]
fn settings_that_cannot_be_served_are_refused() {
    let cases = [
        (vec!["serve", "--listen", "0.0.0.0:0"], "SEAMSTER_TOKENS"),
        (vec!["serve", "--store", "nats://localhost"], "sqlite"),
        (vec!["serve", "--blobs", "s3://bucket"], "file"),
        (vec!["serve", "--workers", "0"], "at least 1"),
        (vec!["serve", "--log", "=,="], "--log"),
        (vec!["worker"], "seamster serve"),
        (vec!["mend"], "unrecognized subcommand"),
    ];
    for (arguments, said) in cases {
        let output = run(&arguments);
        assert_eq!(code(&output), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
    }
}

#[test]
fn settings_come_from_the_environment_too() {
    let output = seamster(&["serve"])
        .env("SEAMSTER_LISTEN", "0.0.0.0:0")
        .env("SEAMSTER_TOKENS", "")
        .output()
        .unwrap();
    assert_eq!(code(&output), Some(2));
    assert!(stderr(&output).contains("SEAMSTER_TOKENS"));
}

#[test]
fn schemas_are_printed_as_json() {
    for command in ["openapi", "schema"] {
        let output = run(&[command]);
        assert_eq!(code(&output), Some(0));
        let value: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(value.is_object());
    }
}

#[test]
fn health_fails_where_nothing_listens() {
    let bound = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = bound.local_addr().unwrap().to_string();
    drop(bound);
    let output = run(&["health", "--listen", &address]);
    assert_eq!(code(&output), Some(1));
}
