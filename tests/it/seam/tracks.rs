//! Seams on mirrored copies, holes and internal lines, checked and meshed.

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::mesh::{ClothMesh, triangulate};
use seamster::pattern::{Direction, OutlineRun, Panel, Pattern, Place, SeamPair};
use seamster::progress::CancelToken;
use seamster::seam::{Face, SeamCheck, SeamSet, Track, check};
use seamster_fixtures::panels::{
    lens, many, mirrored, pattern, polygon, rectangle, run, seam, with_hole, with_line,
};
use std::collections::{BTreeMap, BTreeSet};

const H: f64 = 0.012;

fn checked(pattern: &Pattern, pairs: &[SeamPair]) -> (SeamCheck, Result<SeamSet, Faults>) {
    check(pattern, pairs, &BTreeMap::new(), H, &Limits::default())
}

fn sewn(pattern: &Pattern, pairs: &[SeamPair]) -> SeamSet {
    checked(pattern, pairs).1.expect("the seams are right")
}

fn codes(pattern: &Pattern, pairs: &[SeamPair]) -> Vec<(String, String)> {
    let faults = checked(pattern, pairs).1.expect_err("a seam is wrong").0;
    faults
        .into_iter()
        .map(|f| (f.code.to_string(), f.pointer))
        .collect()
}

fn mesh(pattern: &Pattern, set: &SeamSet) -> Result<ClothMesh, Faults> {
    triangulate(pattern, set, H, &Limits::default(), &CancelToken::new())
}

fn meshed(pattern: &Pattern, pairs: &[SeamPair]) -> ClothMesh {
    mesh(pattern, &sewn(pattern, pairs)).expect("the panels are sound")
}

fn between(panel: &str, from: Place, to: Place, direction: Option<Direction>) -> OutlineRun {
    OutlineRun {
        panel: panel.to_owned(),
        from,
        to,
        direction,
    }
}

fn on_line(panel: &str, [from, to]: [f64; 2]) -> OutlineRun {
    let place = |at| Place::OnLine { line: 0, at };
    between(panel, place(from), place(to), None)
}

fn round_hole(panel: &str, corner: usize, direction: Direction) -> OutlineRun {
    let place = Place::HoleCorner { hole: 0, corner };
    between(panel, place, place, Some(direction))
}

fn layered(pair: SeamPair) -> SeamPair {
    SeamPair {
        layered: true,
        ..pair
    }
}

/// A T-shirt's front or back as seen from its outer side, symmetrical: armholes are edges 1 (left
/// as drawn) and 5.
fn shirt(id: &str) -> Panel {
    polygon(
        id,
        &[
            [-0.25, 0.0],
            [-0.25, 0.4],
            [-0.2, 0.6],
            [-0.08, 0.63],
            [0.08, 0.63],
            [0.2, 0.6],
            [0.25, 0.4],
            [0.25, 0.0],
        ],
    )
}

/// A sleeve as seen from its outer side. Edge 0 is the underarm seam of the front of a left sleeve,
/// edges 1 and 2 the cap (front half first), 3 the underarm seam of the back, 4 the hem.
fn sleeve(id: &str) -> Panel {
    let armhole = 0.05_f64.hypot(0.2);
    let half = 0.16;
    let rise = (armhole * armhole - half * half).sqrt();
    polygon(
        id,
        &[
            [-half, 0.0],
            [-half, 0.15],
            [0.0, 0.15 + rise],
            [half, 0.15],
            [half, 0.0],
        ],
    )
}

