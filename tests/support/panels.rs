//! Builders of panels with known answers. Coordinates in metres, y up, corners clockwise from the lower left one.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use seamster::pattern::{
    Allowance, Corner, Edge, Format, Hole, Notch, NotchKind, Panel, Pattern, Place, Run, SeamPair,
    Side, Source,
};

/// A panel with these edges, each a polyline from one corner to the next, clockwise.
pub fn panel_of(id: &str, edges: &[Vec<[f64; 2]>]) -> Panel {
    let count = edges.len();
    let outline: Vec<[f64; 2]> = edges
        .iter()
        .flat_map(|edge| edge[..edge.len() - 1].iter().copied())
        .collect();
    let next = |i: usize| outline[(i + 1) % outline.len()];
    let twice_area: f64 = (0..outline.len())
        .map(|i| next(i)[0] * outline[i][1] - outline[i][0] * next(i)[1])
        .sum();
    assert!(twice_area > 0.0, "the outline of {id} must run clockwise");
    let edges: Vec<Edge> = edges
        .iter()
        .enumerate()
        .map(|(index, points)| Edge {
            index,
            from: index,
            to: (index + 1) % count,
            length_m: points
                .windows(2)
                .map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]))
                .sum(),
            points: points.clone(),
            label: None,
        })
        .collect();
    let corners = edges
        .iter()
        .map(|edge| Corner {
            index: edge.index,
            x: edge.points[0][0],
            y: edge.points[0][1],
        })
        .collect();
    Panel {
        id: id.to_owned(),
        name: id.to_uppercase(),
        label: None,
        face: None,
        area_m2: twice_area / 2.0,
        perimeter_m: edges.iter().map(|edge| edge.length_m).sum(),
        drawn_area_m2: twice_area / 2.0,
        unfolded: false,
        copy_of: None,
        quantity: None,
        corners,
        edges,
        holes: vec![],
        cut_line: vec![],
        drill_holes: vec![],
        notches: vec![],
        grain: None,
        internal_lines: vec![],
    }
}

/// A panel with straight edges between these corners, clockwise.
pub fn polygon(id: &str, corners: &[[f64; 2]]) -> Panel {
    let edges: Vec<_> = (0..corners.len())
        .map(|i| vec![corners[i], corners[(i + 1) % corners.len()]])
        .collect();
    panel_of(id, &edges)
}

/// Edge 0 is the left side (upwards), 1 the top, 2 the right side (downwards), 3 the bottom.
pub fn rectangle(id: &str, width: f64, height: f64) -> Panel {
    trapezoid(id, width, width, height)
}

/// Like [`rectangle`], symmetrical, with a bottom and a top of different width.
pub fn trapezoid(id: &str, bottom: f64, top: f64, height: f64) -> Panel {
    let inset = (bottom - top) / 2.0;
    polygon(
        id,
        &[
            [0.0, 0.0],
            [inset, height],
            [inset + top, height],
            [bottom, 0.0],
        ],
    )
}

/// A rectangle with a dart in the middle of its top: edge 2 goes down to the tip, edge 3 up again;
/// edges 0, 1, 4, 5, 6 are the left side, the two parts of the top (1 and 4), the right side and the bottom.
pub fn darted(id: &str, [width, height]: [f64; 2], [intake, depth]: [f64; 2]) -> Panel {
    let middle = width / 2.0;
    polygon(
        id,
        &[
            [0.0, 0.0],
            [0.0, height],
            [middle - intake / 2.0, height],
            [middle, height - depth],
            [middle + intake / 2.0, height],
            [width, height],
            [width, 0.0],
        ],
    )
}

/// Two arcs of a circle between two corners: edge 0 is the upper one, edge 1 the lower one. Exactly symmetrical.
pub fn lens(id: &str, chord: f64, rise: f64, points: usize) -> Panel {
    let arc = |up: f64| -> Vec<[f64; 2]> {
        (0..=points)
            .map(|i| {
                let s = i as f64 / points as f64;
                [chord * s, up * rise * 4.0 * s * (1.0 - s)]
            })
            .collect()
    };
    let mut lower = arc(-1.0);
    lower.reverse();
    panel_of(id, &[arc(1.0), lower])
}

