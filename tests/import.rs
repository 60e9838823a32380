//! Real and hostile DXF files against the truth that lies beside them, found by `SEAMSTER_TEST_DATA`.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{ImportOptions, Pattern, import};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The data folder; `None` where the variable is unset, with a line saying so.
fn data(tests_left_out: &str) -> Option<PathBuf> {
    let found = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if found.is_none() {
        println!("left out: {tests_left_out} (SEAMSTER_TEST_DATA is unset)");
    }
    found
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("a readable file")).expect("valid JSON")
}

fn read(path: &Path) -> Result<Pattern, Faults> {
    let bytes = std::fs::read(path).expect("a readable file");
    import(&bytes, &ImportOptions::default(), &Limits::default())
}

/// Panels and areas [mm2] that the manifest gives for a file: those of the sample size, else all.
fn truth(entry: &Value) -> (u64, Vec<f64>) {
    let count = entry["pieces_in_sample_size"]
        .as_u64()
        .or(entry["piece_count"].as_u64())
        .expect("a count");
    let sample = entry["sample_size"].as_str();
    let pieces = entry["pieces"]
        .as_array()
        .map(Vec::as_slice)
        .unwrap_or_default();
    let areas = pieces
        .iter()
        .filter(|p| entry["pieces_in_sample_size"].is_null() || p["size"].as_str() == sample)
        .filter_map(|p| p["outline"]["area_mm2"].as_f64().or(p["area_mm2"].as_f64()));
    let mut areas: Vec<f64> = areas.collect();
    areas.sort_by(f64::total_cmp);
    (count, areas)
}

/// What differs between a pattern and the truth; empty where nothing does.
fn difference(pattern: &Pattern, entry: &Value) -> String {
    let (count, areas) = truth(entry);
    if pattern.panels.len() as u64 != count {
        return format!("{} panels, {count} expected", pattern.panels.len());
    }
    let mut found: Vec<f64> = pattern
        .panels
        .iter()
        .map(|p| 1e6 * p.drawn_area_m2)
        .collect();
    found.sort_by(f64::total_cmp);
    let worst = found
        .iter()
        .zip(&areas)
        .map(|(a, b)| (a / b - 1.0).abs())
        .fold(0.0, f64::max);
    if worst > 1e-3 {
        format!("areas differ by up to {:.2} %", 100.0 * worst)
    } else {
        String::new()
    }
}

fn table(folder: &Path, chosen: impl Fn(&str) -> bool) -> Vec<String> {
    let manifest = json(&folder.join("manifest.json"));
    let mut wrong = Vec::new();
    for entry in manifest["files"].as_array().expect("a list of files") {
        let name = entry["file"].as_str().expect("a file name");
        if !chosen(name) {
            continue;
        }
        let result = match read(&folder.join(name)) {
            Ok(pattern) => difference(&pattern, entry),
            Err(faults) => faults.to_string(),
        };
        println!(
            "{name:50} {}",
            if result.is_empty() { "ok" } else { &result }
        );
        if !result.is_empty() {
            wrong.push(format!("{name}: {result}"));
        }
    }
    wrong
}

#[test]
fn gerber_and_clo_files_have_their_panels_and_areas() {
    let Some(data) = data("gerber_* and clo*") else {
        return;
    };
    let wrong = table(&data.join("dxf"), |name| {
        name.starts_with("gerber_") || name.starts_with("clo")
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn print_all() {
    let Some(data) = data("all") else { return };
    let wrong = table(&data.join("dxf"), |_| true);
    println!("{} wrong", wrong.len());
}
