//! Girths of tubes of cloth whose lengths are known.

use super::*;
use crate::config::Limits;
use crate::fit::{Garment, PatternRef, ShippedAssets, resolve, scene, support};
use crate::pattern::{self, ImportOptions, Panel, Pattern};
use crate::progress::CancelToken;
use crate::solver::Context;
use serde_json::json;

/// Two panels of 50 cm by a length \[m\] in cotton poplin, placed at `front` and `back`, so much
/// lower \[m\], and sewn along both sides, on a body with these measures.
fn tube([front, back]: [&str; 2], [length, lower]: [f64; 2], form: serde_json::Value) -> Scene {
    let limits = Limits::default();
    let bytes = include_bytes!("../../../static/samples/top.dxf");
    let any = pattern::import(bytes, &ImportOptions::default(), &limits).expect("a pattern");
    let panels = ["one", "other"].map(|id| Panel::rectangle(id, [0.5, length]));
    let placement = |at: &str| json!({ "placement": { "at": at, "offset_m": [0.0, -lower, 0.0] } });
    let seam = |id: &str, [from, to]: [usize; 2], [back_from, back_to]: [usize; 2]| {
        json!({
            "id": id,
            "a": { "panel": "one", "from": from, "to": to },
            "b": { "panel": "other", "from": back_from, "to": back_to },
        })
    };
    // Seen from outside, the left of the front is sewn to the right of the back.
    let stated = json!({
        "schema": "seamster/garment/1",
        "panels": { "one": placement(front), "other": placement(back) },
        "seams": [seam("left", [0, 1], [3, 2]), seam("right", [3, 2], [0, 1])],
        "avatar": { "form": form },
        "default_fabric": "cotton-poplin",
        "simulate": { "edge_length_m": 0.05 },
    });
    let garment = Garment {
        pattern: Some(PatternRef::Whole(Box::new(Pattern {
            panels: panels.to_vec(),
            ..any
        }))),
        ..serde_json::from_value(stated).expect("a garment")
    };
    let resolved = resolve(garment, &ShippedAssets, &limits).expect("it is right");
    let context = Context {
        cpu_s: &|| 0.0,
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits: &limits,
    };
    scene(&resolved, &context).expect("it can be assembled")
}

fn skirt(hip_m: f64) -> Scene {
    let form = json!({ "height_m": 1.7, "bust_m": 0.95, "waist_m": 0.8, "hip_m": hip_m });
    tube(["skirt_front", "skirt_back"], [0.6, 0.0], form)
}

/// A tube of 100 cm in cloth that gives 8 % along its weft is large enough for a hip of 105 cm and
/// too small for one of 112.
#[test]
fn a_skirt_is_too_small_for_a_hip_that_its_cloth_does_not_reach_round() {
    assert!(too_small(&skirt(1.05)).is_none());
    let told = too_small(&skirt(1.12)).expect("4 cm are lacking");
    let why =
        "round the hip it measures 100 cm and the body 112 cm, and its cloth gives 8 % (8 cm)";
    assert!(told.detail.contains(why), "{}", told.detail);
    assert!(!told.detail.contains("waist"), "{}", told.detail);
}

/// A band of 100 cm that starts at a hip of 120 cm rides up to a waist of 80; one as long as a
/// skirt is too small.
#[test]
fn a_band_that_rides_up_is_not_too_small() {
    let start = |length| {
        let form = json!({ "height_m": 1.7, "bust_m": 1.0, "waist_m": 0.8, "hip_m": 1.2 });
        tube(["skirt_front", "skirt_back"], [length, 0.18], form)
    };
    assert!(too_small(&start(0.1)).is_none());
    assert!(too_small(&start(0.4)).is_some());
}

/// An open front is not a girth.
#[test]
fn a_garment_that_is_open_is_not_too_small() {
    let mut open = skirt(1.12);
    open.mesh.stitches.retain(|stitch| stitch.seam == 0);
    assert!(too_small(&open).is_none());
}

/// A tube of 100 cm slides down a hip of 90 cm, whatever the waist.
#[test]
fn a_skirt_whose_top_edge_is_wider_than_the_hip_is_too_large() {
    assert!(support::too_large(&skirt(1.0)).is_none());
    let told = support::too_large(&skirt(0.9)).expect("it slides down");
    assert!(
        told.detail
            .contains("its top edge measures 100 cm and the body 90 cm"),
        "{}",
        told.detail
    );
}

/// The start stretched to the sides by a share is stretched by that round the trunk.
#[test]
fn cloth_is_stretched_further_than_it_gives_beyond_eight_hundredths() {
    let scene = skirt(1.0);
    let wider = |share: f64| -> Vec<Vector3<f64>> {
        let start = scene.start.iter();
        start
            .map(|p| Vector3::new(p.x * (1.0 + share), p.y, p.z))
            .collect()
    };
    assert!(overstretched(&scene, &wider(0.07)).is_none());
    let told = overstretched(&scene, &wider(0.12)).expect("more than 8 %");
    assert!(
        told.contains("by 12 % round the trunk and gives 8 %"),
        "{told}"
    );
}