/// A T-shirt whose right sleeve is the mirrored copy of the left one. All panels show their outer
/// side. On the wearer's left the front's armhole is edge 5 (drawn on the right), the back's is
/// edge 1.
fn shirt_with_mirrored_sleeve() -> (Pattern, Vec<SeamPair>) {
    let sleeve = sleeve("sleeve");
    let copy = mirrored(&sleeve);
    let pattern = pattern(vec![shirt("front"), shirt("back"), sleeve, copy]);
    let pairs = vec![
        seam("side-l", run("front", 7, 6), run("back", 0, 1)),
        seam("side-r", run("front", 0, 1), run("back", 7, 6)),
        seam("shoulder-l", run("front", 4, 5), run("back", 3, 2)),
        seam("shoulder-r", run("front", 3, 2), run("back", 4, 5)),
        // The cap up the front's armhole, then down the back's.
        many(
            "armhole-l",
            vec![run("sleeve", 1, 2), run("sleeve", 2, 3)],
            vec![run("front", 6, 5), run("back", 2, 1)],
        ),
        many(
            "armhole-r",
            vec![run("sleeve~mirror", 1, 2), run("sleeve~mirror", 2, 3)],
            vec![run("front", 1, 2), run("back", 5, 6)],
        ),
        seam("under-l", run("sleeve", 0, 1), run("sleeve", 4, 3)),
        seam(
            "under-r",
            run("sleeve~mirror", 0, 1),
            run("sleeve~mirror", 4, 3),
        ),
    ];
    (pattern, pairs)
}

fn turned(pair: &SeamPair) -> SeamPair {
    let turn = |run: &OutlineRun| between(&run.panel, run.to, run.from, run.direction);
    let b = pair.b.runs().iter().rev().map(turn).collect();
    SeamPair {
        b: many("", b, vec![run("", 0, 0)]).a,
        ..pair.clone()
    }
}

#[test]
fn mirrored_sleeve_is_sewn_with_its_outer_side_out() {
    let (pattern, pairs) = shirt_with_mirrored_sleeve();
    let set = sewn(&pattern, &pairs);
    assert_eq!(set.faces, [Face::Up; 4]);
}

#[test]
fn each_reversed_seam_of_a_shirt_with_a_mirrored_sleeve_is_twisted_and_put_right() {
    let (pattern, pairs) = shirt_with_mirrored_sleeve();
    for wrong in [0, 1, 2, 3, 6, 7] {
        let mut reversed = pairs.clone();
        reversed[wrong] = turned(&pairs[wrong]);
        let found = codes(&pattern, &reversed);
        let expected = ("seam/twisted".to_owned(), format!("/seams/{wrong}"));
        assert_eq!(found, [expected]);
        let (check, _) = checked(&pattern, &reversed);
        assert_eq!(check.corrected, [pairs[wrong].clone()]);
    }
}

#[test]
fn sleeve_sewn_in_by_one_seam_is_inside_out_where_that_is_reversed() {
    let (pattern, pairs) = shirt_with_mirrored_sleeve();
    for (wrong, panel) in [(4, 2), (5, 3)] {
        let mut reversed = pairs.clone();
        reversed[wrong] = turned(&pairs[wrong]);
        let mut faces = [Face::Up; 4];
        faces[panel] = Face::Down;
        assert_eq!(sewn(&pattern, &reversed).faces, faces);
    }
}

#[test]
fn copy_gets_the_mirror_image_of_its_sources_mesh() {
    let (pattern, pairs) = shirt_with_mirrored_sleeve();
    let mesh = meshed(&pattern, &pairs);
    let [source, copy] = [2, 3].map(|i| &mesh.panels[i]);
    let reflected: Vec<_> = mesh.uv[source.vertices.clone()]
        .iter()
        .map(|[x, y]| [-x, *y])
        .collect();
    assert_eq!(mesh.uv[copy.vertices.clone()], reflected);
    let offset = copy.vertices.start - source.vertices.start;
    let sets = [source, copy].map(|panel| {
        let triangles = mesh.triangles[panel.triangles.clone()].iter();
        let sorted = triangles.map(|t| {
            let mut t = *t;
            t.sort_unstable();
            t
        });
        sorted.collect::<BTreeSet<_>>()
    });
    let moved: BTreeSet<_> = sets[0].iter().map(|t| t.map(|v| v + offset)).collect();
    assert_eq!(moved, sets[1]);
    assert!(mesh.triangles.iter().all(|t| area(&mesh, *t) > 0.0));
}

