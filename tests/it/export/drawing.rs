//! The pattern drawn: true proportion, panels apart, numbers and marks where they belong, nothing
//! that an upload could run.

use seamster::export::drawing_svg;
use seamster::pattern::{Grain, Notch, NotchKind, Panel, Point2};
use seamster_fixtures::panels::{panel_of, pattern};

fn polygon(id: &str, outline: &[Point2]) -> Panel {
    let next = |i: usize| outline[(i + 1) % outline.len()];
    let edges: Vec<_> = (0..outline.len())
        .map(|i| vec![outline[i], next(i)])
        .collect();
    panel_of(id, &edges)
}

/// A panel of 300 by 400 mm.
fn front() -> Panel {
    polygon("front", &[[0.0, 0.0], [0.0, 0.4], [0.3, 0.4], [0.3, 0.0]])
}

/// The values of an attribute in order.
fn values<'a>(svg: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    let rest = svg.split(start.as_str()).skip(1);
    rest.map(|rest| rest.split('"').next().expect("a quote"))
        .collect()
}

/// The points of path data that has only straight lines.
fn points(data: &str) -> Vec<Point2> {
    let parts = data.split(['M', 'L']).filter(|part| !part.is_empty());
    parts
        .map(|part| {
            let mut numbers = part
                .trim_end_matches('Z')
                .split(' ')
                .map(|n| n.parse().expect("a number"));
            [0, 1].map(|_| numbers.next().expect("two numbers"))
        })
        .collect()
}

fn box_of(points: &[Point2]) -> [Point2; 2] {
    let fold = |k: usize, least: bool| {
        let all = points.iter().map(|p| p[k]);
        if least {
            all.fold(f64::INFINITY, f64::min)
        } else {
            all.fold(f64::NEG_INFINITY, f64::max)
        }
    };
    [
        [fold(0, true), fold(1, true)],
        [fold(0, false), fold(1, false)],
    ]
}

/// The cloth of each panel on the sheet, in the pattern's order.
fn cloths(svg: &str) -> Vec<Vec<Point2>> {
    let groups = svg.split("<g transform=\"translate(").skip(1);
    let cloth = |group: &str| {
        let at: Vec<f64> = group
            .split(')')
            .next()?
            .split(' ')
            .map(|n| n.parse().expect("a number"))
            .collect();
        let data = group
            .split("fill-rule")
            .next()
            .filter(|_| group.contains("fill-rule"))?;
        let outline = points(data.rsplit(" d=\"").next()?.split('"').next()?);
        Some(
            outline
                .into_iter()
                .map(|p| [p[0] + at[0], p[1] + at[1]])
                .collect(),
        )
    };
    groups.filter_map(cloth).collect()
}

#[test]
fn panels_are_drawn_in_millimeters_with_y_down() {
    let svg = drawing_svg(&pattern(vec![front()]));
    let found = cloths(&svg).remove(0);
    let [low, high] = box_of(&found);
    let size = [high[0] - low[0], high[1] - low[1]];
    assert!(
        (size[0] - 300.0).abs() < 0.011 && (size[1] - 400.0).abs() < 0.011,
        "{size:?}"
    );
    // Corner 0 is the lower left one, corner 1 the upper left.
    assert!(found[0][1] > found[1][1] && (found[0][0] - found[1][0]).abs() < 0.011);
    let view: Vec<f64> = values(&svg, "viewBox")[0]
        .split(' ')
        .map(|n| n.parse().expect("a number"))
        .collect();
    assert!(low[0] > 0.0 && low[1] > 0.0 && high[0] < view[2] && high[1] < view[3]);
    assert_eq!(values(&svg, "width")[0], view[2].to_string());
}

#[test]
fn panels_lie_apart_with_their_copies() {
    let sleeve = polygon("sleeve", &[[0.0, 0.0], [0.1, 0.3], [0.5, 0.35], [0.6, 0.0]]);
    let strip = polygon("band", &[[0.0, 0.0], [0.0, 0.02], [0.9, 0.02], [0.9, 0.0]]);
    let whole = pattern(vec![front(), sleeve, strip]);
    let whole = whole.with_copies(["sleeve~mirror", "front~mirror"]);
    let found = cloths(&drawing_svg(&whole));
    assert_eq!(found.len(), 5);
    for (i, a) in found.iter().enumerate() {
        for b in &found[..i] {
            let ([low, high], [start, end]) = (box_of(a), box_of(b));
            let apart = (0..2).any(|k| high[k] < start[k] || end[k] < low[k]);
            assert!(apart, "{a:?} {b:?}");
        }
    }
    // The copy is the image of its source: their boxes are alike, their first corners on opposite
    // sides.
    let left = |panel: &[Point2]| panel[0][0] - box_of(panel)[0][0];
    let right = |panel: &[Point2]| box_of(panel)[1][0] - panel[0][0];
    assert!((left(&found[1]) - right(&found[4])).abs() < 0.011);
}

