//! Garments that are laid round the body before they hang: circle skirts and legs in one piece,
//! ponchos.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster::fit::{Garment, PatternRef};
use seamster::pattern::Panel;
use seamster::scene::DressForm;
use seamster::solver::DrapeReport;
use seamster_fixtures::panels::{leg, panel_of, pattern, polygon, rectangle, with_hole};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Waist of the default form, with ease \[m\].
const WAIST: f64 = 0.76;

/// Sews panels with these fields of a garment.
fn sewn(panels: Vec<Panel>, fields: Value) -> DrapeReport {
    let mut garment =
        json!({"default_fabric": "cotton-poplin", "avatar": {"form": DressForm::default()}});
    let all = garment.as_object_mut().unwrap();
    all.extend(fields.as_object().unwrap().clone());
    let mut garment: Garment = serde_json::from_value(garment).unwrap();
    garment.pattern = Some(PatternRef::Whole(Box::new(pattern(panels))));
    super::sewn(garment).report
}

fn assert_worn(report: &DrapeReport, what: &str) {
    let good = report.good.as_ref().unwrap();
    let why = (&report.why, &good.because);
    assert!(report.converged && good.ok, "{what}: {why:?}");
    assert_eq!(report.support.ok, Some(true), "{what}");
}

/// A ring sector of this angle in degrees whose inner arc is as long as the waist, its middle below
/// the center: hem, side, waist, side.
fn sector(degrees: f64, long: f64) -> Panel {
    let angle = degrees.to_radians();
    let inner = WAIST / angle;
    let point = |share: f64, radius: f64| {
        let at = (share - 0.5) * angle - FRAC_PI_2;
        [radius * at.cos(), radius * at.sin()]
    };
    let arc = |radius: f64| -> Vec<[f64; 2]> {
        let shares = (0..=60).map(|k| f64::from(k) / 60.0);
        shares.map(|share| point(share, radius)).collect()
    };
    let mut hem = arc(inner + long);
    hem.reverse();
    panel_of(
        "skirt",
        &[
            hem,
            vec![point(0.0, inner + long), point(0.0, inner)],
            arc(inner),
            vec![point(1.0, inner), point(1.0, inner + long)],
        ],
    )
}

/// Rolled on a cylinder, sectors of half a turn and more were sewn beside the body or through it.
#[test]
fn circle_skirts_in_one_piece_are_worn() {
    for degrees in [120.0, 270.0] {
        let panels = vec![sector(degrees, 0.35), rectangle("waistband", WAIST, 0.04)];
        let simulate = json!({"edge_length_m": 0.04});
        let report = sewn(panels, json!({"seams": "suggest", "simulate": simulate}));
        assert_worn(&report, &format!("{degrees} degrees"));
    }
}

/// Leggings of two panels and a waistband: rolled about the legs from the start.
#[test]
fn leggings_of_legs_in_one_piece_are_worn() {
    let panels = vec![leg("leg", 0.62), rectangle("waistband", WAIST, 0.04)];
    let simulate = json!({"edge_length_m": 0.03});
    let report = sewn(panels, json!({"seams": "suggest", "simulate": simulate}));
    assert_worn(&report, "leggings");
}

#[test]
fn a_poncho_laid_level_hangs_from_the_shoulders() {
    let hole: Vec<[f64; 2]> = (0..24)
        .map(|k| TAU * f64::from(k) / 24.0)
        .map(|angle| [0.5 + 0.12 * angle.cos(), 0.5 + 0.12 * angle.sin()])
        .collect();
    let square = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let poncho = with_hole(polygon("poncho", &square), &hole);
    let placement = json!({
        "at": "origin", "offset_m": [0, 1.44, 0], "rotate_deg": [-90, 0, 0], "wrap": "flat",
    });
    let fields = json!({
        "seams": [],
        "panels": {"poncho": {"placement": placement}},
        "simulate": {"edge_length_m": 0.04},
    });
    let report = sewn(vec![poncho], fields);
    assert_worn(&report, "poncho");
    // What the mean height of the cloth was taken for before.
    assert!(report.support.because.contains("lower than it was laid"));
}
