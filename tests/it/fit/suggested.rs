//! Garments that leave their seams to the service: what is sure enough is sewn, offers are not.

use seamster::config::Limits;
use seamster::fault::{Faults, SeamCode, Warning};
use seamster::fit::{self, Garment, PatternRef, ResolvedGarment, ShippedAssets};
use seamster::pattern::{Panel, Pattern};
use seamster::seam::suggest::suggest;
use seamster_fixtures::panels::{pattern, polygon};
use serde_json::json;

/// Half of a bodice with straight edges, its side on the left and its center so high on the right.
fn half(id: &str, center: f64) -> Panel {
    polygon(
        id,
        &[
            [0.0, 0.0],
            [0.0, 0.40],
            [0.05, 0.46],
            [0.05, 0.60],
            [0.18, 0.64],
            [0.22, center + 0.01],
            [0.26, center],
            [0.26, 0.0],
        ],
    )
}

/// The other half of such a panel, its side on the right.
fn other_half(id: &str, center: f64) -> Panel {
    let mut corners: Vec<[f64; 2]> = half(id, center)
        .corners
        .iter()
        .map(|corner| [-corner.x, corner.y])
        .collect();
    corners.reverse();
    polygon(id, &corners)
}

fn resolved(pattern: Pattern) -> Result<ResolvedGarment, Faults> {
    let asked = json!({"seams": "suggest", "avatar": null, "simulate": {"edge_length_m": 0.03}});
    let garment = Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        ..serde_json::from_value(asked).expect("a garment")
    };
    fit::resolve(garment, &ShippedAssets, &Limits::default())
}

/// A top whose front halves differ so much at the center that their seam is an offer.
fn top_with_an_offer() -> Pattern {
    pattern(vec![
        half("front_right", 0.55),
        other_half("front_left", 0.47),
        half("back", 0.60),
    ])
}

#[test]
fn offers_are_left_out_of_a_garment_and_told() {
    let pattern = top_with_an_offer();
    let found = suggest(&pattern, &Limits::default());
    let offers: Vec<&str> = found
        .seams
        .iter()
        .filter(|seam| seam.is_offer())
        .map(|seam| seam.pair.id.as_str())
        .collect();
    assert_eq!(offers, ["centre-front"], "{found:?}");

    let garment = resolved(pattern).expect("sides and shoulders are sure");
    assert_eq!(garment.suggested().len(), found.seams.len() - 1);
    assert!(
        garment
            .suggested()
            .iter()
            .all(|seam| seam.confidence >= 0.5)
    );
    let told = |w: &&Warning| w.code == SeamCode::OfferNotSewn;
    let told: Vec<&Warning> = garment.warnings().iter().filter(told).collect();
    let [warning] = told[..] else {
        panic!("one warning: {:?}", garment.warnings());
    };
    for part in ["`centre-front`", "front_left and front_right", "`seams`"] {
        assert!(warning.detail.contains(part), "{}", warning.detail);
    }
}

#[test]
fn garment_of_offers_alone_is_refused_with_the_reasons() {
    // A sleeve whose outline is none: without it the garment is another one.
    let misshapen = polygon("sleeve", &[[0.0, 0.0], [0.1, 0.4], [0.2, 0.0]]);
    let pattern = pattern(vec![half("front", 0.55), half("back", 0.60), misshapen]);
    let found = suggest(&pattern, &Limits::default());
    assert!(!found.seams.is_empty() && found.seams.iter().all(|seam| seam.is_offer()));

    let Faults(faults) = resolved(pattern).expect_err("nothing is sure");
    let [fault] = &faults[..] else {
        panic!("one fault: {faults:?}");
    };
    assert_eq!(fault.code.to_string(), "seam/none_suggested");
    for part in ["`sleeve`", "`side-left`", "below 0.5"] {
        assert!(fault.detail.contains(part), "{}", fault.detail);
    }
    let fix = fault.fix.as_deref().unwrap_or_default();
    assert!(
        fix.contains("list the seams") && fix.contains("accept offers"),
        "{fix}"
    );
}

#[test]
fn accepted_offers_are_sewn_like_any_listed_seam() {
    let pattern = top_with_an_offer();
    let found = suggest(&pattern, &Limits::default());
    let pairs: Vec<_> = found.seams.iter().map(|seam| &seam.pair).collect();
    let asked = json!({"seams": pairs, "avatar": null, "simulate": {"edge_length_m": 0.03}});
    let garment = Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        ..serde_json::from_value(asked).expect("a garment")
    };
    let garment = fit::resolve(garment, &ShippedAssets, &Limits::default());
    let garment = garment.expect("offers can be sewn with the others");
    let told = garment.warnings().iter().map(|w| w.code.to_string());
    assert!(told.into_iter().all(|code| code != "seam/offer_not_sewn"));
}
