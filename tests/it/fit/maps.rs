//! Maps on a draped garment agree with its shape, its report and each other.

use seamster::export::DrapedPanel;
use seamster::fit::FitOutcome;
use seamster::solver::MapSummary;
use seamster_fixtures::panels::{pattern, rectangle};
use seamster_fixtures::samples;
use serde_json::{Value, json};

/// The sample skirt with all maps and these changes.
fn skirt(mut changes: Value) -> FitOutcome {
    changes["maps"] = json!(["gap", "pressure", "strain", "strain"]);
    changes["simulate"] = json!({"edge_length_m": 0.03});
    super::sewn(samples::garment("skirt", changes))
}

fn map<'a>(outcome: &'a FitOutcome, name: &str) -> &'a MapSummary {
    let maps = &outcome.report.maps;
    let found = maps.iter().find(|map| map.name == name);
    found.expect("it was asked for")
}

/// Area of the triangles at each vertex on the pattern, a third of each \[m²\].
fn areas(panel: &DrapedPanel) -> Vec<f64> {
    let mut areas = vec![0.0; panel.positions.len()];
    for triangle in &panel.triangles {
        let corners = triangle.map(|v| v as usize);
        let [p, q, r] = corners.map(|v| panel.uv[v]);
        let sixth = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        let third = sixth.abs() / 6.0;
        corners.iter().for_each(|&v| areas[v] += third);
    }
    areas
}

#[test]
fn maps_of_a_skirt_are_those_of_its_shape() {
    let outcome = skirt(json!({}));
    let units = outcome.report.maps.iter();
    let units: Vec<_> = units.map(|map| (&*map.name, &*map.unit)).collect();
    let expected = [
        ("strain_warp", "1"),
        ("strain_weft", "1"),
        ("strain_share", "1"),
        ("pressure", "kPa"),
        ("gap", "mm"),
    ];
    assert_eq!(units, expected);
    for panel in &outcome.mesh.panels {
        let maps: Vec<_> = panel.maps.named().collect();
        assert_eq!(maps.len(), 5);
        assert!(
            maps.iter()
                .all(|(_, values)| values.len() == panel.positions.len())
        );
        // The body presses on triangles, which hand it on to their vertices.
        let gaps = &panel.maps.gap_mm;
        let mut nearest = gaps.clone();
        for triangle in &panel.triangles {
            let corners = triangle.map(|v| v as usize);
            let least = corners
                .map(|v| gaps[v])
                .into_iter()
                .fold(f64::INFINITY, f64::min);
            for v in corners {
                nearest[v] = nearest[v].min(least);
            }
        }
        for (pressure, (gap, nearest)) in panel
            .maps
            .pressure_kpa
            .iter()
            .zip(gaps.iter().zip(&nearest))
        {
            assert!(
                *gap >= 0.0 && (*nearest < 2.0 || *pressure == 0.0),
                "{pressure} {gap} {nearest}"
            );
        }
        for strain in panel.maps.strain_warp.iter().chain(&panel.maps.strain_weft) {
            // A mean of triangles is no more than the most stretched one.
            assert!(*strain <= outcome.report.strain_max + 1e-12);
        }
    }
    // It hangs from the waist: there it is pressed, and its hem stands off.
    let zone = |map: &MapSummary, name: &str| {
        let found = map.zones.iter().find(|zone| zone.name == name);
        found.map_or((0.0, 0.0), |zone| (zone.mean, zone.max))
    };
    let pressure = map(&outcome, "pressure");
    assert!(zone(pressure, "waist").1 > 0.0, "{:?}", pressure.zones);
    let gap = map(&outcome, "gap");
    assert!(
        zone(gap, "left leg").0 > zone(gap, "waist").0,
        "{:?}",
        gap.zones
    );
    for map in &outcome.report.maps {
        let of = |parts: &[seamster::solver::MapPart]| -> f64 {
            parts.iter().map(|part| part.area_m2).sum()
        };
        assert!((of(&map.panels) - of(&map.zones)).abs() < 1e-9);
        assert!(map.error.is_some_and(f64::is_finite), "{}", map.name);
    }
    // Means are by the area on the pattern.
    for (panel, summary) in outcome.mesh.panels.iter().zip(&pressure.panels) {
        let areas = areas(panel);
        let weighed = areas.iter().zip(&panel.maps.pressure_kpa);
        let sum: f64 = weighed.map(|(area, pressure)| area * pressure).sum();
        assert!((sum / areas.iter().sum::<f64>() - summary.mean).abs() < 1e-9);
    }
}

#[test]
fn without_a_body_cloth_has_strain_alone() {
    let cloth = json!({
        "pattern": pattern(vec![rectangle("cloth", 0.2, 0.2)]),
        "seams": [],
        "panels": {"cloth": {"placement": {"at": "origin"}}},
        "avatar": null,
        "pins": [{"panel": "cloth", "corner": 0}, {"panel": "cloth", "corner": 1}],
        "maps": ["strain", "pressure", "gap"],
        "simulate": {"edge_length_m": 0.04},
    });
    let outcome = super::sewn(serde_json::from_value(cloth).expect("a garment"));
    let names: Vec<_> = outcome.report.maps.iter().map(|map| &*map.name).collect();
    assert_eq!(names, ["strain_warp", "strain_weft", "strain_share"]);
    assert!(outcome.mesh.panels[0].maps.gap_mm.is_empty());
    assert!(map(&outcome, "strain_warp").zones.is_empty());
}

#[test]
fn what_is_not_asked_for_is_not_there() {
    let outcome = super::sewn(samples::garment(
        "skirt",
        json!({"simulate": {"edge_length_m": 0.04}}),
    ));
    let report = serde_json::to_value(&outcome.report).expect("plain data");
    assert!(report.get("maps").is_none());
    let mesh = serde_json::to_value(&outcome.mesh).expect("plain data");
    assert!(mesh["panels"][0].get("maps").is_none());
}
