//! Gaps in outlines: small ones are closed, larger ones are faults, each with its size and place.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster_fixtures::dxf::DxfBuilder;

/// Corners of a skirt panel [mm].
const CORNERS: [[f64; 2]; 4] = [
    [-200.0, 0.0],
    [200.0, 0.0],
    [260.0, -600.0],
    [-260.0, -600.0],
];

/// Lines along the panel in an order, each ending `gap` before its corner, as a file rounds them.
fn with_gaps(layer: &str, gap: f64, order: &[usize], decimals: i32) -> DxfBuilder {
    let scale = 10_f64.powi(decimals);
    let rounded = |p: [f64; 2]| p.map(|c| (scale * c).round() / scale);
    let file = DxfBuilder::default().header("$INSUNITS", 70, "4");
    order.iter().fold(file, |file, &i| {
        let (a, b) = (CORNERS[i], CORNERS[(i + 1) % 4]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let end = [0, 1].map(|k| b[k] + (a[k] - b[k]) * gap / length);
        file.line(layer, rounded(a), rounded(end))
    })
}

fn read(file: DxfBuilder) -> Result<Pattern, Faults> {
    import(&file.bytes(), &ImportOptions::default(), &Limits::default())
}

#[test]
fn gaps_up_to_half_a_millimeter_are_closed_and_told_one_by_one() {
    for order in [[0, 1, 2, 3], [0, 2, 1, 3], [3, 1, 0, 2]] {
        for (gap, decimals) in [(0.05, 4), (0.2, 4), (0.5, 4), (0.5, 2)] {
            let pattern = read(with_gaps("0", gap, &order, decimals)).expect("a pattern");
            assert_eq!(
                (pattern.panels.len(), pattern.panels[0].edges.len()),
                (1, 4)
            );
            // The gaps shorten the lines: each corner moves by at most a gap.
            assert!((pattern.panels[0].area_m2 - 0.276).abs() < 4.0 * 0.6 * 1e-3 * gap);
            let [warning] = &pattern.warnings[..] else {
                panic!("{:?}", pattern.warnings);
            };
            assert_eq!(warning.code, "pattern/gap_closed");
            assert!(warning.detail.starts_with("4 gaps"), "{}", warning.detail);
            assert_eq!(warning.detail.matches(" mm at (").count(), 4);
        }
    }
}

#[test]
fn larger_gaps_are_one_fault_with_their_sizes_and_places() {
    for order in [[0, 1, 2, 3], [0, 2, 1, 3], [3, 1, 0, 2]] {
        let faults = read(with_gaps("0", 1.0, &order, 4))
            .expect_err("an open outline")
            .0;
        let [fault] = &faults[..] else {
            panic!("{faults:?}");
        };
        assert_eq!(fault.code, "pattern/open_outline");
        let detail = &fault.detail;
        assert!(detail.contains("open at 4 places"), "{detail}");
        assert_eq!(detail.matches("1.00 mm between (").count(), 4, "{detail}");
        for place in ["(0.1990, 0.0000)", "(0.2000, 0.0000)", "(-0.2590, -0.6000)"] {
            assert!(detail.contains(place), "{detail}");
        }
    }
}

#[test]
fn wide_opening_is_told_with_the_slips_beside_it() {
    let file = with_gaps("0", 1.0, &[0, 1, 2], 4);
    let faults = read(file).expect_err("an open outline").0;
    let detail = &faults[0].detail;
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert!(detail.contains("open at 3 places"), "{detail}");
    assert_eq!(detail.matches("1.00 mm between (").count(), 2, "{detail}");
    assert!(detail.contains("602.89 mm between ("), "{detail}");
}

#[test]
fn piece_that_all_but_closes_beside_others_is_told() {
    let file = with_gaps("0", 1.0, &[0, 1, 2, 3], 4);
    let other = [[500.0, 0.0], [800.0, 0.0], [800.0, 300.0], [500.0, 300.0]];
    let pattern = read(file.run("0", true, &other)).expect("a pattern");
    assert_eq!(pattern.panels.len(), 1);
    let told = pattern
        .warnings
        .iter()
        .find(|w| w.code == "pattern/open_outline");
    let told = told.expect("a warning");
    assert!(told.detail.contains("open at 4 places") && told.detail.contains("left out"));
}
