//! Mirrored copies: same numbers, reflected; made where they are named or stated, refused where
//! they are no images.

use seamster::config::Limits;
use seamster::fault::Warning;
use seamster::pattern::{
    Corner, Edge, Grain, Hole, ImportOptions, Notch, NotchKind, Panel, Pattern, Placement,
    PlacementAnchor, Point2, Quantity, Wrap, checked, import,
};
use seamster_fixtures::panels::{panel_of, pattern};
use std::borrow::Cow;

fn edges(outline: &[Point2]) -> Vec<Vec<Point2>> {
    let next = |i: usize| outline[(i + 1) % outline.len()];
    (0..outline.len())
        .map(|i| vec![outline[i], next(i)])
        .collect()
}

/// A sleeve that is not its own mirror image, with one of each thing that a panel can have.
fn sleeve() -> Panel {
    let mut panel = panel_of(
        "sleeve",
        &edges(&[[0.0, 0.0], [0.1, 0.5], [0.4, 0.4], [0.6, 0.0]]),
    );
    let hole: [Point2; 3] = [[0.2, 0.1], [0.3, 0.1], [0.2, 0.2]];
    panel.holes = vec![Hole {
        corners: (0..3)
            .map(|index| Corner {
                index,
                x: hole[index][0],
                y: hole[index][1],
            })
            .collect(),
        edges: (0..3)
            .map(|index| Edge {
                index,
                from: index,
                to: (index + 1) % 3,
                length_m: 0.0,
                points: vec![hole[index], hole[(index + 1) % 3]],
                label: None,
            })
            .collect(),
    }];
    panel.notches = vec![Notch {
        index: 0,
        edge: 1,
        at: 0.25,
        kind: NotchKind::V,
        depth_m: None,
    }];
    panel.grain = Some(Grain { angle_deg: 70.0 });
    panel.cut_line = vec![[-0.01, -0.01], [0.1, 0.51], [0.61, -0.01]];
    panel.drill_holes = vec![[0.3, 0.3]];
    panel.internal_lines = vec![vec![[0.2, 0.25], [0.35, 0.3]]];
    panel
}

fn front() -> Panel {
    panel_of(
        "front",
        &edges(&[[0.0, 0.0], [0.0, 0.6], [0.5, 0.6], [0.5, 0.0]]),
    )
}

/// The pattern as `checked` leaves it.
fn whole() -> Pattern {
    checked(pattern(vec![sleeve(), front()]), &Limits::default()).expect("a pattern")
}

fn with_copy() -> Pattern {
    whole().with_copies(["sleeve~mirror"]).into_owned()
}

fn area(outline: &[Edge]) -> f64 {
    let points = outline.iter().flat_map(|edge| edge.points.windows(2));
    points
        .map(|p| 0.5 * (p[0][0] * p[1][1] - p[1][0] * p[0][1]))
        .sum()
}

#[test]
fn a_copy_has_the_numbers_of_its_source_and_its_image() {
    let found = with_copy();
    let ids: Vec<&str> = found.panels.iter().map(|panel| panel.id.as_str()).collect();
    assert_eq!(ids, ["sleeve", "front", "sleeve~mirror"]);
    let (source, copy) = (&found.panels[0], &found.panels[2]);
    assert_eq!(copy.copy_of.as_deref(), Some("sleeve"));
    assert_eq!(copy.notches, source.notches);
    for (a, b) in source.corners.iter().zip(&copy.corners) {
        assert_eq!((b.index, b.x, b.y), (a.index, -a.x, a.y));
    }
    for (a, b) in source.edges.iter().zip(&copy.edges) {
        assert_eq!(
            (b.index, b.from, b.to, b.length_m),
            (a.index, a.from, a.to, a.length_m)
        );
        let image: Vec<Point2> = a.points.iter().map(|p| [-p[0], p[1]]).collect();
        assert_eq!(b.points, image);
    }
    assert!(area(&source.edges) < 0.0 && area(&copy.edges) > 0.0);
    assert!(area(&source.holes[0].edges) > 0.0 && area(&copy.holes[0].edges) < 0.0);
    assert_eq!(copy.area_m2, source.area_m2);
    assert_eq!(copy.grain, Some(Grain { angle_deg: 110.0 }));
    assert_eq!(copy.drill_holes, [[-0.3, 0.3]]);
    assert_eq!(copy.cut_line[0], [0.01, -0.01]);
    assert_eq!(copy.internal_lines[0][1], [-0.35, 0.3]);
}

