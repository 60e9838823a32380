//! What carries a garment is sewn before what hangs from it: a wide skirt drew its band over the
//! hip while that was open.

use super::sewn;
use seamster::config::Limits;
use seamster::fit::{AvatarRef, Garment, PatternRef};
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster::scene::DressForm;
use seamster::solver::SolverOptions;
use serde_json::{Map, Value, json};

/// Gores round the body.
const GORES: usize = 10;
/// Girth of the band, and of the body's waist \[cm\].
const BAND: f64 = 84.0;
/// Height of the band's lower edge when it is placed, in the body's waist \[cm\].
const BAND_BOTTOM: f64 = 98.0;
/// Distance of the gores from the body's axis when they are placed \[cm\].
const GORES_AWAY: f64 = 78.0;

/// Returns the edges of a panel of so many corners.
fn edges(corners: usize) -> Value {
    let edge = |i| json!({"endpoints": [i, (i + 1) % corners]});
    (0..corners).map(edge).collect()
}

/// Half of the band, its lower edge in as many parts as there are gores beneath.
fn band(turn: f64, z: f64) -> Value {
    let (parts, width) = (GORES / 2, BAND / 2.0);
    let below = (0..=parts).map(|i| [width * (i as f64 / parts as f64 - 0.5), 0.0]);
    let above = [[width / 2.0, 12.0], [-width / 2.0, 12.0]];
    let corners: Vec<[f64; 2]> = below.chain(above).collect();
    json!({
        "edges": edges(corners.len()),
        "vertices": corners,
        "translation": [0.0, BAND_BOTTOM, z],
        "rotation": [0.0, turn, 0.0],
    })
}

/// A gore nearly half a meter wide at its hem, which stands at `angle` in degrees from the front.
fn gore(angle: f64) -> Value {
    let (top, around) = (BAND / GORES as f64 / 2.0, angle.to_radians());
    json!({
        "edges": edges(4),
        "vertices": [[-24.3, 0.0], [24.3, 0.0], [top, 40.0], [-top, 40.0]],
        "translation": [GORES_AWAY * around.sin(), 53.0, GORES_AWAY * around.cos()],
        "rotation": [0.0, angle, 0.0],
    })
}

/// A skirt of gores on a band, as a specification of `GarmentCode`.
fn skirt() -> Pattern {
    let half = GORES / 2;
    let edge = |panel: &str, edge: usize| json!({"panel": panel, "edge": edge});
    let mut panels = Map::new();
    panels.insert("band_front".into(), band(0.0, 20.0));
    panels.insert("band_back".into(), band(180.0, -15.0));
    let mut stitches = vec![
        [edge("band_front", half), edge("band_back", half + 2)],
        [edge("band_front", half + 2), edge("band_back", half)],
    ];
    for k in 0..GORES {
        let [this, next] = [k, (k + 1) % GORES].map(|k| format!("gore_{k}"));
        let angle = 360.0 / GORES as f64 * (k as f64 + 0.5) - 90.0;
        panels.insert(this.clone(), gore(angle));
        stitches.push([edge(&this, 1), edge(&next, 3)]);
        let band = ["band_front", "band_back"][k / half];
        stitches.push([edge(&this, 2), edge(band, k % half)]);
    }
    let specification = json!({
        "pattern": {"panels": panels, "stitches": stitches},
        "properties": {"units_in_meter": 100},
    });
    let bytes = specification.to_string().into_bytes();
    import(&bytes, &ImportOptions::default(), &Limits::default()).expect("a specification")
}

#[test]
fn a_wide_skirt_hangs_from_its_band_at_the_waist() {
    let pattern = skirt();
    let body = DressForm::new(1.72, 0.998, 0.843, 1.035);
    let seams = json!({ "seams": pattern.seams });
    let report = sewn(Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        avatar: Some(AvatarRef::form(body)),
        simulate: SolverOptions {
            edge_length_m: 0.085,
            tolerance: 0.1,
            ..SolverOptions::default()
        },
        ..serde_json::from_value(seams).expect("a garment needs its seams alone")
    })
    .report;
    let openings = report.support.openings.iter();
    let top = openings.map(|o| o.height_m).fold(0.0, f64::max);
    // The band keeps the height that it was placed at, give or take its own width.
    assert!(0.01 * BAND_BOTTOM < top, "its top edge is at {top:.2} m");
    assert!(report.seam_gap_max_m < 1e-3);
    // The user is told which panels carry, and how to choose another order.
    let told = report.warnings.iter().find(|warning| {
        let code = serde_json::to_value(warning.code.clone()).expect("a code is a string");
        code == "placement/sewn_first"
    });
    let told = told.expect("the band is sewn first");
    assert!(
        told.detail.starts_with("`band_front` and `band_back`"),
        "{}",
        told.detail
    );
}
