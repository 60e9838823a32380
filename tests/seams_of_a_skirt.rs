//! A skirt that GarmentCode drafted and exported, with the stitches that its own file states.
//!
//! A stitch names two edges by their number along the drawn loops; the start of the one meets the end of the other.
//! Front and back are drawn in one view (seen from the front), so their loops run opposite ways round and their faces differ.

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Match, Panel, Pattern, Place, Run, SeamPair, Side, import};
use seamster::seam::{Face, SeamCheck, check};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::PathBuf;

const NAME: &str = "gc_pencil_skirt__r12_aama";

/// Corners may be off by the rounding of the file's figures \[m\].
const SAME_PLACE_M: f64 = 1e-4;

/// The data folder; where there is none, says that `left_out` tests are left out.
fn data(left_out: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("SEAMSTER_TEST_DATA is not set: 1 test left out ({left_out})");
    }
    folder
}

fn skirt(folder: PathBuf) -> (Pattern, Vec<SeamPair>) {
    let folder = folder.join("dxf");
    let bytes = std::fs::read(folder.join(format!("{NAME}.dxf"))).expect("the data folder has it");
    let pattern = import(&bytes, &ImportOptions::default(), &Limits::default())
        .expect("the file is one that must import");
    let truth = std::fs::read(folder.join(format!("{NAME}.seams.json"))).expect("the data has it");
    let truth: Value = serde_json::from_slice(&truth).expect("the truth is JSON");
    let stitches = truth["stitches"].as_array().expect("a list of stitches");
    let pairs = stitches.iter().enumerate().map(|(i, stitch)| SeamPair {
        id: format!("stitch-{i:02}"),
        a: Side::One(run(&pattern, &truth, &stitch[0])),
        b: Side::One(turned(&run(&pattern, &truth, &stitch[1]))),
        matching: Match::AsPicked,
        stage: 0,
        gather: false,
        layered: false,
        allow_twist: false,
    });
    let pairs = pairs.collect();
    (pattern, pairs)
}

/// The run along a drawn edge, from its start to its end as drawn.
fn run(pattern: &Pattern, truth: &Value, end: &Value) -> Run {
    let name = end["panel"].as_str().expect("a name");
    let index = usize::try_from(end["edge"].as_u64().expect("an index")).expect("a small one");
    let panel = pattern
        .panels
        .iter()
        .find(|panel| panel.name.eq_ignore_ascii_case(name));
    let panel = panel.expect("the panel is in the pattern");
    let edges = &truth["panels"][name]["edges"];
    let corner = |which: &str| {
        let point = &edges[index][which];
        corner_at(
            panel,
            [0, 1].map(|i| point[i].as_f64().expect("a figure") / 1e3),
        )
    };
    Run {
        panel: panel.id.clone(),
        from: Place::Corner(corner("a_local_mm")),
        to: Place::Corner(corner("b_local_mm")),
        direction: None,
    }
}

fn corner_at(panel: &Panel, [x, y]: [f64; 2]) -> usize {
    panel
        .corners
        .iter()
        .position(|corner| (corner.x - x).hypot(corner.y - y) < SAME_PLACE_M)
        .expect("an edge of the draft ends at a corner of the panel")
}

fn turned(run: &Run) -> Run {
    Run {
        from: run.to,
        to: run.from,
        ..run.clone()
    }
}

fn checked(pattern: &Pattern, pairs: &[SeamPair]) -> SeamCheck {
    check(pattern, pairs, &BTreeMap::new(), 0.012, &Limits::default()).0
}

#[test]
fn true_seams_are_accepted_and_show_that_the_back_is_drawn_from_inside() {
    let Some(folder) = data("true seams of a skirt") else {
        return;
    };
    let (pattern, pairs) = skirt(folder);
    let found = checked(&pattern, &pairs);
    assert!(found.ok, "{:#?}", found.seams);
    assert_eq!(pairs.len(), 20);
    for panel in &pattern.panels {
        let expected = if panel.name.to_lowercase().contains("front") {
            Face::Up
        } else {
            Face::Down
        };
        assert_eq!(found.faces[&panel.id], expected, "{}", panel.id);
    }
    assert!(found.warnings.is_empty(), "every panel is sewn to another");
}

#[test]
fn each_seam_with_one_side_reversed_is_refused_and_blamed() {
    let Some(folder) = data("reversed seams of a skirt") else {
        return;
    };
    let (pattern, pairs) = skirt(folder);
    // Any two of the four panels that are sewn together are so in at least two places, and darts join a panel to itself: each seam lies on a cycle.
    for wrong in 0..pairs.len() {
        let mut reversed = pairs.clone();
        let Side::One(run) = &pairs[wrong].b else {
            panic!("made as single runs")
        };
        reversed[wrong].b = Side::One(turned(run));
        let found = checked(&pattern, &reversed);
        let faults: Vec<_> = found.seams.iter().flat_map(|seam| &seam.errors).collect();
        assert_eq!(faults.len(), 1, "{wrong}: {faults:#?}");
        assert_eq!(faults[0].code, "seam/twisted");
        assert_eq!(faults[0].pointer, format!("/seams/{wrong}"));
        assert_eq!(found.corrected, [pairs[wrong].clone()], "{wrong}");
    }
}

#[test]
fn auto_puts_every_reversed_seam_right() {
    let Some(folder) = data("automatic order of a skirt's seams") else {
        return;
    };
    let (pattern, pairs) = skirt(folder);
    for wrong in 0..pairs.len() {
        let mut reversed = pairs.clone();
        let Side::One(run) = &pairs[wrong].b else {
            panic!("made as single runs")
        };
        reversed[wrong].b = Side::One(turned(run));
        reversed[wrong].matching = Match::Auto;
        let found = checked(&pattern, &reversed);
        assert!(found.ok, "{wrong}");
        let changed: Vec<_> = found.seams.iter().map(|seam| seam.reversed).collect();
        assert!(
            changed
                .iter()
                .enumerate()
                .all(|(i, changed)| *changed == (i == wrong)),
            "{wrong}: {changed:?}"
        );
    }
}
