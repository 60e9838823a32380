//! Seam allowance cut away: against closed forms, with numbers and notches kept, refused where
//! nothing would be left.

use seamster::pattern::{Edge, Notch, NotchKind, Panel, Pattern, Point2};
use seamster_fixtures::panels::panel_of;
use std::f64::consts::{PI, TAU};

fn polygon(outline: &[Point2]) -> Panel {
    let next = |i: usize| outline[(i + 1) % outline.len()];
    let edges: Vec<_> = (0..outline.len())
        .map(|i| vec![outline[i], next(i)])
        .collect();
    panel_of("panel", &edges)
}

/// `count` points on a circle, clockwise.
fn circle(count: usize, radius: f64) -> Vec<Point2> {
    let at = |i: usize| -TAU * i as f64 / count as f64;
    (0..count)
        .map(|i| [radius * at(i).cos(), radius * at(i).sin()])
        .collect()
}

fn net(panel: &Panel, width: f64) -> Panel {
    panel
        .without_allowance(width)
        .expect("there is enough of it")
}

fn refused(panel: &Panel, width: f64) -> String {
    let fault = panel.without_allowance(width).expect_err("it cannot be");
    assert_eq!(
        (fault.code.as_str(), fault.pointer.as_str()),
        ("pattern/allowance", "")
    );
    fault.detail
}

fn corners(panel: &Panel) -> Vec<Point2> {
    panel.corners.iter().map(|c| [c.x, c.y]).collect()
}

#[track_caller]
fn assert_near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-12, "{found} is not {wanted}");
}

#[track_caller]
fn assert_points(found: &[Point2], wanted: &[Point2]) {
    assert_eq!(found.len(), wanted.len());
    for (a, b) in found.iter().flatten().zip(wanted.iter().flatten()) {
        assert!((a - b).abs() < 1e-12, "{found:?} {wanted:?}");
    }
}

const WIDTH: f64 = 0.01;

#[test]
fn rectangle_loses_the_width_on_every_side() {
    let outline = [[0.0, 0.0], [0.0, 0.4], [0.3, 0.4], [0.3, 0.0]];
    let panel = polygon(&outline);
    let found = net(&panel, WIDTH);
    assert_points(
        &corners(&found),
        &[[0.01, 0.01], [0.01, 0.39], [0.29, 0.39], [0.29, 0.01]],
    );
    assert_near(found.area_m2, 0.28 * 0.38);
    assert_near(found.perimeter_m, 2.0 * (0.28 + 0.38));
    assert_near(found.edges[0].length_m, 0.38);
    assert_points(&found.cut_line, &outline);
    assert_eq!(found.drawn_area_m2, panel.drawn_area_m2);
    assert_eq!(net(&panel, 0.0), panel);
}

#[test]
fn regular_polygon_keeps_its_center_and_loses_the_width_from_its_apothem() {
    for count in [3, 5, 8] {
        let half = PI / count as f64;
        let apothem = 0.3 * half.cos();
        let found = net(&polygon(&circle(count, 0.3)), WIDTH);
        assert_near(
            found.area_m2,
            count as f64 * half.tan() * (apothem - WIDTH).powi(2),
        );
        assert_points(
            &corners(&found),
            &circle(count, (apothem - WIDTH) / half.cos()),
        );
    }
}

#[test]
fn smooth_convex_outlines_follow_steiner() {
    // An ellipse in four edges of 90 chords. Chords make an error of (1 degree)²/24 of the last
    // term.
    let count = 360;
    let (a, b) = (0.3, 0.2);
    let at = |i: usize| {
        let t = -TAU * i as f64 / count as f64;
        [a * t.cos(), b * t.sin()]
    };
    let edge = |k: usize| (90 * k..=90 * (k + 1)).map(|i| at(i % count)).collect();
    let panel = panel_of("ellipse", &(0..4).map(edge).collect::<Vec<Vec<Point2>>>());
    // The smallest radius of curvature is b²/a = 0.133.
    for width in [0.005, 0.02, 0.1] {
        let found = net(&panel, width);
        let steiner = panel.area_m2 - width * panel.perimeter_m + PI * width * width;
        assert!(
            (found.area_m2 - steiner).abs() < 1e-3 * PI * width * width,
            "{width}"
        );
        let long = panel.perimeter_m - TAU * width;
        assert!((found.perimeter_m / long - 1.0).abs() < 1e-4);
        // Corners stay on the axes. A mitre goes 1/cos(turn / 2) as far as a normal; the turn here
        // is at most 1.5 degrees.
        for (corner, wanted) in [(0, [a - width, 0.0]), (3, [0.0, b - width])] {
            let [x, y] = corners(&found)[corner];
            let off = (x - wanted[0]).hypot(y - wanted[1]);
            assert!(off < 1e-4 * width, "{x} {y}");
        }
    }
}

