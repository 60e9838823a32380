//! Import does not depend on where and how a piece lies, the unit, the order of entities, the
//! direction of runs. Pieces are drawn by chance, the same for the same seed.

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Panel, Pattern, Point2, import};
use seamster_fixtures::damage::SplitMix64;
use seamster_fixtures::dxf::DxfBuilder;

/// Lengths and places of one file written twice agree to this: coordinates are written in full
/// \[m\].
const SAME: f64 = 1e-9;

/// One piece as drawn \[mm\].
#[derive(Clone)]
struct DrawnPiece {
    /// Open runs, head to tail.
    runs: Vec<Vec<Point2>>,
    grain: [Point2; 2],
    internal: Vec<Point2>,
    notch: Point2,
    drill: Point2,
}

/// Choices in writing a file.
#[derive(Clone, Copy, Debug)]
struct Manner {
    /// Counter-clockwise \[radians\].
    turn: f64,
    shift: Point2,
    mm_per_unit: f64,
    units: &'static str,
    shuffle: Option<u64>,
    /// Blocks with runs on layers with numbers, else lines on layers with names.
    blocks: bool,
}

const PLAIN: Manner = Manner {
    turn: 0.0,
    shift: [0.0, 0.0],
    mm_per_unit: 1.0,
    units: "METRIC",
    shuffle: None,
    blocks: true,
};

/// A piece: 4 to 7 sides about a middle, straight or bent.
fn drawn(dice: &mut SplitMix64, middle: Point2) -> DrawnPiece {
    let count = 4 + dice.below(4);
    let corner = |i: usize, dice: &mut SplitMix64| {
        let angle = std::f64::consts::TAU * (i as f64 + 0.5 * dice.part()) / count as f64;
        let radius = 150.0 + 120.0 * dice.part();
        [0, 1].map(|k| middle[k] + radius * [angle.cos(), angle.sin()][k])
    };
    let corners: Vec<Point2> = (0..count).map(|i| corner(i, dice)).collect();
    let runs: Vec<Vec<Point2>> = (0..count)
        .map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % count]);
            let bent = 0.15 * (dice.part() - 0.5);
            let steps = if dice.below(2) == 0 {
                1
            } else {
                5 + dice.below(12)
            };
            let at = |t: f64| {
                let off = bent * 4.0 * t * (1.0 - t);
                let across = [a[1] - b[1], b[0] - a[0]];
                [0, 1].map(|k| a[k] + t * (b[k] - a[k]) + off * across[k])
            };
            let mut run: Vec<Point2> = (0..=steps).map(|k| at(k as f64 / steps as f64)).collect();
            run[0] = a;
            run[steps] = b;
            run
        })
        .collect();
    let beside = |d: Point2| [middle[0] + d[0], middle[1] + d[1]];
    let (a, b) = (runs[0][0], runs[0][1]);
    let part = 0.2 + 0.6 * dice.part();
    DrawnPiece {
        notch: [0, 1].map(|k| a[k] + part * (b[k] - a[k])),
        grain: [beside([-30.0, -60.0]), beside([20.0, 60.0])],
        internal: vec![
            beside([-50.0, 0.0]),
            beside([10.0, 30.0]),
            beside([50.0, 0.0]),
        ],
        drill: beside([5.0, -20.0]),
        runs,
    }
}

/// One thing to write: layer, points (one: a POINT).
type Item = (&'static str, Vec<Point2>);

fn items(piece: &DrawnPiece, blocks: bool) -> Vec<Item> {
    let layer = |number: &'static str, name: &'static str| if blocks { number } else { name };
    let mut items: Vec<Item> = Vec::new();
    for run in &piece.runs {
        if blocks {
            items.push(("1", run.clone()));
            items.push(("2", vec![run[0]]));
        } else {
            items.extend(run.windows(2).map(|w| ("CUT", w.to_vec())));
        }
    }
    items.push((layer("7", "GRAIN"), piece.grain.to_vec()));
    items.push((layer("8", "INTERNAL"), piece.internal.clone()));
    items.push((layer("4", "NOTCH"), vec![piece.notch]));
    items.push((layer("13", "DRILL"), vec![piece.drill]));
    items
}

fn written(pieces: &[DrawnPiece], manner: Manner) -> Vec<u8> {
    let (sin, cos) = manner.turn.sin_cos();
    let put = |p: &Point2| {
        let turned = [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]];
        [0, 1].map(|k| (turned[k] + manner.shift[k]) / manner.mm_per_unit)
    };
    let mut dice = SplitMix64(manner.shuffle.unwrap_or(0));
    let mut file = DxfBuilder::default().text("1", &format!("Units: {}", manner.units));
    let mut all: Vec<Item> = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        let mut own = items(piece, manner.blocks);
        if manner.shuffle.is_some() {
            shuffle(&mut own, &mut dice);
        }
        if manner.blocks {
            file = file.block(&format!("Point2{i}"));
            file = own.iter().fold(file, |file, item| add(file, item, &put));
        } else {
            all.extend(own);
        }
    }
    if manner.shuffle.is_some() {
        shuffle(&mut all, &mut dice);
    }
    all.iter()
        .fold(file, |file, item| add(file, item, &put))
        .bytes()
}

/// Another order, and every other line the other way round.
fn shuffle(items: &mut [Item], dice: &mut SplitMix64) {
    for i in (1..items.len()).rev() {
        items.swap(i, dice.below(i + 1));
    }
    for (_, points) in items {
        if dice.below(2) == 0 {
            points.reverse();
        }
    }
}

