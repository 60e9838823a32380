//! Garments in wind, from the garment file to the drape.

use seamster::config::Limits;
use seamster::fit::{self, FitOutcome, Garment, ShippedAssets, resolve};
use seamster::progress::CancelToken;
use seamster_fixtures::samples::{sample, with_context};
use serde_json::{Value, json};

fn draped(wind: Value) -> FitOutcome {
    let changes = json!({"wind": wind, "simulate": {"edge_length_m": 0.04}});
    let prepared = sample("skirt", changes);
    with_context(
        &Limits::default(),
        &CancelToken::new(),
        |_| {},
        |context| fit::run(&prepared, context),
    )
    .expect("the sample has a mesh")
}

fn mean_z(outcome: &FitOutcome) -> f64 {
    let z: Vec<f64> = outcome
        .mesh
        .panels
        .iter()
        .flat_map(|panel| panel.positions.iter().map(|p| p[2]))
        .collect();
    z.iter().sum::<f64>() / z.len() as f64
}

#[test]
fn a_skirt_comes_to_rest_in_wind_and_is_blown_downwind() {
    let calm = draped(Value::Null);
    let blown = draped(json!({"velocity_m_s": [0.0, 0.0, 3.0]}));
    for (outcome, has_wind) in [(&calm, false), (&blown, true)] {
        let report = &outcome.report;
        assert!(report.converged, "{}", report.why);
        assert_eq!(report.terms.iter().any(|t| t.name == "wind"), has_wind);
        assert_eq!(
            report.skipped_terms.iter().any(|t| t.name == "wind"),
            !has_wind
        );
    }
    // 3 m/s press with 6 Pa, three times the weight of a light cloth: it moves by far more than a
    // shape at rest is uncertain by.
    assert!(mean_z(&blown) > mean_z(&calm) + 1e-3);
}

#[test]
fn the_neutral_scene_has_the_wind_of_its_garment() {
    let scene = |wind: Value| -> Value {
        let changes = json!({"wind": wind, "simulate": {"edge_length_m": 0.04}});
        let prepared = sample("skirt", changes);
        let json = with_context(
            &Limits::default(),
            &CancelToken::new(),
            |_| {},
            |context| fit::scene_json(&prepared, context),
        );
        serde_json::from_slice(&json.expect("the sample has a mesh")).expect("JSON")
    };
    let wind = json!({"velocity_m_s": [0.5, 0.0, -3.0], "gust": 0.25});
    assert_eq!(scene(wind.clone())["wind"], wind);
    assert_eq!(scene(Value::Null).get("wind"), Some(&Value::Null));
}

#[test]
fn a_wind_that_no_garment_is_worn_in_is_refused() {
    let garment = json!({
        "schema": "seamster/garment/1",
        "seams": [],
        "wind": {"velocity_m_s": [30.0, 0.0, 30.0], "gust": 1.5},
    });
    let garment: Garment = serde_json::from_value(garment).expect("a garment file");
    let faults = resolve(garment, &ShippedAssets, &Limits::default()).expect_err("too much wind");
    let pointers: Vec<&str> = faults.0.iter().map(|f| f.pointer.as_str()).collect();
    for expected in ["/wind/velocity_m_s", "/wind/gust"] {
        assert!(pointers.contains(&expected), "{pointers:?}");
    }
}