#[test]
fn lines_meet_in_a_mitre_at_a_corner_that_juts_in() {
    // An L: its inner corner moves by the width along both axes.
    let outline = [
        [0.0, 0.0],
        [0.0, 0.4],
        [0.2, 0.4],
        [0.2, 0.2],
        [0.4, 0.2],
        [0.4, 0.0],
    ];
    let found = net(&polygon(&outline), WIDTH);
    let wanted = [
        [0.01, 0.01],
        [0.01, 0.39],
        [0.19, 0.39],
        [0.19, 0.19],
        [0.39, 0.19],
        [0.39, 0.01],
    ];
    assert_points(&corners(&found), &wanted);
    assert_near(found.area_m2, 0.18 * 0.38 + 0.2 * 0.18);
}

#[test]
fn hollow_curves_grow_by_the_width() {
    // A rectangle whose top is scooped out by a half circle of radius 0.1.
    let scoop: Vec<Point2> = (0..=180)
        .map(|i| {
            let angle = PI - PI * f64::from(i) / 180.0;
            [0.2 + 0.1 * angle.cos(), 0.4 - 0.1 * angle.sin()]
        })
        .collect();
    let panel = panel_of(
        "scooped",
        &[
            vec![[0.0, 0.0], [0.0, 0.4]],
            vec![[0.0, 0.4], [0.1, 0.4]],
            scoop,
            vec![[0.3, 0.4], [0.4, 0.4]],
            vec![[0.4, 0.4], [0.4, 0.0]],
            vec![[0.4, 0.0], [0.0, 0.0]],
        ],
    );
    let found = net(&panel, 0.02);
    for [x, y] in &found.edges[2].points {
        let radius = (x - 0.2).hypot(y - 0.4);
        assert!((radius - 0.12).abs() < 0.12 * 4e-5, "{radius}");
    }
    // The arc ends where it meets the line 0.02 below the top.
    let reach = (0.12_f64.powi(2) - 0.02_f64.powi(2)).sqrt();
    assert!((found.corners[2].x - (0.2 - reach)).abs() < 1e-5);
    assert_near(found.corners[2].y, 0.38);
}

#[test]
fn curves_tighter_than_the_width_lose_what_does_not_fit() {
    // A square of 0.4 with corners rounded to 0.005 by 45 chords each, one edge a side: cut by
    // 0.01, a square of 0.38.
    let radius = 0.005;
    let centers = [
        [radius, 0.4 - radius],
        [0.4 - radius, 0.4 - radius],
        [0.4 - radius, radius],
        [radius, radius],
    ];
    let edges: Vec<Vec<Point2>> = (0..4)
        .map(|k| {
            let rounding = |i: i32| {
                let angle = PI - 0.5 * PI * k as f64 - 0.5 * PI * f64::from(i) / 45.0;
                [
                    centers[k][0] + radius * angle.cos(),
                    centers[k][1] + radius * angle.sin(),
                ]
            };
            let next = PI - 0.5 * PI * (k + 1) as f64;
            let start = centers[(k + 1) % 4];
            let mut points: Vec<Point2> = (0..=45).map(rounding).collect();
            points.push([
                start[0] + radius * next.cos(),
                start[1] + radius * next.sin(),
            ]);
            points
        })
        .collect();
    let mut edges = edges;
    for k in 0..4 {
        let first = edges[(k + 1) % 4][0];
        *edges[k].last_mut().expect("points") = first;
    }
    let panel = panel_of("rounded", &edges);
    let found = net(&panel, WIDTH);
    assert!(
        (found.area_m2 - 0.38 * 0.38).abs() < 1e-9,
        "{}",
        found.area_m2
    );
    assert_eq!(found.edges.len(), 4);
    assert!(
        found
            .edges
            .iter()
            .all(|edge| (edge.length_m - 0.38).abs() < 1e-6)
    );
}

