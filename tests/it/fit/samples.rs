//! The samples that ship are what the drafting program writes, and they are patterns that can be
//! sewn.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use dxf::entities::EntityType;
use seamster::config::Limits;
use seamster::fit::{Garment, SeamsSpec};
use seamster::pattern::{ImportOptions, OutlineRun, Pattern, Place, Point2, SeamPair};
use seamster::seam::{self, Face};
use seamster_fixtures::drafting::SamplePattern;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Runs of an outline by their order, each a polyline [mm]: run `i` leaves corner `i`.
type Runs = Vec<Vec<Point2>>;

fn shipped(file: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("static/samples");
    std::fs::read_to_string(path.join(file)).unwrap()
}

/// The boundary runs of each piece by panel id, as a general DXF reader finds them.
fn outlines(sample: &SamplePattern) -> BTreeMap<String, Runs> {
    let drawing = dxf::Drawing::load(&mut sample.dxf.as_bytes()).unwrap();
    let mut pieces = BTreeMap::new();
    for block in drawing.blocks() {
        let mut name = None;
        let mut runs = Runs::new();
        for entity in &block.entities {
            match &entity.specific {
                EntityType::Text(text) => {
                    name = name.or(text.value.strip_prefix("Piece Name: "));
                }
                EntityType::Polyline(line) => {
                    assert_eq!(entity.common.layer, "1");
                    let points = line.vertices().map(|v| [v.location.x, v.location.y]);
                    runs.push(points.collect());
                }
                _ => {}
            }
        }
        pieces.insert(name.unwrap().to_lowercase().replace(' ', "-"), runs);
    }
    pieces
}

fn seams(sample: &SamplePattern) -> Vec<SeamPair> {
    let garment: Garment = serde_json::from_str(&sample.garment).unwrap();
    match garment.seams {
        SeamsSpec::Pairs(pairs) => pairs,
        SeamsSpec::Keyword(_) => panic!("the samples name their seams"),
    }
}

fn pattern(sample: &SamplePattern) -> Pattern {
    let options = ImportOptions::default();
    seamster::pattern::import(sample.dxf.as_bytes(), &options, &Limits::default()).unwrap()
}

fn length(run: &[Point2]) -> f64 {
    let steps = run.windows(2);
    steps
        .map(|w| (w[0][0] - w[1][0]).hypot(w[0][1] - w[1][1]))
        .sum()
}

/// The drawn run that a side between adjacent corners is, and whether it is walked as drawn.
fn side(outlines: &BTreeMap<String, Runs>, run: &OutlineRun) -> (f64, bool) {
    let runs = &outlines[&run.panel];
    let (Place::Corner(from), Place::Corner(to)) = (run.from, run.to) else {
        panic!("the samples name corners");
    };
    let along = (from + 1) % runs.len() == to;
    assert!(along || (to + 1) % runs.len() == from, "adjacent corners");
    (length(&runs[if along { from } else { to }]), along)
}

#[test]
fn shipped_samples_are_those_that_are_drafted() {
    for sample in seamster_fixtures::drafting::samples() {
        let hint = "run `cargo run -p seamster-tools draft-samples`";
        let dxf = shipped(&format!("{}.dxf", sample.name));
        assert!(dxf == sample.dxf, "{} differs: {hint}", sample.name);
        let garment = shipped(&format!("{}.garment.json", sample.name));
        assert_eq!(garment, sample.garment, "{hint}");
    }
}

#[test]
fn outlines_are_closed_and_clockwise() {
    for sample in seamster_fixtures::drafting::samples() {
        for (panel, runs) in outlines(&sample) {
            let next = runs.iter().cycle().skip(1);
            for (run, next) in runs.iter().zip(next) {
                assert_eq!(run.last(), next.first(), "{panel}");
            }
            let points = runs.iter().flat_map(|run| run.windows(2));
            let area: f64 = points.map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1]).sum();
            assert!(area < 0.0, "{panel}");
        }
    }
}

#[test]
fn both_sides_of_every_seam_are_equally_long() {
    // As printed, to a ten-thousandth of a millimeter a vertex.
    const PRINTED: f64 = 0.01;
    for sample in seamster_fixtures::drafting::samples() {
        let outlines = outlines(&sample);
        for seam in seams(&sample) {
            let [a, b] = [&seam.a, &seam.b].map(|s| side(&outlines, &s.runs()[0]));
            assert!((a.0 - b.0).abs() < PRINTED, "{}: {} {}", seam.id, a.0, b.0);
            // All pieces lie face up, so the two sides run against each other.
            assert_ne!(a.1, b.1, "{}", seam.id);
        }
    }
}

#[test]
fn samples_import_with_the_corners_that_are_drawn() {
    for sample in seamster_fixtures::drafting::samples() {
        let pattern = pattern(&sample);
        let outlines = outlines(&sample);
        assert_eq!(pattern.panels.len(), outlines.len());
        assert_eq!(pattern.warnings, []);
        for panel in &pattern.panels {
            let runs = &outlines[&panel.id];
            let corners: Vec<Point2> = panel.corners.iter().map(|c| [c.x, c.y]).collect();
            let drawn: Vec<Point2> = runs.iter().map(|r| r[0].map(|mm| mm / 1000.0)).collect();
            assert_eq!(corners.len(), drawn.len(), "{}", panel.id);
            for (corner, drawn) in corners.iter().zip(drawn) {
                let apart = (corner[0] - drawn[0]).hypot(corner[1] - drawn[1]);
                assert!(apart < 1e-9, "{}: {corner:?} {drawn:?}", panel.id);
            }
            assert!(!panel.notches.is_empty(), "{}", panel.id);
            assert!(panel.grain.is_some(), "{}", panel.id);
        }
    }
}

#[test]
fn samples_can_be_sewn_as_they_are() {
    let limits = Limits::default();
    for sample in seamster_fixtures::drafting::samples() {
        let pattern = pattern(&sample);
        let (_, seams) = seam::check(&pattern, &seams(&sample), &BTreeMap::new(), 0.012, &limits);
        let seams = seams.unwrap();
        assert!(seams.faces.iter().all(|face| *face == Face::Up));
    }
}

#[test]
fn skirt_is_worn_by_its_waistband() {
    let form = seamster::scene::DressForm::default();
    let skirt = &seamster_fixtures::drafting::samples()[0];
    let outlines = outlines(skirt);
    let band = length(&outlines["waistband"][0]) / 1000.0;
    assert!((0.01..=0.021).contains(&(band - form.waist_m)), "{band}");
    let hem = length(&outlines["skirt-front"][2]) + length(&outlines["skirt-back"][3]);
    assert!((1300.0..1400.0).contains(&hem), "{hem}");
}
