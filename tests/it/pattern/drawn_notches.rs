//! Import of notches that are drawn into outlines.

use super::read::{imported, imported_with, warnings};
use seamster::pattern::{DrawnNotches, ImportOptions, NotchKind, Pattern};
use seamster_fixtures::dxf::DxfBuilder;

/// A front of 300 by 400 mm whose hem has a detour.
fn front(detour: &[[f64; 2]]) -> DxfBuilder {
    let corners = [[300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let outline = [&[[0.0, 0.0]], detour, &corners].concat();
    let file = DxfBuilder::metric()
        .block("FRONT")
        .text("1", "Piece Name: FRONT");
    file.run("1", true, &outline)
}

fn notches(pattern: &Pattern) -> Vec<(NotchKind, f64)> {
    let notches = pattern.panels[0].notches.iter();
    notches
        .map(|n| (n.kind, (1e6 * n.at).round() / 1e6))
        .collect()
}

#[test]
fn v_slit_and_castle_are_marks() {
    let shapes: [(&[[f64; 2]], NotchKind); 3] = [
        (&[[97.0, 0.0], [100.0, 5.0], [103.0, 0.0]], NotchKind::V),
        (&[[100.0, 0.0], [100.0, 6.0], [100.0, 0.0]], NotchKind::Slit),
        (
            &[[98.0, 0.0], [98.0, 4.0], [102.0, 4.0], [102.0, 0.0]],
            NotchKind::Castle,
        ),
    ];
    for (detour, kind) in shapes {
        let pattern = imported(front(detour));
        assert_eq!(warnings(&pattern, "pattern/drawn_notches"), 1);
        assert_eq!(pattern.panels[0].corners.len(), 4, "{kind:?}");
        // 100 of 300 mm; the hem runs from right to left, clockwise.
        assert_eq!(notches(&pattern), [(kind, 0.666_667)]);
    }
    let options = ImportOptions {
        notches: DrawnNotches::Cloth,
        ..ImportOptions::default()
    };
    let pattern = imported_with(front(shapes[0].0), &options);
    assert_eq!(
        (pattern.warnings.len(), pattern.panels[0].corners.len()),
        (0, 7)
    );
}

#[test]
fn half_a_notch_at_the_fold_is_a_whole_one() {
    let corners = [
        [0.0, 5.0],
        [3.0, 0.0],
        [300.0, 0.0],
        [300.0, 400.0],
        [0.0, 400.0],
    ];
    let file = DxfBuilder::metric()
        .block("FRONT")
        .text("1", "Piece Name: FRONT");
    let file = file
        .run("1", true, &corners)
        .line("6", [0.0, 5.0], [0.0, 400.0]);
    let pattern = imported(file);
    let panel = &pattern.panels[0];
    assert!((panel.area_m2 - 0.24).abs() < 1e-9 && panel.corners.len() == 4);
    assert_eq!(notches(&pattern), [(NotchKind::V, 0.5)]);
    assert_eq!(warnings(&pattern, "pattern/drawn_notches"), 1);
}

#[test]
fn darts_and_marks_beside_them_stay() {
    let dart = [[90.0, 0.0], [100.0, 80.0], [110.0, 0.0]];
    assert_eq!(imported(front(&dart)).panels[0].corners.len(), 7);
    let drawn = front(&[[97.0, 0.0], [100.0, 5.0], [103.0, 0.0]]);
    let pattern = imported(drawn.point("4", [200.0, 0.0]));
    assert_eq!(warnings(&pattern, "pattern/drawn_notches"), 0);
    assert_eq!(pattern.panels[0].corners.len(), 7);
}