#[test]
fn numbers_labels_and_notches_are_carried_over() {
    let mut panel = polygon(&[[0.0, 0.0], [0.0, 0.4], [0.3, 0.4], [0.5, 0.0]]);
    panel.edges[2].label = Some("side".into());
    let notch = |index, edge, at| Notch {
        index,
        edge,
        at,
        kind: NotchKind::T,
        depth_m: Some(0.004),
    };
    panel.notches = vec![notch(0, 0, 0.25), notch(1, 3, 0.0)];
    let found = net(&panel, WIDTH);
    let numbers = |panel: &Panel| {
        panel
            .edges
            .iter()
            .map(|e: &Edge| (e.index, e.from, e.to))
            .collect::<Vec<_>>()
    };
    assert_eq!(numbers(&found), numbers(&panel));
    assert_eq!(found.edges[2].label.as_deref(), Some("side"));
    // 0.1 up the left side; the edge now runs from 0.01 to 0.39.
    assert_near(found.notches[0].at, 0.09 / 0.38);
    assert_eq!(
        (found.notches[0].kind, found.notches[0].depth_m),
        (NotchKind::T, Some(0.004))
    );
    // A notch at a corner stays at the end of its edge.
    assert_near(found.notches[1].at, 0.0);
}

#[test]
fn a_copy_is_cut_as_its_source_is() {
    let sleeve = polygon(&[[0.0, 0.0], [0.1, 0.4], [0.3, 0.4], [0.5, 0.0]]);
    let pattern: Pattern = seamster_fixtures::panels::pattern(vec![sleeve]);
    let both = pattern.with_copies(["panel~mirror"]);
    let [source, copy] = [0, 1].map(|i| net(&both.panels[i], WIDTH));
    assert_eq!(
        (copy.id.as_str(), copy.copy_of.as_deref()),
        ("panel~mirror", Some("panel"))
    );
    let image: Vec<Point2> = corners(&source).iter().map(|p| [-p[0], p[1]]).collect();
    assert_eq!(corners(&copy), image);
    assert_eq!(copy.area_m2, source.area_m2);
    let image: Vec<Point2> = source.cut_line.iter().map(|p| [-p[0], p[1]]).collect();
    assert_eq!(copy.cut_line, image);
}

#[test]
fn what_cannot_spare_the_width_is_refused() {
    // A strip of 0.018.
    let strip = polygon(&[[0.0, 0.0], [0.0, 0.4], [0.018, 0.4], [0.018, 0.0]]);
    assert!(refused(&strip, WIDTH).contains("nothing of"));
    assert!(refused(&polygon(&circle(6, 0.009)), WIDTH).contains("nothing of"));
    // An edge of 5 mm between two right angles' worth of turn.
    let clipped = polygon(&[
        [0.0, 0.0],
        [0.0, 0.4],
        [0.4, 0.4],
        [0.4, 0.003],
        [0.397, 0.0],
    ]);
    assert!(
        refused(&clipped, WIDTH).contains("edge 3"),
        "{}",
        refused(&clipped, WIDTH)
    );
    // An hourglass whose waist is 0.01 wide.
    let hourglass = polygon(&[
        [0.0, 0.0],
        [0.1, 0.2],
        [0.0, 0.4],
        [0.21, 0.4],
        [0.11, 0.2],
        [0.21, 0.0],
    ]);
    assert!(refused(&hourglass, WIDTH).contains("run into each other"));
    // A slit has no allowance at its end.
    let slit = polygon(&[
        [0.0, 0.0],
        [0.0, 0.4],
        [0.199, 0.4],
        [0.2, 0.2],
        [0.201, 0.4],
        [0.4, 0.4],
        [0.4, 0.0],
    ]);
    assert!(refused(&slit, WIDTH).contains("slit"));
    for none in [-0.01, f64::NAN, f64::INFINITY] {
        assert!(refused(&slit, none).contains("is no width"));
    }
    let mut sewn = polygon(&circle(6, 0.3));
    sewn.cut_line = circle(6, 0.31);
    assert!(refused(&sewn, WIDTH).contains("cut line of its own"));
}
