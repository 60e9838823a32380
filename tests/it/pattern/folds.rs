//! Import of pieces on the fold: two folds, and holes that lie on one.

use super::read::{imported, imported_with, warnings};
use seamster::pattern::{ImportOptions, Panel, Unfold};
use seamster_fixtures::dxf::DxfBuilder;
use std::f64::consts::PI;

/// A quarter of a rectangle of 600 by 800 mm with its lower left corner at the origin.
const QUARTER: [[f64; 2]; 4] = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];

fn piece(outline: &[[f64; 2]]) -> DxfBuilder {
    let file = DxfBuilder::metric().block("P").text("1", "Piece Name: P");
    file.run("1", true, outline)
}

fn only(file: DxfBuilder) -> Panel {
    let pattern = imported(file);
    assert_eq!(pattern.warnings, []);
    assert_eq!(pattern.panels.len(), 1);
    pattern.panels[0].clone()
}

fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn two_folds_that_meet_unfold_a_quarter() {
    let files = [
        piece(&QUARTER)
            .line("6", [0.0, 0.0], [0.0, 400.0])
            .line("6", [0.0, 0.0], [300.0, 0.0]),
        piece(&QUARTER)
            .line("6", [300.0, 0.0], [0.0, 0.0])
            .line("6", [0.0, 400.0], [0.0, 0.0]),
        piece(&QUARTER).run("6", false, &[[0.0, 400.0], [0.0, 0.0], [300.0, 0.0]]),
    ];
    for file in files {
        let panel = only(file.point("4", [300.0, 100.0]).point("13", [100.0, 50.0]));
        assert!(panel.unfolded && is_close(panel.area_m2, 0.48));
        assert!(is_close(panel.drawn_area_m2, 0.12) && is_close(panel.perimeter_m, 2.8));
        assert_eq!(panel.corners.len(), 4);
        assert_eq!((panel.notches.len(), panel.drill_holes.len()), (4, 4));
    }
}

#[test]
fn quarter_of_a_ring_is_a_ring() {
    const STEPS: u32 = 24;
    let arc = |radius: f64, back: bool| {
        (0..=STEPS).map(move |i| {
            let i = if back { STEPS - i } else { i };
            let (sin, cos) = (0.5 * PI * f64::from(i) / f64::from(STEPS)).sin_cos();
            [radius * cos, radius * sin]
        })
    };
    let outline: Vec<_> = arc(150.0, false).chain(arc(600.0, true)).collect();
    let file =
        piece(&outline)
            .line("6", [150.0, 0.0], [600.0, 0.0])
            .line("6", [0.0, 150.0], [0.0, 600.0]);
    let panel = only(file);
    // A regular polygon of 96 corners.
    let share = 2.0 * f64::from(STEPS) * (0.5 * PI / f64::from(STEPS)).sin();
    assert!(is_close(panel.area_m2, share * (0.6 * 0.6 - 0.15 * 0.15)));
    assert_eq!(panel.holes.len(), 1);
    let hole: f64 = panel.holes[0].edges.iter().map(|edge| edge.length_m).sum();
    assert!((hole - 2.0 * PI * 0.15).abs() < 1e-3);
}

#[test]
fn folds_that_would_go_on_are_told() {
    let parallel = || {
        piece(&QUARTER)
            .line("6", [0.0, 0.0], [0.0, 400.0])
            .line("6", [300.0, 0.0], [300.0, 400.0])
    };
    let pattern = imported(parallel());
    assert_eq!(warnings(&pattern, "pattern/fold_ignored"), 1);
    assert!(is_close(pattern.panels[0].area_m2, 0.24));
    let options = ImportOptions {
        unfold: Unfold::None,
        ..ImportOptions::default()
    };
    let pattern = imported_with(parallel(), &options);
    assert_eq!(pattern.warnings, []);
    assert!(is_close(pattern.panels[0].area_m2, 0.12));
    let slanting = piece(&[[0.0, 0.0], [300.0, 0.0], [0.0, 400.0]])
        .line("6", [0.0, 0.0], [0.0, 400.0])
        .line("6", [300.0, 0.0], [0.0, 400.0]);
    let pattern = imported(slanting);
    assert_eq!(warnings(&pattern, "pattern/fold_ignored"), 1);
    assert!(is_close(pattern.panels[0].area_m2, 0.12));
    let twice =
        piece(&QUARTER)
            .line("6", [0.0, 0.0], [0.0, 400.0])
            .line("6", [0.0, 300.0], [0.0, 100.0]);
    assert!(is_close(only(twice).area_m2, 0.24));
}

#[test]
fn hole_on_the_fold_is_one() {
    let half = [[0.0, 150.0], [60.0, 150.0], [60.0, 250.0], [0.0, 250.0]];
    let whole = [[-60.0, 150.0], [60.0, 150.0], [60.0, 250.0], [-60.0, 250.0]];
    let on_fold = || piece(&QUARTER).line("6", [0.0, 0.0], [0.0, 400.0]);
    let files = [
        on_fold().run("11", true, &half),
        on_fold().run("11", false, &half),
        on_fold().run("11", true, &whole),
    ];
    for file in files {
        let panel = only(file);
        assert_eq!(panel.holes.len(), 1);
        assert!(is_close(panel.area_m2, 0.24 - 0.012));
    }
    let beside = [[50.0, 150.0], [60.0, 150.0], [60.0, 250.0], [50.0, 250.0]];
    assert_eq!(only(on_fold().run("11", true, &beside)).holes.len(), 2);
}