#[test]
fn stitches_of_a_copy_are_those_of_its_source() {
    let (pattern, pairs) = shirt_with_mirrored_sleeve();
    let mesh = meshed(&pattern, &pairs);
    let offset = mesh.panels[3].vertices.start - mesh.panels[2].vertices.start;
    let of = |seam: usize| mesh.stitches.iter().filter(move |s| s.seam == seam);
    let left: Vec<_> = of(4).map(|s| s.a + offset).collect();
    let right: Vec<_> = of(5).map(|s| s.a).collect();
    assert_eq!(left, right);
    // The other side is drawn symmetrical: what the right sleeve is sewn to is the mirror image.
    for (l, r) in of(4).zip(of(5)) {
        let (l, r) = (mesh.uv[l.b], mesh.uv[r.b]);
        assert!((l[0] + r[0]).abs() < 1e-12 && (l[1] - r[1]).abs() < 1e-12);
    }
}

fn area(mesh: &ClothMesh, triangle: [usize; 3]) -> f64 {
    let [a, b, c] = triangle.map(|v| mesh.uv[v]);
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
}

/// A square panel with a square hole of 0.1 m a side; corner 0 of the hole is its lower left one.
fn holed(id: &str) -> Panel {
    with_hole(
        rectangle(id, 0.3, 0.3),
        &[[0.1, 0.1], [0.2, 0.1], [0.2, 0.2], [0.1, 0.2]],
    )
}

/// A strip whose top (edge 1) goes round the hole, and whose ends (edges 0 and 2) are sewn
/// together.
fn tube_into_hole(direction: Direction) -> (Pattern, Vec<SeamPair>) {
    let pattern = pattern(vec![holed("body"), rectangle("sleeve", 0.4, 0.2)]);
    let pairs = vec![
        seam(
            "armhole",
            run("sleeve", 1, 2),
            round_hole("body", 0, direction),
        ),
        seam("under", run("sleeve", 0, 1), run("sleeve", 3, 2)),
    ];
    (pattern, pairs)
}

#[test]
fn cloth_lies_on_one_side_of_holes_and_outlines_when_the_way_is_cw() {
    // Gone the same way by index, faces differ, as they do along two outlines.
    for (direction, face) in [(Direction::Cw, Face::Down), (Direction::Ccw, Face::Up)] {
        let (pattern, pairs) = tube_into_hole(direction);
        assert_eq!(sewn(&pattern, &pairs).faces, [Face::Up, face]);
    }
}

#[test]
fn sleeve_is_sewn_into_a_hole_point_by_point() {
    let (pattern, pairs) = tube_into_hole(Direction::Ccw);
    let (check, set) = checked(&pattern, &pairs);
    let mesh = mesh(&pattern, &set.expect("right")).expect("sound");
    let armhole: Vec<_> = mesh.stitches.iter().filter(|s| s.seam == 0).collect();
    // 0.1 m a side in mesh edges of 12 mm: 9 parts; the first and last stitch of the strip meet one
    // and the same point.
    assert_eq!(armhole.len(), 4 * 9 + 1);
    assert_eq!(armhole[0].b, armhole[36].b);
    assert_eq!(mesh.uv[armhole[0].b], [0.1, 0.1]);
    // Against the order of corners the way first goes up the left side.
    assert!((mesh.uv[armhole[9].b][1] - 0.2).abs() < 1e-12);
    assert_eq!(check.seams[0].length_b_m, 0.4);
    for stitch in &armhole {
        let [x, y] = mesh.uv[stitch.b];
        let inside = |c: f64| (0.1 - 1e-12..=0.2 + 1e-12).contains(&c);
        assert!(inside(x) && inside(y));
    }
}

