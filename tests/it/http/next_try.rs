//! Fits that start from the shape of another, and what a garment measures, over HTTP.

use super::{mesh, sewn};
use seamster_fixtures::panels::{pattern, trapezoid};
use seamster_fixtures::server::Server;
use serde_json::{Value, json};

/// A tube about the hips that is this much wider \[m\], of a fabric.
fn tube(wider: f64, fabric: &str) -> Value {
    let half = |id: &str| trapezoid(id, 0.6 + wider, 0.4 + wider, 0.35);
    let run = |panel: &str, from: usize, to: usize| json!({"panel": panel, "from": from, "to": to});
    let seam = |id: &str, from: usize, to: usize| json!({"id": id, "a": run("front", from, to), "b": run("back", 3 - from, 3 - to)});
    json!({
        "pattern": pattern(vec![half("front"), half("back")]),
        "seams": [seam("left", 0, 1), seam("right", 3, 2)],
        "panels": {"front": {"placement": {"at": "skirt_front"}}, "back": {"placement": {"at": "skirt_back"}}},
        "simulate": {"edge_length_m": 0.04, "tolerance": 1e-4},
        "default_fabric": fabric,
    })
}

fn report(server: &Server, id: &str) -> Value {
    server.get(&format!("/v1/fits/{id}/report")).json()
}

fn energy(report: &Value) -> f64 {
    let terms = report["energy_j"].as_object().expect("energies by term");
    terms.values().filter_map(Value::as_f64).sum()
}

/// Weight of the cloth times 2 mm \[J\]: two shapes whose energies differ by less are as good as
/// each other.
fn two_millimeters(density_kg_m2: f64) -> f64 {
    let area = 2.0 * 0.5 * (0.6 + 0.4) * 0.35;
    area * density_kg_m2 * 9.80665 * 2e-3
}

#[test]
fn the_next_try_starts_from_the_last_shape() {
    let server = Server::start();
    let first = sewn(&server, &tube(0.0, "cotton-poplin"));
    for (wider, fabric, density) in [(0.0, "denim-11oz", 0.37), (0.01, "cotton-poplin", 0.12)] {
        let cold = sewn(&server, &tube(wider, fabric));
        let mut garment = tube(wider, fabric);
        garment["start_from"] = json!(first);
        let warm = sewn(&server, &garment);
        let [cold, warm_report] = [&cold, &warm].map(|id| report(&server, id));
        // What it began with has more energy than what became of it.
        let began = warm_report["started_from"]["energy_j"].as_object();
        let began: f64 = began
            .into_iter()
            .flatten()
            .filter_map(|(_, e)| e.as_f64())
            .sum();
        assert!(began > energy(&warm_report), "{began} with {fabric}");
        assert!(cold["started_from"].is_null());
        let apart = (energy(&warm_report) - energy(&cold)).abs();
        assert!(apart < two_millimeters(density), "{apart} J with {fabric}");
        assert_eq!(warm_report["levels"].as_array().map(Vec::len), Some(1));

        // The saved file is complete in itself: the same again where no other fit ever was.
        let saved = server.get(&format!("/v1/fits/{warm}/garment")).json();
        let empty = Server::start();
        let again = sewn(&empty, &saved);
        assert!(mesh(&empty, &again) == mesh(&server, &warm), "{fabric}");
    }
}

