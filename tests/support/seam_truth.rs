//! Garments whose seams are known: drafts of GarmentCode as DXF with the stitches beside them, and as specifications.
//! Each seam is checked as it is and reversed, and what was found is counted for a table.
#![allow(
    dead_code,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use seamster::config::Limits;
use seamster::pattern::{
    Direction, ImportOptions, Match, Panel, Pattern, Place, Run, SeamPair, Side, import,
};
use seamster::scene::{Placed, ToPlace, place};
use seamster::seam::{Face, FaceAsked, SeamCheck, ToCheck, check_placed};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// A true edge lies on the outline that was imported, to the chord error of curves \[m\].
const ON_OUTLINE_M: f64 = 1e-3;

/// Its ends are corners where they are that near \[m\].
const AT_CORNER_M: f64 = 1e-4;

/// Bridges shorter than this are not judged by where they start \[m\].
const SHORT_M: f64 = 0.02;

const EDGE_LENGTH: f64 = 0.012;

type P = [f64; 2];

/// Where a point of a panel starts, by index and face.
type Start = Box<dyn Fn(usize, Face, P) -> Option<[f64; 3]>>;

/// A garment whose seams are known.
pub(crate) struct TrueGarment {
    pub(crate) name: String,
    pub(crate) pattern: Pattern,
    pub(crate) pairs: Vec<SeamPair>,
    pub(crate) faces: BTreeMap<String, FaceAsked>,
    start: Start,
}

/// What was found about a garment: numbers of stitches.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) garment: String,
    pub(crate) stitches: usize,
    /// Accepted with faces as they truly are, and with faces found.
    pub(crate) accepted: [usize; 2],
    /// Reversed, and refused as twisted at their own place with true faces.
    pub(crate) refused: usize,
    /// Those that lie on a cycle of panels.
    pub(crate) on_cycle: usize,
    /// Of them, refused as twisted when reversed, with faces found.
    pub(crate) refused_on_cycle: usize,
    /// Of the others, reported as likely reversed when reversed.
    pub(crate) likely_reversed: usize,
    /// Seams between two panels, each made a bridge by leaving out seams until what is left is a tree; those shorter
    /// than 2 cm, which are not judged, apart.
    pub(crate) bridges: usize,
    pub(crate) short: usize,
    /// Of them, reported as likely reversed when reversed, and nothing else found.
    pub(crate) bridges_found: usize,
    /// Reversed, and offered as they truly are.
    pub(crate) put_right: usize,
    /// Sewn in the true order where all are `auto` and all are picked reversed.
    pub(crate) auto_right: usize,
    /// Warned of as likely reversed though they are right.
    pub(crate) false_warnings: usize,
}

/// Every `*.seams.json` with its DXF and every `*_specification.json` of the data folder, in order of names.
pub(crate) fn garments(data: &Path) -> Vec<TrueGarment> {
    let folder = data.join("dxf");
    let entries = std::fs::read_dir(&folder).expect("the data folder has dxf/");
    let names = entries.map(|e| {
        e.expect("readable")
            .file_name()
            .to_string_lossy()
            .into_owned()
    });
    let mut names: Vec<String> = names.collect();
    names.sort();
    let of = |name: &String| {
        if let Some(stem) = name.strip_suffix(".seams.json") {
            Some(of_dxf(&folder, stem))
        } else if name.ends_with("_specification.json") {
            Some(of_specification(&folder, name))
        } else {
            None
        }
    };
    names.iter().filter_map(of).collect()
}