#[test]
fn collar_of_two_halves_is_sewn_to_a_round_neck_hole() {
    // A lens-shaped hole of two edges; each half of the collar takes one.
    let ring = lens("neck", 0.2, 0.06, 24);
    let mut body = rectangle("body", 0.4, 0.4);
    let shift = |p: &[f64; 2]| [p[0] + 0.1, p[1] + 0.2];
    let mut edges: Vec<_> = ring.edges.iter().rev().cloned().collect();
    for (index, edge) in edges.iter_mut().enumerate() {
        edge.points.reverse();
        edge.points = edge.points.iter().map(shift).collect();
        (edge.index, edge.from, edge.to) = (index, index, 1 - index);
    }
    let corners = edges
        .iter()
        .map(|edge| seamster::pattern::Corner {
            index: edge.index,
            x: edge.points[0][0],
            y: edge.points[0][1],
        })
        .collect();
    let length = edges[0].length_m;
    body.holes.push(seamster::pattern::Hole { corners, edges });
    let pattern = pattern(vec![
        body,
        rectangle("collar-a", length, 0.04),
        rectangle("collar-b", length, 0.04),
    ]);
    let half = |edge, [from, to]: [f64; 2]| {
        let place = |at| Place::OnHoleEdge { hole: 0, edge, at };
        let way = if from < to {
            Direction::Cw
        } else {
            Direction::Ccw
        };
        between("body", place(from), place(to), Some(way))
    };
    let pairs = [
        seam("neck-a", run("collar-a", 0, 3), half(0, [0.0, 1.0])),
        seam("neck-b", run("collar-b", 0, 3), half(1, [0.0, 1.0])),
        seam("collar-1", run("collar-a", 3, 2), run("collar-b", 0, 1)),
        seam("collar-2", run("collar-b", 3, 2), run("collar-a", 0, 1)),
    ];
    let set = sewn(&pattern, &pairs);
    assert_eq!(set.faces, [Face::Up; 3]);
    let mesh = mesh(&pattern, &set).expect("sound");
    let count = |seam| mesh.stitches.iter().filter(|s| s.seam == seam).count();
    assert_eq!(count(0), check_count(length));
    assert_eq!(count(1), check_count(length));
    let mut wrong = pairs.to_vec();
    wrong[1] = seam("neck-b", run("collar-b", 0, 3), half(1, [1.0, 0.0]));
    let found = codes(&pattern, &wrong);
    assert_eq!(found, [("seam/twisted".to_owned(), "/seams/1".to_owned())]);
}

/// Stitches along an open seam of this length.
fn check_count(length: f64) -> usize {
    seamster::seam::division_count(length, length, H) + 1
}

/// A front with a U-shaped line for a pocket, and the pocket: its left side, bottom and right side
/// are as long as the line.
fn pocket() -> (Pattern, SeamPair) {
    let line = [[0.1, 0.3], [0.1, 0.18], [0.22, 0.18], [0.22, 0.3]];
    let front = with_line(rectangle("front", 0.4, 0.6), &line);
    let pattern = pattern(vec![front, rectangle("pocket", 0.12, 0.12)]);
    let sides = [[1, 0], [0, 3], [3, 2]].map(|[from, to]| run("pocket", from, to));
    let line = vec![on_line("front", [0.0, 1.0])];
    (pattern, layered(many("pocket", sides.to_vec(), line)))
}

#[test]
fn pocket_is_sewn_onto_a_line_inside_a_front() {
    let (pattern, pair) = pocket();
    let (check, set) = checked(&pattern, std::slice::from_ref(&pair));
    let set = set.expect("right");
    // A line has cloth on both sides: nothing turns the pocket over.
    assert_eq!(set.faces, [Face::Up, Face::Up]);
    let reversed = sewn(&pattern, &[turned(&pair)]);
    assert_eq!(reversed.faces, [Face::Up, Face::Up]);
    assert_eq!(check.seams[0].stitch_count, 31);
    let mesh = mesh(&pattern, &set).expect("sound");
    assert_eq!(mesh.stitches.len(), 31);
    for stitch in &mesh.stitches {
        // The pocket lies at (0.1, 0.18) of the front.
        let (a, b) = (mesh.uv[stitch.a], mesh.uv[stitch.b]);
        let apart = (a[0] + 0.1 - b[0]).hypot(a[1] + 0.18 - b[1]);
        assert!(apart < 1e-12, "{a:?} {b:?}");
    }
    assert_line_is_meshed(&mesh, 0);
}