#[test]
fn only_copies_that_are_named_and_possible_are_made() {
    let plain = whole();
    for names in [
        vec![],
        vec!["sleeve", "front"],
        vec!["collar~mirror", "~mirror", "sleeve~mirrored"],
    ] {
        assert!(matches!(plain.with_copies(names), Cow::Borrowed(_)));
    }
    let once = with_copy();
    for names in [
        ["sleeve~mirror", "sleeve"],
        ["sleeve~mirror~mirror", "sleeve~mirror"],
    ] {
        assert!(matches!(once.with_copies(names), Cow::Borrowed(_)));
    }
    let both = plain.with_copies(["front~mirror", "sleeve~mirror", "front~mirror"]);
    assert_eq!(both.panels.len(), 4);
    assert_eq!(both.panels[2].id, "sleeve~mirror");
}

#[test]
fn a_copy_is_placed_as_the_mirror_image_of_its_source() {
    let mut stated = whole();
    let placement = Placement {
        up_deg: Some(80.0),
        at: Some(PlacementAnchor::Origin),
        offset_m: [0.4, 1.3, -0.1],
        rotate_deg: [10.0, 20.0, -45.0],
        wrap: Some(Wrap::Flat),
    };
    stated.placements.insert("sleeve".into(), placement.clone());
    let found = stated.with_copies(["sleeve~mirror", "front~mirror"]);
    assert_eq!(found.placements.len(), 2);
    let image = &found.placements["sleeve~mirror"];
    assert_eq!(image, &placement.mirrored());
    // Points about the center: R' (-x, y, 0) must be R (x, y, 0) reflected, and so must the
    // offsets.
    let at = |p: &Placement, [x, y]: Point2| {
        let mut v = [x, y, 0.0];
        for axis in [2, 1, 0] {
            let (sin, cos) = p.rotate_deg[axis].to_radians().sin_cos();
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            (v[i], v[j]) = (cos * v[i] - sin * v[j], sin * v[i] + cos * v[j]);
        }
        [0, 1, 2].map(|k| v[k] + p.offset_m[k])
    };
    for [x, y] in [[0.3, 0.1], [-0.2, 0.5]] {
        let (drawn, copy) = (at(&placement, [x, y]), at(image, [-x, y]));
        let wanted = [-drawn[0], drawn[1], drawn[2]];
        for k in 0..3 {
            assert!((copy[k] - wanted[k]).abs() < 1e-12, "{copy:?} {wanted:?}");
        }
    }
}

#[test]
fn a_pattern_with_copies_survives_json() {
    let sent = with_copy();
    let json = serde_json::to_string(&sent).expect("JSON");
    let read: Pattern = serde_json::from_str(&json).expect("a Pattern");
    assert_eq!(checked(read, &Limits::default()), Ok(sent.clone()));
    // Writers round: the copy becomes the exact image again.
    let mut rounded = sent.clone();
    rounded.panels[2].corners[1].x += 4e-7;
    rounded.panels[2].edges[0].points[1][0] += 4e-7;
    rounded.panels[2].area_m2 = 5.0;
    assert_eq!(checked(rounded, &Limits::default()), Ok(sent));
}