/// What the check finds about a garment.
pub(crate) fn row(garment: &TrueGarment) -> Row {
    let auto = BTreeMap::new();
    let count_ok = |check: &SeamCheck| check.seams.iter().filter(|seam| seam.ok).count();
    let right = [&garment.faces, &auto].map(|faces| check(garment, &garment.pairs, faces));
    let mut row = Row {
        garment: garment.name.clone(),
        stitches: garment.pairs.len(),
        accepted: [count_ok(&right[0]), count_ok(&right[1])],
        false_warnings: (0..garment.pairs.len())
            .filter(|&i| warned(&right[0], i) || warned(&right[1], i))
            .count(),
        ..Row::default()
    };
    let mut pairs = garment.pairs.clone();
    for pair in &mut pairs {
        pair.b = turned_side(&pair.b);
        pair.matching = Match::Auto;
    }
    let found = check(garment, &pairs, &auto);
    row.auto_right = found.seams.iter().filter(|seam| seam.reversed).count();
    for wrong in 0..garment.pairs.len() {
        let mut pairs = garment.pairs.clone();
        pairs[wrong].b = turned_side(&pairs[wrong].b);
        row.refused += usize::from(refused(&check(garment, &pairs, &garment.faces), wrong));
        let found = check(garment, &pairs, &auto);
        if on_cycle(&garment.pairs, wrong) {
            row.on_cycle += 1;
            row.refused_on_cycle += usize::from(refused(&found, wrong));
        } else {
            row.likely_reversed += usize::from(found.ok && warned(&found, wrong));
        }
        if let Some((tree, at)) = tree(&garment.pairs, wrong) {
            let right = check(garment, &tree, &auto);
            let length = right.seams[at].length_a_m.max(right.seams[at].length_b_m);
            if length < SHORT_M {
                row.short += 1;
            } else {
                row.bridges += 1;
            }
            row.false_warnings += (0..tree.len()).filter(|&i| warned(&right, i)).count();
            let mut tree = tree;
            tree[at].b = turned_side(&tree[at].b);
            let found = check(garment, &tree, &auto);
            let only = (0..tree.len()).all(|i| warned(&found, i) == (i == at));
            row.bridges_found += usize::from(length >= SHORT_M && found.ok && only);
        }
        row.put_right += usize::from(found.corrected == [garment.pairs[wrong].clone()]);
    }
    row
}

/// The rows as text.
pub(crate) fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:40} {:>8} {:>14} {:>9} {:>14} {:>15} {:>14} {:>9} {:>8}\n",
        "garment",
        "stitches",
        "accepted",
        "refused",
        "refused, auto",
        "likely reversed",
        "bridge (short)",
        "put right",
        "all auto"
    );
    for row in rows {
        let n = row.stitches;
        writeln!(
            text,
            "{:40} {:>8} {:>14} {:>9} {:>14} {:>15} {:>14} {:>9} {:>8}",
            row.garment,
            n,
            format!("{}+{}/{n}", row.accepted[0], row.accepted[1]),
            format!("{}/{n}", row.refused),
            format!("{}/{}", row.refused_on_cycle, row.on_cycle),
            format!("{}/{}", row.likely_reversed, n - row.on_cycle),
            format!("{}/{} ({})", row.bridges_found, row.bridges, row.short),
            format!("{}/{n}", row.put_right),
            format!("{}/{n}", row.auto_right),
        )
        .expect("a string takes all");
    }
    text
}

fn check(
    garment: &TrueGarment,
    pairs: &[SeamPair],
    faces: &BTreeMap<String, FaceAsked>,
) -> SeamCheck {
    let to_check = ToCheck {
        pattern: &garment.pattern,
        pairs,
        faces,
        edge_length: EDGE_LENGTH,
        limits: &Limits::default(),
    };
    check_placed(&to_check, &*garment.start).0
}

/// Whether one seam is refused as twisted, and nothing else is found wrong.
fn refused(check: &SeamCheck, wrong: usize) -> bool {
    let errors: Vec<_> = check.seams.iter().flat_map(|seam| &seam.errors).collect();
    errors.len() == 1
        && errors[0].code == "seam/twisted"
        && errors[0].pointer == format!("/seams/{wrong}")
}

fn warned(check: &SeamCheck, seam: usize) -> bool {
    let mut warnings = check.seams[seam].warnings.iter();
    warnings.any(|warning| warning.code == "seam/likely_reversed")
}