/// Each two neighbors along the line are joined by a mesh edge with cloth on both sides, and the
/// panel has no gap.
fn assert_line_is_meshed(mesh: &ClothMesh, panel: usize) {
    let triangles = &mesh.triangles[mesh.panels[panel].triangles.clone()];
    let directed: BTreeSet<[usize; 2]> = triangles
        .iter()
        .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]])
        .collect();
    let line: Vec<usize> = mesh.stitches.iter().map(|s| s.b).collect();
    for pair in line.windows(2) {
        assert!(directed.contains(&[pair[0], pair[1]]));
        assert!(directed.contains(&[pair[1], pair[0]]));
    }
    let undirected: BTreeSet<_> = directed.iter().map(|[a, b]| [a.min(b), a.max(b)]).collect();
    let vertices = mesh.panels[panel].vertices.len();
    assert_eq!(vertices + triangles.len(), undirected.len() + 1, "a disc");
    assert!(triangles.iter().all(|t| area(mesh, *t) > 0.0));
}

#[test]
fn lines_that_no_seam_names_stay_out_of_the_mesh() {
    let plain = pattern(vec![rectangle("front", 0.4, 0.6)]);
    let drawn = pattern(vec![with_line(
        rectangle("front", 0.4, 0.6),
        &[[0.1, -0.3], [0.333, 0.777]],
    )]);
    assert_eq!(meshed(&plain, &[]), meshed(&drawn, &[]));
}

#[test]
fn line_from_edge_to_edge_shares_their_vertices() {
    // A band is sewn onto a yoke line that ends on both side edges.
    let front = with_line(rectangle("front", 0.4, 0.6), &[[0.0, 0.35], [0.4, 0.35]]);
    let pattern = pattern(vec![front, rectangle("band", 0.4, 0.03)]);
    let pair = layered(seam(
        "band",
        run("band", 1, 2),
        on_line("front", [0.0, 1.0]),
    ));
    let mesh = meshed(&pattern, &[pair]);
    assert_line_is_meshed(&mesh, 0);
    let ends = [mesh.stitches[0].b, mesh.stitches[mesh.stitches.len() - 1].b];
    let [first, last] = ends.map(|v| mesh.uv[v]);
    let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-3;
    assert!(near(first, [0.0, 0.35]) && near(last, [0.4, 0.35]));
    let sides = mesh.uv[mesh.panels[0].vertices.clone()].iter();
    let on_left = sides.filter(|p| p[0] == 0.0 && (p[1] - 0.35).abs() < 5e-3);
    assert_eq!(on_left.count(), 1, "one vertex where the line ends");
}

#[test]
fn lines_that_meet_end_to_end_share_a_vertex() {
    let front = rectangle("front", 0.4, 0.6);
    let front = with_line(front, &[[0.1, 0.3], [0.1, 0.18]]);
    let front = with_line(front, &[[0.1, 0.18], [0.22, 0.18]]);
    let pattern = pattern(vec![front, rectangle("pocket", 0.12, 0.12)]);
    let line = |line| {
        let place = |at| Place::OnLine { line, at };
        between("front", place(0.0), place(1.0), None)
    };
    let pair = layered(many(
        "pocket",
        vec![run("pocket", 1, 0), run("pocket", 0, 3)],
        vec![line(0), line(1)],
    ));
    let mesh = meshed(&pattern, &[pair]);
    assert_eq!(mesh.stitches.len(), 21);
    assert_line_is_meshed(&mesh, 0);
}

#[test]
fn closed_line_is_sewn_all_round() {
    let square = [[0.1, 0.1], [0.1, 0.2], [0.2, 0.2], [0.2, 0.1], [0.1, 0.1]];
    let front = with_line(rectangle("front", 0.3, 0.3), &square);
    let pattern = pattern(vec![front, rectangle("patch", 0.1, 0.1)]);
    let start = Place::OnLine { line: 0, at: 0.0 };
    let all = between("front", start, start, Some(Direction::Cw));
    let rim = between(
        "patch",
        Place::Corner(0),
        Place::Corner(0),
        Some(Direction::Cw),
    );
    let mesh = meshed(&pattern, &[layered(seam("patch", rim, all.clone()))]);
    assert_eq!(mesh.stitches.len(), 36);
    for stitch in &mesh.stitches {
        let (a, b) = (mesh.uv[stitch.a], mesh.uv[stitch.b]);
        assert!((a[0] + 0.1 - b[0]).hypot(a[1] + 0.1 - b[1]) < 1e-12);
    }
    let without = between("front", start, start, None);
    let found = codes(&pattern, &[seam("patch", without, run("patch", 0, 1))]);
    assert_eq!(found[0].0, "seam/direction_needed");
}

