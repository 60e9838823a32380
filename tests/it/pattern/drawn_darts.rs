//! Import of darts that are drawn as lines inside an outline.

use super::read::{imported, imported_with, warnings};
use seamster::pattern::{DrawnDarts, ImportOptions, Pattern};
use seamster_fixtures::dxf::DxfBuilder;

/// A front of 300 by 500 mm.
fn front() -> DxfBuilder {
    let outline = [[0.0, 0.0], [0.0, 500.0], [300.0, 500.0], [300.0, 0.0]];
    DxfBuilder::metric()
        .block("FRONT")
        .text("1", "Piece Name: FRONT")
        .run("1", true, &outline)
}

/// The legs of a dart of 30 by 120 mm at the right side, 300 to 330 mm up.
const MOUTH: [[f64; 2]; 2] = [[300.0, 300.0], [300.0, 330.0]];
const TIP: [f64; 2] = [180.0, 315.0];

fn area_mm2(pattern: &Pattern) -> f64 {
    (1e6 * pattern.panels[0].area_m2).round()
}

/// Corners of the outline, and the two edges that meet at the tip by their lengths \[mm\].
fn cut(pattern: &Pattern) -> (usize, Vec<f64>) {
    let panel = &pattern.panels[0];
    let is_tip = |i: usize| {
        let corner = panel.corners[i];
        (1e3 * corner.x - TIP[0]).hypot(1e3 * corner.y - TIP[1]) < 1e-6
    };
    let legs = panel
        .edges
        .iter()
        .filter(|e| is_tip(e.from) || is_tip(e.to));
    let lengths = legs.map(|e| (1e6 * e.length_m).round() / 1e3).collect();
    (panel.corners.len(), lengths)
}

#[test]
fn legs_become_edges_however_they_are_drawn() {
    let [low, high] = MOUTH;
    let beyond = |end: [f64; 2]| {
        let on = |k: usize| end[k] + 0.1 * (end[k] - TIP[k]);
        [on(0), on(1)]
    };
    let files = [
        front().run("8", false, &[low, TIP, high]),
        front().run("8", false, &[high, TIP, low]),
        front().run("8", true, &[low, TIP, high]),
        front().line("8", low, TIP).line("8", high, TIP),
        front().run("8", false, &[beyond(low), TIP, beyond(high)]),
    ];
    let leg = (1e3 * 120.0_f64.hypot(15.0)).round() / 1e3;
    for file in files {
        let pattern = imported(file);
        assert_eq!(warnings(&pattern, "pattern/drawn_darts"), 1);
        assert_eq!(cut(&pattern), (7, vec![leg, leg]));
        assert_eq!(area_mm2(&pattern), 300.0 * 500.0 - 0.5 * 30.0 * 120.0);
        assert!(pattern.panels[0].internal_lines.is_empty());
    }
}

#[test]
fn legs_that_end_beside_the_outline_reach_it() {
    let legs = [[298.0, 300.0], TIP, [298.0, 330.0]];
    let pattern = imported(front().run("8", false, &legs));
    assert_eq!(cut(&pattern).0, 7);
    let far = [[295.0, 300.0], TIP, [295.0, 330.0]];
    let pattern = imported(front().run("8", false, &far));
    assert_eq!(
        (cut(&pattern).0, pattern.panels[0].internal_lines.len()),
        (4, 1)
    );
}

/// The outline is peaked across the mouth, as a dart folds: the peak goes.
#[test]
fn a_peak_across_the_mouth_goes_with_it() {
    let peaked = [
        [0.0, 0.0],
        [0.0, 500.0],
        [300.0, 500.0],
        MOUTH[1],
        [306.0, 315.0],
        MOUTH[0],
        [300.0, 0.0],
    ];
    let file = DxfBuilder::metric()
        .block("FRONT")
        .text("1", "Piece Name: FRONT")
        .run("1", true, &peaked)
        .run("8", false, &[MOUTH[0], TIP, MOUTH[1]]);
    let pattern = imported(file);
    assert_eq!(cut(&pattern).0, 7);
    assert_eq!(area_mm2(&pattern), 300.0 * 500.0 - 0.5 * 30.0 * 120.0);
}

#[test]
fn a_dart_inside_a_panel_becomes_a_hole() {
    let diamond = [
        [150.0, 150.0],
        [162.0, 220.0],
        [150.0, 290.0],
        [138.0, 220.0],
    ];
    let pattern = imported(front().run("8", true, &diamond));
    assert_eq!(warnings(&pattern, "pattern/drawn_darts"), 1);
    assert_eq!(pattern.panels[0].holes.len(), 1);
    assert_eq!(area_mm2(&pattern), 300.0 * 500.0 - 0.5 * 24.0 * 140.0);
}

#[test]
fn turn_points_name_the_corners_of_a_dart_too() {
    let corners = [[0.0, 0.0], [0.0, 500.0], [300.0, 500.0], [300.0, 0.0]];
    let file = front().run("8", false, &[MOUTH[0], TIP, MOUTH[1]]);
    let file = corners.into_iter().fold(file, |file, p| file.point("2", p));
    assert_eq!(cut(&imported(file)).0, 7);
}

#[test]
fn darts_stay_lines_where_the_caller_says_so() {
    let options = ImportOptions {
        darts: DrawnDarts::Lines,
        ..ImportOptions::default()
    };
    let file = front().run("8", false, &[MOUTH[0], TIP, MOUTH[1]]);
    let pattern = imported_with(file, &options);
    assert_eq!(warnings(&pattern, "pattern/drawn_darts"), 0);
    assert_eq!(
        (cut(&pattern).0, pattern.panels[0].internal_lines.len()),
        (4, 1)
    );
}

/// A neckline that opens by more than its depth, legs of two lengths, a welt, a pocket, a chevron
/// that touches no edge, a fold line, and a dart whose tip lies outside.
#[test]
fn other_lines_stay_lines() {
    let lines: [(bool, &[[f64; 2]]); 7] = [
        (false, &[[80.0, 500.0], [150.0, 400.0], [220.0, 500.0]]),
        (false, &[[300.0, 300.0], TIP, [300.0, 400.0]]),
        (
            true,
            &[[80.0, 200.0], [220.0, 200.0], [220.0, 212.0], [80.0, 212.0]],
        ),
        (
            true,
            &[
                [80.0, 200.0],
                [150.0, 170.0],
                [220.0, 200.0],
                [220.0, 300.0],
                [80.0, 300.0],
            ],
        ),
        (false, &[[200.0, 300.0], [100.0, 315.0], [200.0, 330.0]]),
        (false, &[[0.0, 250.0], [300.0, 250.0]]),
        (false, &[[300.0, 300.0], [420.0, 315.0], [300.0, 330.0]]),
    ];
    for (closed, line) in lines {
        let pattern = imported(front().run("8", closed, line));
        assert_eq!(warnings(&pattern, "pattern/drawn_darts"), 0, "{line:?}");
        let panel = &pattern.panels[0];
        assert_eq!((panel.corners.len(), panel.holes.len()), (4, 0), "{line:?}");
    }
}