/// Seams that join all panels without a cycle, one of them the seam at `index`, and where that is; nothing if it joins a panel to itself.
fn tree(pairs: &[SeamPair], index: usize) -> Option<(Vec<SeamPair>, usize)> {
    let mut part: BTreeMap<&str, usize> = BTreeMap::new();
    for run in pairs
        .iter()
        .flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()))
    {
        let next = part.len();
        part.entry(&run.panel).or_insert(next);
    }
    let mut tree = vec![];
    let others = (0..pairs.len()).filter(|&i| i != index);
    for i in std::iter::once(index).chain(others) {
        let [a, b] = [&pairs[i].a, &pairs[i].b].map(|side| part[side.runs()[0].panel.as_str()]);
        if a != b {
            part.values_mut().filter(|p| **p == b).for_each(|p| *p = a);
            tree.push(i);
        }
    }
    if tree.first() != Some(&index) {
        return None;
    }
    tree.sort_unstable();
    let at = tree.iter().position(|&i| i == index)?;
    Some((tree.into_iter().map(|i| pairs[i].clone()).collect(), at))
}

/// Whether the two panels of a seam are one, or joined through other seams too.
fn on_cycle(pairs: &[SeamPair], index: usize) -> bool {
    let ends = |pair: &SeamPair| [&pair.a, &pair.b].map(|side| side.runs()[0].panel.clone());
    let [start, goal] = ends(&pairs[index]);
    let mut reached = vec![start];
    let mut next = 0;
    while next < reached.len() {
        for (i, pair) in pairs.iter().enumerate() {
            let [a, b] = ends(pair);
            if i == index || (a != reached[next] && b != reached[next]) {
                continue;
            }
            for panel in [a, b] {
                if !reached.contains(&panel) {
                    reached.push(panel);
                }
            }
        }
        next += 1;
    }
    reached.contains(&goal)
}

fn turned(run: &Run) -> Run {
    let turn = |way| match way {
        Direction::Cw => Direction::Ccw,
        Direction::Ccw => Direction::Cw,
    };
    Run {
        panel: run.panel.clone(),
        from: run.to,
        to: run.from,
        direction: run.direction.map(turn),
    }
}

fn turned_side(side: &Side) -> Side {
    let Side::One(run) = side else {
        panic!("stitches have single runs")
    };
    Side::One(turned(run))
}

fn imported(path: &Path) -> Pattern {
    let bytes = std::fs::read(path).expect("the data folder has it");
    import(&bytes, &ImportOptions::default(), &Limits::default())
        .unwrap_or_else(|faults| panic!("{}: {faults}", path.display()))
}

fn asked(face: Face) -> FaceAsked {
    match face {
        Face::Up => FaceAsked::Up,
        Face::Down => FaceAsked::Down,
    }
}

/// A specification states its seams, faces and placements itself.
fn of_specification(folder: &Path, name: &str) -> TrueGarment {
    let pattern = imported(&folder.join(name));
    let face = |panel: &Panel| Some((panel.id.clone(), asked(panel.face?)));
    let placed: Vec<[Option<Placed>; 2]> = pattern
        .panels
        .iter()
        .map(|panel| {
            [Face::Up, Face::Down].map(|face| {
                let asked = pattern.placements.get(&panel.id);
                place(ToPlace { panel, face, asked }, None).ok()
            })
        })
        .collect();
    TrueGarment {
        name: name.to_owned(),
        pairs: pattern.seams.clone(),
        faces: pattern.panels.iter().filter_map(face).collect(),
        pattern,
        start: Box::new(move |panel, face, uv| {
            let placed = placed[panel][usize::from(face == Face::Down)].as_ref();
            Some(placed?.position(uv).into())
        }),
    }
}

/// How a true panel was drawn in the DXF: mirrored, turned, moved.
#[derive(Clone, Copy, Debug)]
struct Drawn {
    mirrored: bool,
    turn: [f64; 2],
    offset: P,
}