#[test]
fn a_shape_that_is_no_start_is_told_and_left() {
    let server = Server::start();
    let first = sewn(&server, &tube(0.0, "cotton-poplin"));
    let mut other_panels = tube(0.0, "cotton-poplin");
    let shape = mesh(&server, &first);
    let panels: Vec<Value> = shape["panels"].as_array().expect("panels").iter().map(|panel| {
        json!({"panel": format!("{}2", panel["panel"].as_str().expect("an id")), "positions": panel["positions"], "uv": panel["uv"], "triangles": panel["triangles"]})
    }).collect();
    let avatar = server.get(&format!("/v1/fits/{first}/garment")).json()["avatar"].clone();
    other_panels["start_from"] = json!({"avatar": avatar, "panels": panels});
    let fit = sewn(&server, &other_panels);
    let report = report(&server, &fit);
    assert!(report["started_from"].is_null());
    let warnings = report["warnings"].as_array().expect("warnings");
    let told = warnings.iter().find(|w| w["code"] == "garment/start_left");
    assert!(
        told.is_some_and(|w| w["detail"].to_string().contains("no panel front")),
        "{warnings:?}"
    );

    let refused = |garment: &Value, code: &str| {
        let faults = server.post_json("/v1/fits", garment).faults(422);
        assert_eq!(faults, [format!("{code} /start_from")]);
    };
    let mut unknown = tube(0.0, "cotton-poplin");
    unknown["start_from"] = json!("019a0000-0000-7000-8000-000000000000");
    refused(&unknown, "garment/start_unknown");
    let mut posed = tube(0.0, "cotton-poplin");
    posed["start_from"] = json!(first);
    posed["avatar"] = json!({"form": {"height_m": 1.68, "bust_m": 0.92, "waist_m": 0.74, "hip_m": 0.98, "pose": "t"}});
    refused(&posed, "garment/start_avatar");
    posed["avatar"] = Value::Null;
    refused(&posed, "garment/start_avatar");
    let mut flat = other_panels.clone();
    let panel = &mut flat["start_from"]["panels"][0];
    let corners: [usize; 3] =
        serde_json::from_value(panel["triangles"][0].clone()).expect("a triangle");
    panel["uv"][corners[0]] = panel["uv"][corners[1]].clone();
    refused(&flat, "garment/start_shape");
    let mut broken = other_panels.clone();
    broken["start_from"]["panels"][0]["triangles"][0] = json!([0, 1, 4_000_000]);
    refused(&broken, "garment/start_shape");
    let mut stepped = tube(0.0, "cotton-poplin");
    stepped["start_from"] = json!(first);
    stepped["simulate"]["method"] = json!("implicit_euler");
    refused(&stepped, "garment/not_available");
    let mut study = tube(0.0, "cotton-poplin");
    study["start_from"] = json!(first);
    let study = json!({"garment": study, "methods": ["newton"]});
    let faults = server.post_json("/v1/studies", &study).faults(422);
    assert_eq!(faults, ["garment/not_available /garment/start_from"]);
}

#[test]
fn a_fit_has_maps_and_measures() {
    let server = Server::start();
    let mut garment = tube(0.0, "cotton-poplin");
    garment["maps"] = json!(["strain", "pressure", "gap"]);
    let fit = sewn(&server, &garment);
    let mesh = mesh(&server, &fit);
    let count = mesh["panels"][0]["positions"].as_array().map(Vec::len);
    for name in [
        "strain_warp",
        "strain_weft",
        "strain_share",
        "pressure_kpa",
        "gap_mm",
    ] {
        let values = mesh["panels"][0]["maps"][name].as_array().map(Vec::len);
        assert_eq!(values, count, "{name}");
    }
    assert_eq!(
        report(&server, &fit)["maps"].as_array().map(Vec::len),
        Some(5)
    );
    let ply = server.get(&format!("/v1/fits/{fit}/mesh.ply"));
    assert_eq!(
        (ply.header("content-type"), &ply.bytes[..4]),
        ("model/ply", &b"ply\n"[..])
    );

    let measures = server.get(&format!("/v1/fits/{fit}/measures")).json();
    assert_eq!(measures["seams"][0]["seam"], "left");
    // Both sides of a trapezoid: 0.35 m high, 0.1 m further out below.
    let side = 0.35_f64.hypot(0.1);
    for length in ["a_m", "b_m"] {
        let off = measures["seams"][0][length]
            .as_f64()
            .map(|length| length - side);
        assert!(off.is_some_and(|off| off.abs() < 1e-9), "{measures}");
    }
    let area = measures["panels"][0]["area_m2"]
        .as_f64()
        .map(|area| area - 0.5 * 0.35);
    assert!(area.is_some_and(|off| off.abs() < 1e-9), "{measures}");
    // It is held by the hip, which it goes round with some room or none.
    let girths = measures["girths"].as_array().expect("girths");
    let hip = girths
        .iter()
        .find(|girth| girth["at"] == "hip")
        .expect("it is round the hip");
    let value = |name: &str| hip[name].as_f64().expect("a number");
    assert!((value("body_m") - 0.98).abs() < 5e-3, "{hip}");
    // Its girth there is between those of its two ends on the pattern, but for its stretch.
    let stretch = 1.0
        + report(&server, &fit)["strain_max"]
            .as_f64()
            .expect("a number");
    assert!((0.8..1.2 * stretch).contains(&value("cloth_m")), "{hip}");
}
