//! Seams of garments that others drafted, against the truth that their files state.

use seamster_fixtures::truth::seam_truth::{StitchCounts, garments, row, table};

#[test]
fn true_seams_are_accepted_and_reversed_ones_are_found() {
    let Some(data) = seamster_fixtures::drafts::data("true seams") else {
        return;
    };
    let rows: Vec<StitchCounts> = garments(&data).iter().map(row).collect();
    println!("{}", table(&rows));
    assert_eq!(rows.len(), 13, "eight drawings and five specifications");
    for row in &rows {
        let n = row.stitches;
        assert!(n > 0, "{row:?}");
        assert_eq!(row.accepted, [n, n], "{row:?}");
        assert_eq!(row.refused, n, "{row:?}");
        assert_eq!(row.refused_on_cycle, row.on_cycle, "{row:?}");
        assert_eq!(row.likely_reversed, n - row.on_cycle, "{row:?}");
        assert_eq!(row.bridges_found, row.bridges, "{row:?}");
        assert_eq!(row.auto_right, n, "{row:?}");
        assert_eq!(row.false_warnings, 0, "{row:?}");
    }
}