impl Drawn {
    fn point(&self, [x, y]: P) -> P {
        let x = if self.mirrored { -x } else { x };
        let [cos, sin] = self.turn;
        [
            cos * x - sin * y + self.offset[0],
            sin * x + cos * y + self.offset[1],
        ]
    }

    fn local(&self, p: P) -> P {
        let [cos, sin] = self.turn;
        let [x, y] = [p[0] - self.offset[0], p[1] - self.offset[1]];
        let [x, y] = [cos * x + sin * y, cos * y - sin * x];
        [if self.mirrored { -x } else { x }, y]
    }
}

/// A true panel found in the pattern.
struct Found {
    panel: usize,
    drawn: Drawn,
    face: Face,
    rotation: [f64; 3],
    translation: [f64; 3],
}

fn of_dxf(folder: &Path, stem: &str) -> TrueGarment {
    let pattern = imported(&folder.join(format!("{stem}.dxf")));
    let bytes = std::fs::read(folder.join(format!("{stem}.seams.json"))).expect("readable");
    let truth: Value = serde_json::from_slice(&bytes).expect("the truth is JSON");
    let unit = number(&truth["to_mm"]) / 1e3;
    let panels = truth["panels"].as_object().expect("panels by name");
    let found: BTreeMap<&str, Found> = panels
        .iter()
        .map(|(name, panel)| (name.as_str(), find(&pattern, name, panel, unit)))
        .collect();
    let run = |end: &Value| {
        let name = end["panel"].as_str().expect("a name");
        let found = &found[name];
        let edge = &panels[name]["edges"][index(&end["edge"])];
        let [from, to, by] = ["a_local_mm", "b_local_mm", "mid_local_mm"]
            .map(|key| found.drawn.point(millimetres(&edge[key])));
        run(&pattern.panels[found.panel], [from, to, by])
    };
    let stitches = truth["stitches"].as_array().expect("a list");
    let pairs = stitches.iter().enumerate().map(|(i, stitch)| {
        let sides = stitch.as_array().expect("two ends");
        let is_wrong = sides.get(2).is_some_and(|word| word == "right_wrong");
        let b = run(&sides[1]);
        SeamPair {
            id: format!("stitch-{i:02}"),
            a: Side::One(run(&sides[0])),
            b: Side::One(if is_wrong { b } else { turned(&b) }),
            matching: Match::AsPicked,
            stage: 0,
            gather: true,
            layered: false,
            allow_twist: false,
            confidence: None,
            because: None,
        }
    });
    let pairs = pairs.collect();
    let faces = found
        .values()
        .map(|found| (pattern.panels[found.panel].id.clone(), asked(found.face)))
        .collect();
    let by_index: BTreeMap<usize, Found> = found
        .into_values()
        .map(|found| (found.panel, found))
        .collect();
    assert_eq!(by_index.len(), pattern.panels.len(), "{stem}: one for each");
    TrueGarment {
        name: stem.to_owned(),
        pattern,
        pairs,
        faces,
        start: Box::new(move |panel, _, uv| {
            let found = by_index.get(&panel)?;
            let [x, y] = found.drawn.local(uv);
            let turned = rotated(found.rotation, [x, y, 0.0]);
            Some([0, 1, 2].map(|k| turned[k] + found.translation[k]))
        }),
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a figure")
}

fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("an index")).expect("a small one")
}

fn millimetres(point: &Value) -> P {
    [0, 1].map(|k| number(&point[k]) / 1e3)
}

/// R = Rx Ry Rz.
fn rotated(degrees: [f64; 3], mut v: [f64; 3]) -> [f64; 3] {
    for axis in [2, 1, 0] {
        let (sin, cos) = degrees[axis].to_radians().sin_cos();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        (v[i], v[j]) = (cos * v[i] - sin * v[j], sin * v[i] + cos * v[j]);
    }
    v
}

