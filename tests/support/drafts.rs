//! Garments that GarmentCode drafted and exported, with the stitches that its own files state.
//!
//! A stitch names two edges by their number along the drawn loops; the start of the one meets the end of the other.
//! Front and back are drawn in one view (seen from the front); loops that run counter-clockwise show the outer side of the cloth.
#![allow(
    dead_code,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Match, Panel, Pattern, Place, Run, SeamPair, Side, import};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Corners may be off by the rounding of the file's figures \[m\].
const SAME_PLACE_M: f64 = 1e-4;

/// The data folder; where there is none, says that `left_out` tests are left out.
pub(crate) fn data(left_out: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("SEAMSTER_TEST_DATA is not set: 1 test left out ({left_out})");
    }
    folder
}

/// A pattern, its seams, and the file that states them.
pub(crate) struct Garment {
    pub(crate) pattern: Pattern,
    pub(crate) pairs: Vec<SeamPair>,
    pub(crate) truth: Value,
}

/// The garment of this name in a folder.
pub(crate) fn garment(folder: &Path, name: &str) -> Garment {
    let bytes = std::fs::read(folder.join(format!("{name}.dxf"))).expect("the data folder has it");
    let pattern = import(&bytes, &ImportOptions::default(), &Limits::default())
        .expect("the file is one that must import");
    let truth = std::fs::read(folder.join(format!("{name}.seams.json"))).expect("the data has it");
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
        confidence: None,
        because: None,
    });
    Garment {
        pairs: pairs.collect(),
        pattern,
        truth,
    }
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

/// The same run the other way.
pub(crate) fn turned(run: &Run) -> Run {
    Run {
        from: run.to,
        to: run.from,
        ..run.clone()
    }
}
