//! Suggested seams of legs in one piece: leggings, shorts and pajama trousers.

use super::drawn::{suggested, sure};
use seamster::pattern::{Place, PlacementAnchor};
use seamster_fixtures::panels::{leg, rectangle};
use std::collections::BTreeSet;

const SEAMS: [&str; 4] = ["inseam-left", "inseam-right", "crotch-front", "crotch-back"];

/// By a name that says so, by one that says nothing beside a waistband, and by shape alone.
#[test]
fn legs_in_one_piece_are_closed_and_meet_at_the_crotch() {
    for (name, with_band) in [("leg", true), ("ll", true), ("piece 1", false)] {
        for inseam in [0.2, 0.45, 0.72] {
            let mut panels = vec![leg(name, inseam)];
            if with_band {
                panels.push(rectangle("waistband", 0.8, 0.05));
            }
            let found = suggested(panels);
            let ids = sure(&found);
            let told = format!("{name} {inseam}: {ids:?}");
            assert!(SEAMS.iter().all(|id| ids.contains(id)), "{told}");
            let band = ids.iter().any(|id| id.starts_with("waistband"));
            assert_eq!(band, with_band, "{told}");
        }
    }
}

/// The front has the shorter crotch: a leg drawn with it on the left of the drawing, hem down, is
/// the left one, and its mirrored copy the right one.
#[test]
fn the_shorter_crotch_is_in_front() {
    let found = suggested(vec![leg("leg", 0.7)]);
    let at = |id: &str| found.panels[id].placement.at;
    assert_eq!(at("leg"), Some(PlacementAnchor::LegLeft));
    assert_eq!(at("leg~mirror"), Some(PlacementAnchor::LegRight));
    let front = found
        .seams
        .iter()
        .find(|seam| seam.pair.id == "crotch-front");
    let front = front.expect("a seam");
    // On both legs the second edge, from the crotch up to the waist.
    for side in [&front.pair.a, &front.pair.b] {
        let [run] = side.runs() else {
            panic!("{side:?}")
        };
        let ends = [&run.from, &run.to].map(|place| match place {
            Place::Corner(corner) => *corner,
            other => panic!("{other:?}"),
        });
        assert_eq!(BTreeSet::from(ends), BTreeSet::from([1, 2]));
    }
}

/// Many a panel of a jacket looks like a leg: beside others as large that nothing tells of, it is
/// not taken for one unasked.
#[test]
fn a_leg_by_shape_alone_beside_other_large_panels_is_no_sure_one() {
    let others = [[0.25, 0.4], [0.2, 0.5], [0.33, 0.3]];
    let others = others.iter().enumerate();
    let others = others.map(|(k, [x, y])| rectangle(&format!("piece {}", k + 2), *x, *y));
    let found = suggested([vec![leg("piece 1", 0.72)], others.collect()].concat());
    let ids = sure(&found);
    assert!(SEAMS.iter().all(|id| !ids.contains(id)), "{ids:?}");
}