#[test]
fn wrong_places_on_holes_and_lines_are_refused() {
    let panel = with_line(holed("front"), &[[0.02, 0.02], [0.02, 0.25]]);
    let pattern = pattern(vec![panel, rectangle("other", 0.1, 0.23)]);
    let other = || run("other", 0, 1);
    let hole = |hole, corner| Place::HoleCorner { hole, corner };
    let line = |line, at| Place::OnLine { line, at };
    let cases = [
        (hole(1, 0), hole(0, 1), "seam/unknown_hole", "/from"),
        (hole(0, 0), hole(0, 4), "seam/unknown_corner", "/to"),
        (
            Place::OnHoleEdge {
                hole: 0,
                edge: 4,
                at: 0.5,
            },
            hole(0, 1),
            "seam/unknown_edge",
            "/from",
        ),
        (line(1, 0.0), line(0, 1.0), "seam/unknown_line", "/from"),
        (line(0, 0.0), line(0, 1.5), "seam/bad_fraction", "/to"),
        (line(0, 0.5), line(0, 0.5), "seam/zero_length", ""),
        (line(0, 0.0), Place::Corner(1), "seam/places_apart", ""),
        (hole(0, 0), Place::Corner(1), "seam/places_apart", ""),
        (
            hole(0, 0),
            hole(0, 2),
            "seam/direction_needed",
            "/direction",
        ),
    ];
    for (from, to, code, at) in cases {
        let run = between("front", from, to, None);
        let found = codes(&pattern, &[seam("s", run, other())]);
        assert_eq!(found, [(code.to_owned(), format!("/seams/0/a{at}"))]);
    }
}

#[test]
fn stretches_of_lines_and_holes_that_are_sewn_twice_are_refused() {
    let panel = with_line(holed("front"), &[[0.02, 0.02], [0.02, 0.25]]);
    let pattern = pattern(vec![
        panel,
        rectangle("a", 0.1, 0.23),
        rectangle("b", 0.1, 0.1),
    ]);
    let line = |ends| on_line("front", ends);
    let twice = [
        seam("one", run("a", 0, 1), line([0.0, 1.0])),
        seam("two", run("b", 0, 1), line([0.4, 0.8])),
    ];
    assert_eq!(codes(&pattern, &twice)[0].0, "seam/overlap");
    let places = [0, 1].map(|corner| Place::HoleCorner { hole: 0, corner });
    let edge = || between("front", places[0], places[1], None);
    let twice = [
        seam("one", run("b", 0, 1), edge()),
        seam("two", run("b", 2, 3), edge()),
    ];
    assert_eq!(codes(&pattern, &twice)[0].0, "seam/overlap");
}

#[test]
fn lines_that_leave_the_cloth_or_cross_are_refused_at_the_panel() {
    let across = [[0.05, 0.15], [0.25, 0.15]];
    let cases = [
        (vec![vec![[0.05, 0.05], [0.5, 0.05]]], "mesh/line_outside"),
        (vec![vec![[0.5, 0.05], [0.6, 0.25]]], "mesh/line_outside"),
        (vec![across.to_vec()], "mesh/line_crossing"),
        (vec![vec![[0.12, 0.12], [0.18, 0.18]]], "mesh/line_outside"),
        (
            vec![
                vec![[0.02, 0.05], [0.25, 0.05]],
                vec![[0.15, 0.02], [0.15, 0.08]],
            ],
            "mesh/line_crossing",
        ),
    ];
    for mirror in [false, true] {
        for (lines, code) in &cases {
            let front = lines
                .iter()
                .fold(holed("front"), |p, line| with_line(p, line));
            let front = if mirror { mirrored(&front) } else { front };
            let id = front.id.clone();
            let count = lines.len();
            let pattern = pattern(vec![
                front,
                rectangle("a", 0.1, 0.2),
                rectangle("b", 0.1, 0.2),
            ]);
            let pair = |line: usize| {
                let place = |at| Place::OnLine { line, at };
                let run_on = between(&id, place(0.0), place(1.0), None);
                SeamPair {
                    gather: true,
                    ..seam(["s", "t"][line], run(["a", "b"][line], 0, 1), run_on)
                }
            };
            let pairs: Vec<_> = (0..count).map(pair).collect();
            let faults = mesh(&pattern, &sewn(&pattern, &pairs)).expect_err("the line is bad");
            assert_eq!(faults.0.len(), 1, "{faults}");
            assert_eq!(faults.0[0].code, *code);
            assert_eq!(faults.0[0].pointer, format!("/panels/{id}"));
        }
    }
}

