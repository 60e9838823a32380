//! Surfaces of inner garments, as files state them.

use seamster::config::Limits;
use seamster::fault::Fault;
use seamster::fit::{self, Garment, PatternRef, ShippedAssets};
use seamster_fixtures::panels::{pattern, rectangle};
use serde_json::{Value, json};

/// The faults of a garment over a surface of one triangle with the fields of `change` put over
/// those of its panel.
fn faults(change: &Value) -> Vec<Fault> {
    let mut panel = json!({
        "panel": "over:front", "thickness_m": 4e-4, "friction": 0.3,
        "positions": [[0.0, 1.0, 0.2], [0.1, 1.0, 0.2], [0.0, 1.1, 0.2]], "triangles": [[0, 1, 2]],
    });
    for (key, value) in change.as_object().expect("fields") {
        panel[key] = value.clone();
    }
    let form = json!({"form": {"height_m": 1.7, "bust_m": 0.9, "waist_m": 0.7, "hip_m": 1.0}});
    let garment = json!({
        "seams": [], "avatar": form, "over": {"avatar": form, "panels": [panel]},
        "panels": {"front": {"placement": {"at": "torso_front"}}},
    });
    let garment = Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern(vec![rectangle(
            "front", 0.2, 0.2,
        )])))),
        ..serde_json::from_value(garment).expect("a garment")
    };
    match fit::resolve(garment, &ShippedAssets, &Limits::default()) {
        Ok(resolved) => {
            // It resolves to the same again.
            let file = resolved.garment();
            let again = fit::resolve(file.clone(), &ShippedAssets, &Limits::default());
            assert_eq!(again.expect("it was right").garment(), file);
            vec![]
        }
        Err(faults) => faults.0,
    }
}

#[test]
fn a_surface_that_is_not_one_of_cloth_is_refused() {
    assert_eq!(faults(&json!({})), []);
    for (change, what) in [
        (json!({"thickness_m": 0.0}), "thickness"),
        (json!({"friction": -0.1}), "friction"),
        (json!({"triangles": [[0, 1, 3]]}), "corner"),
        (json!({"triangles": [[0, 1, 1]]}), "area"),
        (
            json!({"positions": [[0, 0, 0], [1e9, 0, 0], [0, 1, 0]]}),
            "position",
        ),
        (json!({"panel": "x".repeat(1000)}), "name"),
    ] {
        let found = faults(&change);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].pointer, "/over");
        assert_eq!(found[0].code.to_string(), "garment/over_surface");
        assert!(found[0].detail.contains(what), "{found:?}");
    }
}

/// Without a service there are no fits: the fault says how it is done.
#[test]
fn without_a_service_an_id_is_refused_with_the_way() {
    let garment: Garment = serde_json::from_value(json!({
        "pattern": pattern(vec![rectangle("front", 0.2, 0.2)]), "seams": [],
        "panels": {"front": {"placement": {"at": "torso_front"}}},
        "over": "019a0000-0000-7000-8000-000000000000",
    }))
    .expect("a garment");
    let faults = fit::resolve(garment, &ShippedAssets, &Limits::default());
    let faults = faults.expect_err("there is no such fit").0;
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert_eq!(faults[0].code.to_string(), "garment/over_unknown");
    let fix = faults[0].fix.as_deref().expect("a way");
    assert!(fix.contains("POST /v1/fits"), "{fix}");
}