#[test]
fn every_corner_and_edge_has_its_number() {
    let mut sleeve = polygon("sleeve", &[[0.0, 0.0], [0.1, 0.3], [0.5, 0.35], [0.6, 0.0]]);
    sleeve.internal_lines = vec![vec![[0.2, 0.1], [0.3, 0.1]]];
    let svg = drawing_svg(&pattern(vec![sleeve]));
    let numbers = |color: &str| {
        let group = svg
            .split("<g ")
            .nth(1)
            .expect("a panel")
            .split("</g>")
            .next()
            .expect("its end");
        let texts = group
            .split("<text ")
            .skip(1)
            .filter(|text| text.split('>').next().is_some_and(|t| t.contains(color)));
        let digits =
            texts.filter_map(|text| text.split('>').nth(1)?.split('<').next()?.parse().ok());
        digits.collect::<Vec<u32>>()
    };
    assert_eq!(numbers("fill=\"#0a7355\""), [0, 1, 2, 3]);
    assert_eq!(numbers("fill=\"#24313a\""), [0, 1, 2, 3]);
    assert_eq!(numbers("fill=\"#8a5a9c\""), [0]);
}

#[test]
fn what_a_panel_has_is_drawn_and_nothing_else() {
    let dashed = |svg: &str| values(svg, "stroke-dasharray").len();
    let bare = drawing_svg(&pattern(vec![front()]));
    assert_eq!(dashed(&bare), 0);
    assert!(!bare.contains("grain") && !bare.contains("fold") && !bare.contains("cut"));
    let mut panel = front();
    panel.unfolded = true;
    panel.grain = Some(Grain { angle_deg: 90.0 });
    panel.cut_line = vec![[-0.01, -0.01], [-0.01, 0.41], [0.31, 0.41], [0.31, -0.01]];
    panel.drill_holes = vec![[0.05, 0.3]];
    panel.notches = vec![Notch {
        index: 0,
        edge: 1,
        at: 0.2,
        kind: NotchKind::Slit,
        depth_m: Some(0.05),
    }];
    let svg = drawing_svg(&pattern(vec![panel]));
    // The cut line and the fold, each on the panel and in the legend.
    assert_eq!(dashed(&svg), 4);
    for word in ["grain", "fold", "cut"] {
        assert!(svg.contains(&format!(">{word}</text>")), "{word}");
    }
    let group = svg.split("<g ").nth(1).expect("a panel");
    let paths: Vec<Vec<Point2>> = values(group, "d").into_iter().map(points).collect();
    let line = |a: Point2, b: Point2| {
        let near = |p: Point2, q: Point2| (p[0] - q[0]).abs() < 0.02 && (p[1] - q[1]).abs() < 0.02;
        paths.iter().any(|p| {
            p.len() == 2 && (near(p[0], a) && near(p[1], b) || near(p[0], b) && near(p[1], a))
        })
    };
    // In the box of the cut line, y down: the outline begins at (10, 10). The fold is the middle
    // along the grain; the notch is 50 mm deep, a fifth along the top.
    assert!(line([160.0, 10.0], [160.0, 410.0]), "{paths:?}");
    assert!(line([70.0, 10.0], [70.0, 60.0]), "{paths:?}");
    let drills = group.matches("<circle").count();
    assert_eq!(drills, 1 + 4);
}

#[test]
fn names_of_uploads_can_do_nothing() {
    let evil = "</text><script>alert(1)</script>\" onload=\"x' & \u{0}\u{202e}]]>";
    let mut panel = front();
    panel.name = evil.to_owned();
    panel.id = evil.to_owned() + "2";
    panel.label = Some(evil.to_owned());
    let mut whole = pattern(vec![panel]);
    whole.name = evil.to_owned();
    whole.source.sample_size = Some(evil.to_owned());
    let svg = drawing_svg(&whole);
    assert!(!svg.contains("<script") && !svg.contains(" onload=\""));
    let tags = svg
        .split('<')
        .skip(1)
        .map(|tag| tag.split([' ', '>', '/']).find(|s| !s.is_empty()));
    for tag in tags.flatten() {
        let known = ["svg", "title", "rect", "g", "path", "circle", "text"];
        assert!(known.contains(&tag), "{tag}");
    }
    assert!(svg.chars().all(|c| !c.is_control() || c == '\n'));
    for attribute in ["href", "style", "class"] {
        assert!(!svg.contains(&format!(" {attribute}=")), "{attribute}");
    }
    let opened = svg.matches("<text ").count();
    assert_eq!(opened, svg.matches("</text>").count());
}

#[test]
fn the_same_pattern_gives_the_same_bytes_and_any_pattern_a_drawing() {
    let whole = pattern(vec![front()])
        .with_copies(["front~mirror"])
        .into_owned();
    assert_eq!(drawing_svg(&whole), drawing_svg(&whole.clone()));
    let mut empty = front();
    (empty.corners, empty.edges) = (vec![], vec![]);
    for odd in [pattern(vec![]), pattern(vec![empty])] {
        let svg = drawing_svg(&odd);
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