/// The same panel with a V notch.
pub fn notched(mut panel: Panel, edge: usize, at: f64) -> Panel {
    panel.notches.push(Notch {
        index: panel.notches.len(),
        edge,
        at,
        kind: NotchKind::V,
        depth_m: None,
    });
    panel
}

/// The mirrored copy of a panel, `<id>~mirror`: the same numbers, reflected x to -x.
pub fn mirrored(source: &Panel) -> Panel {
    let mut copy = source.clone();
    copy.id = format!("{}~mirror", source.id);
    copy.copy_of = Some(source.id.clone());
    let reflect = |corners: &mut Vec<Corner>, edges: &mut Vec<Edge>| {
        corners.iter_mut().for_each(|corner| corner.x = -corner.x);
        let points = edges.iter_mut().flat_map(|edge| &mut edge.points);
        points.for_each(|point| point[0] = -point[0]);
    };
    reflect(&mut copy.corners, &mut copy.edges);
    for hole in &mut copy.holes {
        reflect(&mut hole.corners, &mut hole.edges);
    }
    let lines = copy.internal_lines.iter_mut().flatten();
    lines.for_each(|point| point[0] = -point[0]);
    copy
}

/// The same panel with a hole of straight edges between these corners, counter-clockwise.
pub fn with_hole(mut panel: Panel, corners: &[[f64; 2]]) -> Panel {
    // Built clockwise, which is what panels are, and turned.
    let mut clockwise = corners.to_vec();
    clockwise.reverse();
    let hole = polygon("hole", &clockwise);
    let count = corners.len();
    panel.area_m2 -= hole.area_m2;
    panel.holes.push(Hole {
        corners: (0..count)
            .map(|index| Corner {
                index,
                x: corners[index][0],
                y: corners[index][1],
            })
            .collect(),
        edges: (0..count)
            .map(|index| {
                let points = vec![corners[index], corners[(index + 1) % count]];
                Edge {
                    index,
                    from: index,
                    to: (index + 1) % count,
                    length_m: (points[1][0] - points[0][0]).hypot(points[1][1] - points[0][1]),
                    points,
                    ..hole.edges[index].clone()
                }
            })
            .collect(),
    });
    panel
}

/// The same panel with an internal line.
pub fn with_line(mut panel: Panel, points: &[[f64; 2]]) -> Panel {
    panel.internal_lines.push(points.to_vec());
    panel
}

/// A pattern of these panels and nothing else.
pub fn pattern(panels: Vec<Panel>) -> Pattern {
    Pattern {
        id: None,
        name: "test".to_owned(),
        source: Source {
            format: Format::Dxf,
            units: "m".to_owned(),
            scale_to_m: 1.0,
            sample_size: None,
            sizes: vec![],
            allowance: Allowance::None,
        },
        panels,
        seams: vec![],
        placements: Default::default(),
        warnings: vec![],
    }
}

/// A run between two corners.
pub fn run(panel: &str, from: usize, to: usize) -> Run {
    Run {
        panel: panel.to_owned(),
        from: Place::Corner(from),
        to: Place::Corner(to),
        direction: None,
    }
}

/// A seam of two runs, with all options at their defaults.
pub fn seam(id: &str, a: Run, b: Run) -> SeamPair {
    many(id, vec![a], vec![b])
}

/// A seam of two lists of runs; a list of one is a single run.
pub fn many(id: &str, a: Vec<Run>, b: Vec<Run>) -> SeamPair {
    let side = |mut runs: Vec<Run>| match runs.len() {
        1 => Side::One(runs.remove(0)),
        _ => Side::Many(runs),
    };
    SeamPair {
        id: id.to_owned(),
        a: side(a),
        b: side(b),
        matching: Default::default(),
        stage: 0,
        gather: false,
        layered: false,
        allow_twist: false,
        confidence: None,
        because: None,
    }
}