#[test]
fn tracks_order_as_panels_hold_them() {
    assert!(Track::Outline < Track::Hole(0) && Track::Hole(3) < Track::Line(0));
}

/// A small linear congruential generator (Knuth, MMIX), so that each case repeats.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % bound
    }

    fn share(&mut self) -> f64 {
        self.below(21) as f64 / 20.0
    }

    fn place(&mut self) -> Place {
        match self.below(6) {
            0 => Place::Corner(self.below(5)),
            1 => Place::OnEdge {
                edge: self.below(4),
                at: self.share(),
            },
            2 => Place::HoleCorner {
                hole: self.below(2),
                corner: self.below(4),
            },
            3 => Place::OnHoleEdge {
                hole: 0,
                edge: self.below(4),
                at: self.share(),
            },
            _ => Place::OnLine {
                line: self.below(4),
                at: self.share(),
            },
        }
    }
}

#[test]
fn whatever_the_check_accepts_is_meshed_or_refused_at_its_panel() {
    // Lines that end inside, on an edge, on the hole, on each other; one is closed; two cross.
    let lines: [&[[f64; 2]]; 4] = [
        &[[0.0, 0.05], [0.15, 0.05], [0.15, 0.1]],
        &[[0.15, 0.05], [0.28, 0.05]],
        &[[0.22, 0.22], [0.28, 0.22], [0.28, 0.28], [0.22, 0.22]],
        &[[0.02, 0.25], [0.02, 0.02]],
    ];
    let front = lines
        .iter()
        .fold(holed("a"), |panel, line| with_line(panel, line));
    let copy = mirrored(&front);
    let ids = [front.id.clone(), copy.id.clone()];
    let pattern = pattern(vec![front, copy]);
    let mut random = Random(5);
    let (mut meshes, mut refusals) = (0, 0);
    for _ in 0..3_000 {
        let mut run = || {
            let ways = [None, Some(Direction::Cw), Some(Direction::Ccw)];
            let panel = &ids[random.below(2)];
            let from = random.place();
            // Mostly of the same kind, so that many runs have a way.
            let like =
                |place: &Place| std::mem::discriminant(place) == std::mem::discriminant(&from);
            let mut draws = (0..6).map(|_| random.place());
            let to = draws.find(like).unwrap_or(Place::Corner(0));
            between(panel, from, to, ways[random.below(3)])
        };
        let pair = SeamPair {
            gather: true,
            ..seam("s", run(), run())
        };
        let (check, set) = checked(&pattern, &[pair]);
        let Ok(set) = set else {
            assert!(!check.ok && !check.seams[0].errors.is_empty());
            continue;
        };
        match mesh(&pattern, &set) {
            Ok(mesh) => {
                meshes += 1;
                assert!(mesh.triangles.iter().all(|t| area(&mesh, *t) > 0.0));
                assert!(mesh.stitches.iter().all(|s| s.a != s.b));
                let count = mesh.stitches.len();
                assert!(count > 0, "{set:?}");
            }
            Err(faults) => {
                refusals += 1;
                let codes: Vec<_> = faults.0.iter().map(|f| f.code.as_str()).collect();
                let known = ["mesh/line_crossing", "mesh/endless_breaks"];
                assert!(codes.iter().all(|code| known.contains(code)), "{faults}");
            }
        }
    }
    assert!(meshes > 100 && refusals > 0, "{meshes} {refusals}");
}