/// Finds the panel on whose outline all edges of a true panel lie, drawn in its place or in a block of its own.
fn find(pattern: &Pattern, name: &str, truth: &Value, unit: f64) -> Found {
    let (sin, cos) = number(&truth["rotation_deg"]).to_radians().sin_cos();
    let offset = [0, 1].map(|k| number(&truth["insert_offset_file_units"][k]) * unit);
    let edges = truth["edges"].as_array().expect("a list of edges");
    let points = || {
        let keys = ["a_local_mm", "mid_local_mm"];
        edges
            .iter()
            .flat_map(move |edge| keys.map(|key| millimetres(&edge[key])))
    };
    let mut best: Option<(f64, usize, Drawn)> = None;
    for (index, panel) in pattern.panels.iter().enumerate() {
        for offset in [offset, [0.0; 2]] {
            let drawn = Drawn {
                mirrored: truth["mirrored_x"] == true,
                turn: [cos, sin],
                offset,
            };
            let off = |p: P| nearest(panel, drawn.point(p)).0;
            let worst = points().map(off).fold(0.0, f64::max);
            let named = panel.name.eq_ignore_ascii_case(name);
            // Panels drawn in blocks of their own lie over one another; their names tell them apart.
            let rank = if named { worst - ON_OUTLINE_M } else { worst };
            if best.is_none_or(|(least, ..)| rank < least) {
                best = Some((rank, index, drawn));
            }
        }
    }
    let (off, panel, drawn) = best.expect("there are panels");
    assert!(
        off < ON_OUTLINE_M,
        "{name} is not in the pattern: {off} m off"
    );
    let ring: Vec<P> = points().map(|p| drawn.point(p)).collect();
    let twice_area: f64 = (0..ring.len())
        .map(|i| {
            let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
            a[0] * b[1] - b[0] * a[1]
        })
        .sum();
    let placement = &truth["placement_3d"];
    Found {
        panel,
        drawn,
        // A loop that runs counter-clockwise shows the outer side of the cloth.
        face: if twice_area > 0.0 {
            Face::Up
        } else {
            Face::Down
        },
        rotation: [0, 1, 2].map(|k| number(&placement["rotation_deg"][k])),
        translation: [0, 1, 2].map(|k| number(&placement["translation_cm"][k]) / 1e2),
    }
}

/// How far a point is from a panel's outline, and where that is nearest: an edge and a fraction of its arc length.
fn nearest(panel: &Panel, p: P) -> (f64, usize, f64) {
    let mut best = (f64::INFINITY, 0, 0.0);
    for (index, edge) in panel.edges.iter().enumerate() {
        let mut passed = 0.0;
        for pair in edge.points.windows(2) {
            let along = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let length = along[0].hypot(along[1]);
            let to = [p[0] - pair[0][0], p[1] - pair[0][1]];
            let share = (to[0] * along[0] + to[1] * along[1]) / (length * length);
            let share = share.clamp(0.0, 1.0);
            let off = (to[0] - share * along[0]).hypot(to[1] - share * along[1]);
            if off < best.0 {
                best = (off, index, (passed + share * length) / edge.length_m);
            }
            passed += length;
        }
    }
    best
}

/// The run between two points of the outline that goes by a third.
fn run(panel: &Panel, [from, to, by]: [P; 3]) -> Run {
    let place = |p: P| {
        let corner = |c: &seamster::pattern::Corner| (c.x - p[0]).hypot(c.y - p[1]) < AT_CORNER_M;
        match panel.corners.iter().position(corner) {
            Some(corner) => (Place::Corner(corner), corner as f64),
            None => {
                let (_, edge, at) = nearest(panel, p);
                (Place::OnEdge { edge, at }, edge as f64 + at)
            }
        }
    };
    let count = panel.edges.len() as f64;
    let ((from, start), (to, end)) = (place(from), place(to));
    let (_, edge, at) = nearest(panel, by);
    let ahead = |position: f64| (position - start).rem_euclid(count);
    let way = if ahead(edge as f64 + at) < ahead(end) {
        Direction::Cw
    } else {
        Direction::Ccw
    };
    Run {
        panel: panel.id.clone(),
        from,
        to,
        direction: Some(way),
    }
}