#[test]
fn a_copy_that_is_no_mirror_image_is_refused() {
    let fault = |change: &dyn Fn(&mut Pattern)| {
        let mut wrong = with_copy();
        change(&mut wrong);
        let faults = checked(wrong, &Limits::default())
            .expect_err("it is wrong")
            .0;
        let pairs = faults
            .into_iter()
            .map(|fault| (fault.code.to_string(), fault.pointer));
        pairs.collect::<Vec<_>>()
    };
    let one = |code: &str, pointer: &str| vec![(code.to_owned(), pointer.to_owned())];
    let not_mirrored = |field: &str| one("pattern/not_mirrored", &format!("/panels/2/{field}"));
    let moved = |p: &mut Pattern| {
        p.panels[2].corners[1].x += 0.01;
        p.panels[2].edges[0].points[1][0] += 0.01;
        p.panels[2].edges[1].points[0][0] += 0.01;
    };
    assert_eq!(fault(&moved), not_mirrored("edges"));
    assert_eq!(
        fault(&|p| p.panels[2].notches[0].at = 0.75),
        not_mirrored("notches")
    );
    assert_eq!(fault(&|p| p.panels[2].grain = None), not_mirrored("grain"));
    assert_eq!(fault(&|p| p.panels[2].holes.clear()), not_mirrored("holes"));
    assert_eq!(
        fault(&|p| p.panels[2].drill_holes[0][0] = 0.3),
        not_mirrored("drill_holes")
    );
    assert_eq!(
        fault(&|p| p.panels[2].copy_of = Some("front".into())),
        one("pattern/id", "/panels/2/id")
    );
    assert_eq!(
        fault(&|p| p.panels[2].copy_of = Some("collar".into())),
        one("pattern/unknown_panel", "/panels/2/copy_of")
    );
    assert_eq!(
        fault(&|p| p.panels[1].id = "back~mirror".into()),
        one("pattern/id", "/panels/1/id")
    );
    // As a panel of its own it would run the wrong way.
    let alone = fault(&|p| p.panels[2].copy_of = None);
    assert!(
        alone.iter().any(|(code, _)| code == "pattern/orientation"),
        "{alone:?}"
    );
}

/// A DXF of pieces of one shape, each a block with a name and a quantity.
fn dxf(pieces: &[(&str, &str)]) -> String {
    let mut file = "0\nSECTION\n2\nBLOCKS\n".to_owned();
    for (name, quantity) in pieces {
        file += &format!("0\nBLOCK\n8\n1\n2\n{name}\n70\n0\n10\n0.0\n20\n0.0\n");
        for text in ["Units: METRIC", &format!("Quantity: {quantity}")] {
            file += &format!("0\nTEXT\n8\n1\n10\n1.0\n20\n1.0\n40\n1.0\n1\n{text}\n");
        }
        file += "0\nPOLYLINE\n8\n1\n66\n1\n70\n1\n";
        for [x, y] in [[0, 0], [300, 0], [200, 400], [0, 400]] {
            file += &format!("0\nVERTEX\n8\n1\n10\n{x}.0\n20\n{y}.0\n");
        }
        file += "0\nSEQEND\n8\n1\n0\nENDBLK\n8\n1\n";
    }
    file + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"
}

#[test]
fn quantities_of_a_file_make_copies_and_unclear_ones_are_told() {
    let file = dxf(&[
        ("PAIR", "1,1"),
        ("ONE", "1"),
        ("TWO", "2"),
        ("LAYERS", "2,2"),
        ("NONE", "0,0"),
    ]);
    let found = import(
        file.as_bytes(),
        &ImportOptions::default(),
        &Limits::default(),
    )
    .expect("a DXF");
    let ids: Vec<&str> = found.panels.iter().map(|panel| panel.id.as_str()).collect();
    assert_eq!(
        ids,
        [
            "pair",
            "one",
            "two",
            "layers",
            "none",
            "pair~mirror",
            "layers~mirror"
        ]
    );
    assert_eq!(
        found.panels[0].quantity,
        Some(Quantity { left: 1, right: 1 })
    );
    assert_eq!(found.panels[5].quantity, None);
    let about = |w: &&Warning| w.code == "pattern/quantity";
    let told: Vec<&Warning> = found.warnings.iter().filter(about).collect();
    assert_eq!(told.len(), 1);
    assert_eq!(told[0].pointer, "/panels/2/quantity");
    assert!(told[0].detail.contains("two~mirror"), "{}", told[0].detail);
    assert_eq!(checked(found.clone(), &Limits::default()), Ok(found));
}
