//! Meshing: exact cover, matched boundaries, bounded angles and sizes, on panels as garments have
//! them.

use seamster::config::Limits;
use seamster::mesh::{ClothMesh, Stitch, triangulate};
use seamster::pattern::{
    Allowance, Corner, Edge, Hole, Panel, Pattern, PatternFormat, Point2, Source,
};
use seamster::progress::CancelToken;
use seamster::seam::{Face, Seam, SeamSet, Stretch, Track};
use std::collections::BTreeSet;

/// The mesh edge length of most tests \[m\].
const H: f64 = 0.012;

fn ring(edges: Vec<Vec<Point2>>) -> (Vec<Corner>, Vec<Edge>) {
    let count = edges.len();
    let corner = |(index, edge): (usize, &Vec<Point2>)| Corner {
        index,
        x: edge[0][0],
        y: edge[0][1],
    };
    let corners = edges.iter().enumerate().map(corner).collect();
    let edge = |(index, points): (usize, Vec<Point2>)| Edge {
        index,
        from: index,
        to: (index + 1) % count,
        length_m: length(&points),
        points,
        label: None,
    };
    (corners, edges.into_iter().enumerate().map(edge).collect())
}

fn panel(id: &str, edges: Vec<Vec<Point2>>) -> Panel {
    let (corners, edges) = ring(edges);
    Panel {
        id: id.into(),
        name: id.into(),
        label: None,
        face: None,
        area_m2: 0.0,
        perimeter_m: 0.0,
        drawn_area_m2: 0.0,
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

/// A panel with straight edges between clockwise corners.
fn polygon(id: &str, corners: &[Point2]) -> Panel {
    let next = |i: usize| corners[(i + 1) % corners.len()];
    panel(
        id,
        (0..corners.len())
            .map(|i| vec![corners[i], next(i)])
            .collect(),
    )
}

/// Clockwise from the lower left: edge 0 left, 1 top, 2 right, 3 bottom.
fn rectangle(id: &str, width: f64, height: f64) -> Panel {
    polygon(
        id,
        &[[0.0, 0.0], [0.0, height], [width, height], [width, 0.0]],
    )
}

/// Points of an arc about `center`, angles in degrees.
fn arc(center: Point2, radius: f64, from: f64, to: f64) -> Vec<Point2> {
    let point = |i: i32| {
        let angle = (from + (to - from) * f64::from(i) / 40.0).to_radians();
        [
            center[0] + radius * angle.cos(),
            center[1] + radius * angle.sin(),
        ]
    };
    (0..=40).map(point).collect()
}

/// Half an A-line skirt: curved waist with a dart, slanted sides, curved hem.
fn a_line() -> Panel {
    let waist_left = [-0.17, 0.6];
    let waist_right = [0.17, 0.6];
    panel(
        "skirt",
        vec![
            vec![[-0.27, 0.01], [-0.225, 0.3], [-0.19, 0.5], waist_left],
            vec![waist_left, [-0.12, 0.592], [-0.09, 0.59]],
            vec![[-0.09, 0.59], [-0.08, 0.49]],
            vec![[-0.08, 0.49], [-0.07, 0.589]],
            vec![[-0.07, 0.589], [0.0, 0.587], [0.1, 0.591], waist_right],
            vec![waist_right, [0.19, 0.5], [0.225, 0.3], [0.27, 0.01]],
            arc(
                [0.0, 3.6],
                (0.27f64 * 0.27 + 3.59 * 3.59).sqrt(),
                -85.699_0,
                -94.301_0,
            )
            .into_iter()
            .enumerate()
            .map(|(i, p)| match i {
                0 => [0.27, 0.01],
                40 => [-0.27, 0.01],
                _ => p,
            })
            .collect(),
        ],
    )
}

/// Front of a top: straps, neck and armholes are concave arcs.
fn top() -> Panel {
    panel(
        "top",
        vec![
            vec![[-0.24, 0.0], [-0.23, 0.35]],
            join(
                &[[-0.23, 0.35]],
                &arc([-0.23, 0.47], 0.1, -80.0, 0.0),
                &[[-0.12, 0.58]],
            ),
            vec![[-0.12, 0.58], [-0.08, 0.59]],
            join(
                &[[-0.08, 0.59]],
                &arc([0.0, 0.56], 0.075, 180.0, 360.0),
                &[[0.08, 0.59]],
            ),
            vec![[0.08, 0.59], [0.12, 0.58]],
            join(
                &[[0.12, 0.58]],
                &arc([0.23, 0.47], 0.1, 180.0, 260.0),
                &[[0.23, 0.35]],
            ),
            vec![[0.23, 0.35], [0.24, 0.0]],
            vec![[0.24, 0.0], [-0.24, 0.0]],
        ],
    )
}

fn join(a: &[Point2], b: &[Point2], c: &[Point2]) -> Vec<Point2> {
    [a, b, c].concat()
}

fn pattern(panels: Vec<Panel>) -> Pattern {
    Pattern {
        id: None,
        name: "test".into(),
        source: Source {
            format: PatternFormat::Dxf,
            units: "m".into(),
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

fn stretch(panel: usize, edge: usize, from: f64, to: f64) -> Stretch {
    Stretch {
        panel,
        track: Track::Outline,
        edge,
        from,
        to,
    }
}

fn seam(id: &str, matched: Vec<[Stretch; 2]>) -> Seam {
    Seam {
        id: id.into(),
        stage: 0,
        matched,
    }
}

fn seam_set(pattern: &Pattern, seams: Vec<Seam>) -> SeamSet {
    SeamSet {
        seams,
        faces: vec![Face::Up; pattern.panels.len()],
    }
}

fn mesh(panels: Vec<Panel>, seams: Vec<Seam>) -> ClothMesh {
    mesh_at(panels, seams, H)
}

fn mesh_at(panels: Vec<Panel>, seams: Vec<Seam>, edge_length: f64) -> ClothMesh {
    let pattern = pattern(panels);
    let seams = seam_set(&pattern, seams);
    let limits = Limits::default();
    triangulate(&pattern, &seams, edge_length, &limits, &CancelToken::new())
        .expect("the panel is sound")
}

fn fault_codes(panels: Vec<Panel>, edge_length: f64, limits: &Limits) -> Vec<String> {
    let pattern = pattern(panels);
    let seams = seam_set(&pattern, vec![]);
    let result = triangulate(&pattern, &seams, edge_length, limits, &CancelToken::new());
    let faults = result.expect_err("the panel is not sound").0;
    faults
        .into_iter()
        .map(|fault| fault.code.to_string())
        .collect()
}

fn distance(a: Point2, b: Point2) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn length(points: &[Point2]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

fn area([a, b, c]: [Point2; 3]) -> f64 {
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
}

fn corners(mesh: &ClothMesh, triangle: [usize; 3]) -> [Point2; 3] {
    triangle.map(|v| mesh.uv[v])
}

/// Mesh edges that have one triangle only, in the direction of that triangle.
fn border(mesh: &ClothMesh) -> Vec<[usize; 2]> {
    let all: BTreeSet<[usize; 2]> = directed_edges(mesh).collect();
    all.iter()
        .copied()
        .filter(|&[a, b]| !all.contains(&[b, a]))
        .collect()
}

fn directed_edges(mesh: &ClothMesh) -> impl Iterator<Item = [usize; 2]> + '_ {
    let turns = |[a, b, c]: &[usize; 3]| [[*a, *b], [*b, *c], [*c, *a]];
    mesh.triangles.iter().flat_map(turns)
}

/// Smallest angle of a triangle in degrees, by the law of cosines.
fn smallest_angle(mesh: &ClothMesh, triangle: [usize; 3]) -> f64 {
    let [a, b, c] = corners(mesh, triangle);
    let mut sides = [distance(a, b), distance(b, c), distance(c, a)];
    sides.sort_by(f64::total_cmp);
    let [x, y, z] = sides;
    ((y * y + z * z - x * x) / (2.0 * y * z))
        .acos()
        .to_degrees()
}

fn mesh_edges(mesh: &ClothMesh) -> BTreeSet<[usize; 2]> {
    directed_edges(mesh)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect()
}

/// The border walked once round from a corner, clockwise as outlines are stored.
fn walk(mesh: &ClothMesh, start: usize) -> Vec<usize> {
    let before = |v: usize| {
        border(mesh)
            .into_iter()
            .find(|e| e[1] == v)
            .expect("a ring")[0]
    };
    let mut ring = vec![start];
    loop {
        let next = before(ring[ring.len() - 1]);
        if next == start {
            return ring;
        }
        ring.push(next);
    }
}

fn panels_of_garments() -> Vec<Panel> {
    vec![
        rectangle("rectangle", 0.4, 0.6),
        rectangle("waistband", 0.72, 0.03),
        rectangle("binding", 0.5, 0.008),
        a_line(),
        top(),
    ]
}

#[test]
fn triangles_cover_exactly_the_polygon_of_the_boundary() {
    for panel in panels_of_garments() {
        let name = panel.id.clone();
        let mesh = mesh(vec![panel], vec![]);
        let covered: f64 = mesh
            .triangles
            .iter()
            .map(|t| area(corners(&mesh, *t)))
            .sum();
        let ring = walk(&mesh, mesh.panels[0].corners[0]);
        assert_eq!(ring.len(), border(&mesh).len(), "{name}: one ring");
        let polygon: f64 = (0..ring.len())
            .map(|i| {
                let (a, b) = (mesh.uv[ring[i]], mesh.uv[ring[(i + 1) % ring.len()]]);
                0.5 * (b[0] * a[1] - a[0] * b[1])
            })
            .sum();
        assert!(
            (covered - polygon).abs() < 1e-12 * polygon,
            "{name}: {covered} {polygon}"
        );
    }
}

#[test]
fn every_triangle_is_counter_clockwise() {
    for panel in panels_of_garments() {
        let mesh = mesh(vec![panel], vec![]);
        assert!(!mesh.triangles.is_empty());
        assert!(
            mesh.triangles
                .iter()
                .all(|t| area(corners(&mesh, *t)) > 0.0)
        );
    }
}

#[test]
fn a_panel_is_a_disc_and_every_vertex_is_used() {
    for panel in panels_of_garments() {
        let mesh = mesh(vec![panel], vec![]);
        let used: BTreeSet<usize> = mesh.triangles.iter().flatten().copied().collect();
        assert_eq!(used.len(), mesh.uv.len());
        let euler = mesh.uv.len() + mesh.triangles.len() - mesh_edges(&mesh).len();
        assert_eq!(euler, 1);
    }
}

#[test]
fn angles_are_at_least_20_degrees_where_the_outline_allows() {
    for panel in [
        rectangle("rectangle", 0.4, 0.6),
        rectangle("waistband", 0.72, 0.03),
        a_line(),
        top(),
    ] {
        for edge_length in [0.006, 0.012, 0.02] {
            let name = panel.id.clone();
            let mesh = mesh_at(vec![panel.clone()], vec![], edge_length);
            let angles = mesh.triangles.iter().map(|t| smallest_angle(&mesh, *t));
            let smallest = angles.fold(180.0, f64::min);
            println!(
                "{name} at {edge_length}: {smallest:.1} degrees, {} vertices",
                mesh.uv.len()
            );
            assert!(smallest >= 20.0, "{name} at {edge_length}: {smallest}");
        }
    }
}

#[test]
fn a_sharp_corner_forces_thin_triangles_only_at_itself() {
    // Ten degrees at the origin: the sides are nearer to each other than a mesh edge up to 0.07 m
    // from it.
    let gusset = polygon("gusset", &[[0.0, 0.0], [-0.035, 0.4], [0.035, 0.4]]);
    let mesh = mesh(vec![gusset], vec![]);
    for &triangle in &mesh.triangles {
        let angle = smallest_angle(&mesh, triangle);
        let farthest = corners(&mesh, triangle)
            .map(|p| p[1])
            .into_iter()
            .fold(0.0, f64::max);
        assert!(angle >= 20.0 || farthest < 0.1, "{angle} at {farthest}");
    }
}

#[test]
fn no_angle_is_smaller_than_20_degrees_or_the_outlines_own() {
    let mut seed = 1_u64;
    // Knuth's linear congruential generator.
    let mut random = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / (1_u64 << 31) as f64
    };
    for trial in 0..100 {
        let count = 4 + trial % 8;
        let corner = |i: usize| {
            let turn = (i as f64 + 0.9 * random()) / count as f64;
            let (s, c) = (-std::f64::consts::TAU * turn).sin_cos();
            let radius = 0.03 + 0.2 * random();
            [radius * c, radius * s]
        };
        let outline: Vec<Point2> = (0..count).map(corner).collect();
        let at = |i: usize| outline[i % count];
        let own = (0..count)
            .map(|i| angle(at(i), at(i + 1), at(i + 2)))
            .fold(180.0, f64::min);
        let mesh = mesh(vec![polygon("star", &outline)], vec![]);
        let angles = mesh.triangles.iter().map(|t| smallest_angle(&mesh, *t));
        let smallest = angles.fold(180.0, f64::min);
        // An outline's angle may be split once between two triangles.
        assert!(
            smallest >= 20.0_f64.min(0.5 * own),
            "{smallest} {own} {outline:?}"
        );
    }
}

/// Angle at `b` from `a` to `c` in degrees, 0 to 180.
fn angle(a: Point2, b: Point2, c: Point2) -> f64 {
    let (u, v) = ([a[0] - b[0], a[1] - b[1]], [c[0] - b[0], c[1] - b[1]]);
    let cosine = (u[0] * v[0] + u[1] * v[1]) / (u[0].hypot(u[1]) * v[0].hypot(v[1]));
    cosine.acos().to_degrees()
}

#[test]
fn a_gathered_edge_keeps_its_angles() {
    let panels = vec![rectangle("waist", 0.4, 0.3), rectangle("skirt", 0.4, 0.55)];
    let gathers = vec![[stretch(0, 0, 0.0, 1.0), stretch(1, 0, 1.0, 0.0)]];
    let mesh = mesh(panels, vec![seam("gathers", gathers)]);
    let angles = mesh.triangles.iter().map(|t| smallest_angle(&mesh, *t));
    let smallest = angles.fold(180.0, f64::min);
    assert!(smallest >= 20.0, "{smallest}");
}

#[test]
fn mesh_edges_are_near_the_length_asked_for() {
    for panel in [
        rectangle("rectangle", 0.4, 0.6),
        rectangle("waistband", 0.72, 0.03),
        a_line(),
        top(),
    ] {
        let name = panel.id.clone();
        let mesh = mesh(vec![panel], vec![]);
        for [a, b] in mesh_edges(&mesh) {
            let share = distance(mesh.uv[a], mesh.uv[b]) / H;
            assert!(
                (0.5..=1.6).contains(&share),
                "{name}: {share} at {:?}",
                mesh.uv[a]
            );
        }
    }
}

#[test]
fn points_along_an_edge_are_evenly_spaced() {
    let mesh = mesh(vec![rectangle("r", 0.4, 0.6)], vec![]);
    let ring = walk(&mesh, mesh.panels[0].corners[0]);
    let top = ring
        .iter()
        .position(|&v| v == mesh.panels[0].corners[1])
        .unwrap();
    assert_eq!(top, 50);
    for pair in ring[..=top].windows(2) {
        assert!((distance(mesh.uv[pair[0]], mesh.uv[pair[1]]) - 0.012).abs() < 1e-12);
    }
}

#[test]
fn corners_are_vertices_exactly() {
    let panel = top();
    let mesh = mesh(vec![panel.clone()], vec![]);
    assert_eq!(mesh.panels[0].corners.len(), panel.corners.len());
    for (corner, &vertex) in panel.corners.iter().zip(&mesh.panels[0].corners) {
        assert_eq!(mesh.uv[vertex], [corner.x, corner.y]);
    }
}

#[test]
fn both_sides_of_a_seam_get_equally_many_points() {
    // 0.6 m against 0.66 m: 55 parts for both, from the longer.
    let panels = vec![rectangle("a", 0.3, 0.6), rectangle("b", 0.3, 0.66)];
    let seams = vec![seam(
        "side",
        vec![[stretch(0, 2, 0.0, 1.0), stretch(1, 0, 1.0, 0.0)]],
    )];
    let mesh = mesh(panels, seams);
    assert_eq!(mesh.stitches.len(), 56);
    let (a, b) = (&mesh.panels[0].corners, &mesh.panels[1].corners);
    assert_eq!((mesh.stitches[0].a, mesh.stitches[0].b), (a[2], b[1]));
    assert_eq!((mesh.stitches[55].a, mesh.stitches[55].b), (a[3], b[0]));
    for (i, stitch) in mesh.stitches.iter().enumerate() {
        let share = i as f64 / 55.0;
        assert!((mesh.uv[stitch.a][1] - 0.6 * (1.0 - share)).abs() < 1e-12);
        assert!((mesh.uv[stitch.b][1] - 0.66 * (1.0 - share)).abs() < 1e-12);
    }
}

#[test]
fn a_stretch_may_end_inside_an_edge() {
    let panels = vec![rectangle("a", 0.3, 0.6), rectangle("b", 0.3, 0.2)];
    let matched = vec![[
        stretch(0, 0, 0.25, 0.25 + 1.0 / 3.0),
        stretch(1, 0, 1.0, 0.0),
    ]];
    let mesh = mesh(panels, vec![seam("pocket", matched)]);
    let first = mesh.uv[mesh.stitches[0].a];
    let last = mesh.uv[mesh.stitches[mesh.stitches.len() - 1].a];
    assert!(distance(first, [0.0, 0.15]) < 1e-12 && distance(last, [0.0, 0.35]) < 1e-12);
}

#[test]
fn counts_agree_through_chains_of_layered_seams() {
    // The middle panel meets a short and a much longer one over the same edge, the long one only by
    // half.
    let panels = vec![
        rectangle("a", 0.3, 0.3),
        rectangle("b", 0.3, 0.3),
        rectangle("c", 0.3, 0.45),
    ];
    let seams = vec![
        seam(
            "one",
            vec![[stretch(0, 0, 0.0, 1.0), stretch(1, 0, 1.0, 0.0)]],
        ),
        seam(
            "two",
            vec![[stretch(1, 0, 0.0, 0.5), stretch(2, 0, 0.0, 1.0)]],
        ),
    ];
    let mesh = mesh(panels, seams);
    let of = |index: usize| -> Vec<&Stitch> {
        mesh.stitches.iter().filter(|s| s.seam == index).collect()
    };
    // 0.45 m needs 38 parts; the other half of the 0.3 m edge 13 of its own.
    assert_eq!((of(0).len(), of(1).len()), (38 + 13 + 1, 39));
    let on_b: BTreeSet<usize> = of(0).iter().map(|s| s.b).collect();
    assert!(of(1).iter().all(|s| on_b.contains(&s.a)));
}

#[test]
fn consecutive_stretches_share_one_stitch_at_the_corner() {
    let panels = vec![rectangle("a", 0.3, 0.6), rectangle("b", 0.3, 0.6)];
    let matched = vec![
        [stretch(0, 0, 0.0, 1.0), stretch(1, 0, 0.0, 1.0)],
        [stretch(0, 1, 0.0, 1.0), stretch(1, 1, 0.0, 1.0)],
    ];
    let mesh = mesh(panels, vec![seam("long", matched)]);
    assert_eq!(mesh.stitches.len(), 50 + 25 + 1);
    let pairs: BTreeSet<_> = mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    assert_eq!(pairs.len(), mesh.stitches.len());
}

#[test]
fn a_fold_is_not_sewn_to_itself() {
    let matched = vec![[stretch(0, 1, 0.0, 0.5), stretch(0, 1, 1.0, 0.5)]];
    let mesh = mesh(vec![rectangle("a", 0.3, 0.6)], vec![seam("dart", matched)]);
    assert_eq!(mesh.stitches.len(), 13);
    assert!(mesh.stitches.iter().all(|s| s.a != s.b));
}

#[test]
fn holes_are_cut_out() {
    let mut panel = rectangle("r", 0.3, 0.3);
    let square = [[0.1, 0.1], [0.2, 0.1], [0.2, 0.2], [0.1, 0.2]];
    let edges = (0..4)
        .map(|i| vec![square[i], square[(i + 1) % 4]])
        .collect();
    let (corners_of_hole, edges) = ring(edges);
    panel.holes = vec![Hole {
        corners: corners_of_hole,
        edges,
    }];
    let mesh = mesh(vec![panel], vec![]);
    let covered: f64 = mesh
        .triangles
        .iter()
        .map(|t| area(corners(&mesh, *t)))
        .sum();
    assert!((covered - 0.08).abs() < 1e-14);
    assert_eq!(
        mesh.uv.len() + mesh.triangles.len(),
        mesh_edges(&mesh).len()
    );
}

#[test]
fn a_round_panel_of_one_edge_is_meshed() {
    let circle = panel("disc", vec![arc([0.2, 0.1], 0.1, 360.0, 0.0)]);
    let fine = mesh(vec![circle.clone()], vec![]);
    assert!(fine.triangles.len() > 300);
    // At an edge length above its size it is still a polygon.
    let coarse = mesh_at(
        vec![panel("dot", vec![arc([0.0, 0.0], 0.01, 360.0, 0.0)])],
        vec![],
        0.1,
    );
    assert_eq!(coarse.triangles.len(), 1);
}

#[test]
fn same_input_gives_the_same_mesh() {
    let make = || mesh(vec![a_line(), top()], vec![]);
    assert_eq!(make(), make());
}

#[test]
fn a_moved_and_turned_panel_gets_as_many_vertices() {
    let turned = |panel: &Panel, degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        let turn = |[x, y]: Point2| [c * x - s * y + 3.0, s * x + c * y - 1.0];
        let edges = panel.edges.iter();
        let edges = edges.map(|e| e.points.iter().map(|p| turn(*p)).collect());
        self::panel(&panel.id, edges.collect())
    };
    for panel in panels_of_garments() {
        let first = mesh(vec![panel.clone()], vec![]);
        for degrees in [17.0, 90.0, 233.0] {
            let other = mesh(vec![turned(&panel, degrees)], vec![]);
            let counts = (other.uv.len(), other.triangles.len());
            assert_eq!(
                counts,
                (first.uv.len(), first.triangles.len()),
                "{}",
                panel.id
            );
        }
    }
}

#[test]
fn crossing_outlines_are_named() {
    let bow_tie = polygon("bow", &[[0.0, 0.0], [0.3, 0.3], [0.3, 0.0], [0.0, 0.3]]);
    let touching = polygon(
        "touching",
        &[[0.0, 0.0], [0.0, 0.3], [0.15, 0.0], [0.3, 0.3], [0.3, 0.0]],
    );
    let limits = Limits::default();
    let codes = fault_codes(
        vec![bow_tie, rectangle("r", 0.1, 0.1), touching],
        H,
        &limits,
    );
    assert_eq!(codes, ["mesh/crossing", "mesh/crossing"]);
}

#[test]
fn a_flat_outline_is_refused() {
    let flat = polygon("flat", &[[0.0, 0.0], [0.1, 0.0], [0.2, 0.0]]);
    assert_eq!(
        fault_codes(vec![flat], H, &Limits::default()),
        ["mesh/crossing"]
    );
    let point = polygon("point", &[[0.1, 0.1]; 3]);
    assert_eq!(
        fault_codes(vec![point], H, &Limits::default()),
        ["mesh/outline"]
    );
    let nan = polygon("nan", &[[0.0, 0.0], [0.0, f64::NAN], [1.0, 0.0]]);
    assert_eq!(
        fault_codes(vec![nan], H, &Limits::default()),
        ["mesh/outline"]
    );
}

#[test]
fn a_hole_outside_is_refused() {
    let mut panel = rectangle("r", 0.3, 0.3);
    let (corners, edges) = ring(vec![arc([0.5, 0.1], 0.05, 0.0, 360.0)]);
    panel.holes = vec![Hole { corners, edges }];
    assert_eq!(
        fault_codes(vec![panel], H, &Limits::default()),
        ["mesh/stray_hole"]
    );
}

#[test]
fn too_fine_a_mesh_is_refused_before_the_work() {
    let limits = Limits {
        mesh_vertices: 1_000,
        ..Limits::default()
    };
    let codes = fault_codes(vec![rectangle("r", 1.0, 1.0)], H, &limits);
    assert_eq!(codes, ["mesh/too_fine"]);
    for edge_length in [1e-9, 10.0, f64::NAN] {
        let codes = fault_codes(vec![rectangle("r", 1.0, 1.0)], edge_length, &limits);
        assert_eq!(codes, ["mesh/edge_length"]);
    }
}

#[test]
fn a_raised_token_stops_meshing() {
    let pattern = pattern(vec![rectangle("r", 0.3, 0.3)]);
    let seams = seam_set(&pattern, vec![]);
    let cancel = CancelToken::new();
    cancel.cancel();
    let result = triangulate(&pattern, &seams, H, &Limits::default(), &cancel);
    assert_eq!(result.unwrap_err().0[0].code, "fit/canceled");
}