fn add(file: DxfBuilder, (layer, points): &Item, put: &impl Fn(&Point2) -> Point2) -> DxfBuilder {
    match points.as_slice() {
        [point] => file.point(layer, put(point)),
        [a, b] => file.line(layer, put(a), put(b)),
        run => file.run(layer, false, &run.iter().map(put).collect::<Vec<Point2>>()),
    }
}

fn read(pieces: &[DrawnPiece], manner: Manner) -> Pattern {
    let bytes = written(pieces, manner);
    let read = import(&bytes, &ImportOptions::default(), &Limits::default());
    let pattern = read.unwrap_or_else(|faults| panic!("{manner:?}: {faults}"));
    assert_eq!(pattern.warnings, [], "{manner:?}");
    assert_eq!(pattern.panels.len(), pieces.len());
    pattern
}

/// Measures of a panel that do not depend on where it begins: each corner goes with the length of
/// the edge after it.
fn course(panel: &Panel, back: impl Fn(Point2) -> Point2) -> Vec<(Point2, f64)> {
    let corners = panel.corners.iter().zip(&panel.edges);
    corners
        .map(|(c, e)| (back([c.x, c.y]), e.length_m))
        .collect()
}

fn near(a: Point2, b: Point2) -> bool {
    (a[0] - b[0]).hypot(a[1] - b[1]) < SAME
}

/// The panels are those of `plain`, moved as `manner` says.
fn assert_same(plain: &Pattern, found: &Pattern, manner: Manner) {
    let (sin, cos) = (-manner.turn).sin_cos();
    let back = |p: Point2| {
        let p = [0, 1].map(|k| p[k] - manner.shift[k] / 1000.0);
        [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]]
    };
    let at = |panel: &Panel, i: usize, back: &dyn Fn(Point2) -> Point2| back(panel.drill_holes[i]);
    for wanted in &plain.panels {
        let is_it = |p: &&Panel| near(at(p, 0, &back), at(wanted, 0, &|p| p));
        let panel = found.panels.iter().find(is_it);
        let panel = panel.unwrap_or_else(|| panic!("{manner:?}: {} is gone", wanted.id));
        let close = |a: f64, b: f64| (a - b).abs() < SAME;
        assert!(close(panel.area_m2, wanted.area_m2), "{manner:?}");
        assert!(close(panel.perimeter_m, wanted.perimeter_m), "{manner:?}");
        let (own, other) = (course(panel, back), course(wanted, |p| p));
        assert_eq!(own.len(), other.len(), "{manner:?} {}", wanted.id);
        let start = other
            .iter()
            .position(|c| near(c.0, own[0].0))
            .expect("the first corner");
        for (i, corner) in own.iter().enumerate() {
            let same = other[(start + i) % other.len()];
            assert!(
                near(corner.0, same.0) && close(corner.1, same.1),
                "{manner:?}: {corner:?} {same:?}"
            );
        }
        let edge = |panel: &Panel| {
            (
                panel.edges[panel.notches[0].edge].length_m,
                panel.notches[0].at,
            )
        };
        let ((long, at), (long_wanted, at_wanted)) = (edge(panel), edge(wanted));
        assert!(
            close(long, long_wanted) && (at - at_wanted).abs() < 1e-7,
            "{manner:?}"
        );
        let angle = |panel: &Panel| panel.grain.expect("a grain line").angle_deg;
        let off = angle(panel) - angle(wanted) - manner.turn.to_degrees();
        assert!(
            ((off + 90.0).rem_euclid(180.0) - 90.0).abs() < 1e-6,
            "{manner:?}"
        );
        assert_eq!(panel.internal_lines.len(), 1);
    }
}

fn pieces(seed: u64) -> Vec<DrawnPiece> {
    let mut dice = SplitMix64(seed);
    (0..3)
        .map(|i| drawn(&mut dice, [700.0 * f64::from(i), 0.0]))
        .collect()
}

fn each(manners: impl Fn(&mut SplitMix64) -> Vec<Manner>) {
    for seed in 0..40 {
        let pieces = pieces(seed);
        let mut dice = SplitMix64(1000 + seed);
        for manner in manners(&mut dice) {
            for blocks in [true, false] {
                let plain = read(&pieces, Manner { blocks, ..PLAIN });
                let manner = Manner { blocks, ..manner };
                assert_same(&plain, &read(&pieces, manner), manner);
            }
        }
    }
}

#[test]
fn place_and_direction_of_a_piece_do_not_matter() {
    each(|dice| {
        let shift = [1e4 * (dice.part() - 0.5), 1e4 * (dice.part() - 0.5)];
        let turn = std::f64::consts::TAU * dice.part();
        vec![
            Manner { shift, ..PLAIN },
            Manner { turn, ..PLAIN },
            Manner {
                shift,
                turn,
                ..PLAIN
            },
        ]
    });
}

#[test]
fn unit_that_is_said_does_not_matter() {
    let in_unit = |mm_per_unit: f64, units| Manner {
        mm_per_unit,
        units,
        ..PLAIN
    };
    each(|_| {
        vec![
            in_unit(25.4, "ENGLISH"),
            in_unit(10.0, "cm"),
            in_unit(1000.0, "m"),
            in_unit(1.0, "mm"),
        ]
    });
}

#[test]
fn order_of_entities_and_direction_of_runs_do_not_matter() {
    each(|dice| {
        let shuffle = Some(dice.below(1 << 20) as u64);
        vec![Manner { shuffle, ..PLAIN }]
    });
}
