//! Corners: of files with turn points and runs, where those are; of generated ones, every edge in cyclic order.

use super::super::raw::{Entity, P};
use super::super::rings::{apart, distance, length, sharp};
use super::{Cell, File, Pair, list, off};
use serde_json::Value;

pub(super) fn cell(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    for pair in pairs {
        let differs = match edges(file, pair) {
            Some(edges) => of_edges(pair, edges, smooth(file, pair)),
            None => of_marks(file, pair),
        };
        wrong.extend(differs.map(|what| pair.says(what)));
    }
    Cell::of(&wrong)
}

/// Splits of one smooth curve that a flat polyline does not show: of the true edge before and the one after, both with
/// the same direction, and sampled alike. File, panel, the edges before such a split.
const SMOOTH: [(&str, &str, &[usize]); 2] = [
    ("fs_sandy__lwpoly_seam_and_cut.dxf", "sandy.skirt", &[0, 3]),
    (
        "fs_teagan__r12_exploded_lines.dxf",
        "teagan.sleeve",
        &[4, 5],
    ),
];

/// Those of a panel.
fn smooth(file: &File<'_>, pair: &Pair<'_>) -> &'static [usize] {
    let is_it = |s: &&(&str, &str, _)| file.entry["file"] == s.0 && pair.panel.name == s.1;
    SMOOTH.iter().find(is_it).map_or(&[], |s| s.2)
}

/// The true edges of a panel of a generated file.
fn edges<'a>(file: &'a File<'_>, pair: &Pair<'_>) -> Option<&'a [Value]> {
    let truth = file.truth.as_ref()?;
    let name = pair.panel.name.as_str();
    let panel = truth["panels"]
        .get(name)
        .or_else(|| truth["parts"].get(name));
    panel.map(|panel| list(&panel["edges"]))
}

/// The true edges on the fold: straight lines at the left end, where generated files have it.
pub(super) fn on_fold(edges: &[Value]) -> Vec<bool> {
    let x = |edge: &Value, key: &str| edge[key][0].as_f64().unwrap_or(f64::INFINITY);
    let left = edges
        .iter()
        .map(|e| x(e, "a_mm"))
        .fold(f64::INFINITY, f64::min);
    let on = |e: &Value| {
        [x(e, "a_mm"), x(e, "b_mm")]
            .iter()
            .all(|x| (x - left).abs() < 1e-3)
    };
    edges.iter().map(|e| e["kind"] == "line" && on(e)).collect()
}

/// The edges have the true lengths, in this order or the other way round.
fn of_edges(pair: &Pair<'_>, edges: &[Value], smooth: &[usize]) -> Option<String> {
    let wanted = wanted_lengths(pair, edges, smooth);
    let found: Vec<f64> = pair
        .panel
        .edges
        .iter()
        .map(|e| 1000.0 * e.length_m)
        .collect();
    if wanted.iter().any(|w| cyclic(&found, w)) {
        return None;
    }
    let shown = |l: &[f64]| {
        l.iter()
            .map(|x| format!("{x:.1}"))
            .collect::<Vec<_>>()
            .join(" ")
    };
    let shortest = wanted
        .iter()
        .min_by_key(|w| w.len())
        .expect("at least one way");
    Some(format!(
        "{} edges ({}) for {} ({})",
        found.len(),
        shown(&found),
        shortest.len(),
        shown(shortest)
    ))
}

/// The lengths of all edges, smooth splits joined; of a half piece those off the fold and their images, joined or not
/// where they meet there.
fn wanted_lengths(pair: &Pair<'_>, edges: &[Value], smooth: &[usize]) -> Vec<Vec<f64>> {
    let mut all: Vec<(f64, bool)> = Vec::new();
    for (i, (edge, fold)) in edges.iter().zip(on_fold(edges)).enumerate() {
        let long = edge["length_mm"].as_f64().expect("a length");
        match all.last_mut() {
            Some(last) if i > 0 && smooth.contains(&(i - 1)) => last.0 += long,
            _ => all.push((long, fold)),
        }
    }
    if !pair.panel.unfolded {
        return vec![all.iter().map(|edge| edge.0).collect()];
    }
    let n = all.len();
    let first = (0..n).find(|i| !all[*i].1 && all[(*i + n - 1) % n].1);
    let around = (0..n).map(|k| all[(first.unwrap_or(0) + k) % n]);
    let off: Vec<f64> = around.filter(|edge| !edge.1).map(|edge| edge.0).collect();
    let mut ways = Vec::new();
    for (start_joined, end_joined) in [(true, true), (true, false), (false, true), (false, false)] {
        let mut whole = off.clone();
        whole.extend(off.iter().rev());
        if end_joined {
            let second = whole.remove(off.len());
            whole[off.len() - 1] += second;
        }
        if start_joined {
            let last = whole.pop().expect("an edge");
            whole[0] += last;
        }
        ways.push(whole);
    }
    ways
}

/// Whether two closed lists of lengths are one, up to where they begin and which way they run.
fn cyclic(found: &[f64], wanted: &[f64]) -> bool {
    let n = wanted.len();
    // Chords are shorter than the curve that they are of.
    let same = |a: f64, b: f64| (a - b).abs() <= 0.1 + 2e-3 * b;
    let runs = |from: usize, back: bool| {
        (0..n).all(|k| {
            let i = if back {
                (from + n - k) % n
            } else {
                (from + k) % n
            };
            same(found[i], wanted[k])
        })
    };
    found.len() == n && (0..n).any(|from| runs(from, false) || runs(from, true))
}

/// What is not found, or found beyond the truth: said below the table.
pub(super) fn notes(file: &File<'_>) -> Vec<String> {
    let name = file.entry["file"].as_str().unwrap_or_default();
    let mut notes = Vec::new();
    for (_, panel, edges) in SMOOTH.iter().filter(|s| s.0 == name) {
        notes.push(format!(
            "{name}: {panel}: one smooth curve where the truth splits it after its edges {edges:?}: nothing shows it"
        ));
    }
    let shallow = |p: &Pair<'_>| {
        let (runs, turns) = drawn(file, p);
        let corners = p.panel.corners.iter().map(|c| [1000.0 * c.x, 1000.0 * c.y]);
        let sharp = sharp(&runs.concat(), SAME);
        let plain = runs.len() == 1 && turns.is_empty() && !p.panel.unfolded;
        corners
            .filter(|c| plain && !sharp.iter().any(|q| distance(*c, *q) < 0.02))
            .count()
    };
    let joints: usize = file.pairs(&file.pieces()).iter().map(shallow).sum();
    if joints > 0 && file.truth.is_none() {
        notes.push(format!(
            "{name}: {joints} corners turn by less than 20 degrees: lines that run into curves, curves drawn apart"
        ));
    }
    notes
}

/// Points nearer than this are one [mm].
const SAME: f64 = 2e-3;

/// Corners are where runs end and at turn points that turn (of several runs), at turn points (of one run), else where
/// the outline turns by 20 degrees. Others may only be shallow joints of a flat outline: points of it, at most as many.
fn of_marks(file: &File<'_>, pair: &Pair<'_>) -> Option<String> {
    let (runs, turns) = drawn(file, pair);
    let ring: Vec<P> = runs.iter().flatten().copied().collect();
    let sharp = sharp(&ring, SAME);
    let near = |p: &P, list: &[P]| list.iter().any(|q| distance(*p, *q) < 0.02);
    let turns: Vec<P> = turns.into_iter().filter(|t| near(t, &ring)).collect();
    let ends: Vec<P> = runs.iter().flat_map(|r| [r[0], r[r.len() - 1]]).collect();
    let wanted: Vec<P> = match (runs.len(), turns.is_empty()) {
        (1, true) => sharp.clone(),
        (1, false) => turns.clone(),
        _ => ends
            .iter()
            .copied()
            .chain(turns.iter().filter(|t| near(t, &sharp)).copied())
            .collect(),
    };
    let fold = pair.mirror().filter(|_| pair.panel.unfolded);
    let on_fold = |p: &P| fold.is_some_and(|[a, b]| apart(*p, &[a, b], false) < 0.3);
    let found: Vec<P> = pair
        .panel
        .corners
        .iter()
        .map(|c| [1000.0 * c.x, 1000.0 * c.y])
        .collect();
    let lost = wanted
        .iter()
        .filter(|p| !near(p, &found) && !on_fold(p))
        .count();
    let image = |p: &P| fold.map_or(*p, |[a, b]| mirrored(*p, a, b));
    let allowed = |p: &P| {
        [&wanted, &turns, &sharp]
            .iter()
            .any(|l| near(p, l) || near(&image(p), l))
            || on_fold(p)
    };
    let flat = runs.len() == 1 && turns.is_empty();
    let extra: Vec<&P> = found.iter().filter(|p| !allowed(p)).collect();
    let is_joint = |p: &P| flat && extra.len() <= wanted.len() && near(p, &ring);
    let extra = extra.iter().filter(|p| !is_joint(p)).count();
    (lost + extra > 0).then(|| format!("{lost} of {} corners lost, {extra} added", wanted.len()))
}

fn mirrored(p: P, a: P, b: P) -> P {
    let u = [b[0] - a[0], b[1] - a[1]];
    let t = ((p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1]) / (u[0] * u[0] + u[1] * u[1]);
    [
        2.0 * (a[0] + t * u[0]) - p[0],
        2.0 * (a[1] + t * u[1]) - p[1],
    ]
}

/// The runs and turn points that the panel's outline was drawn with [mm].
fn drawn(file: &File<'_>, pair: &Pair<'_>) -> (Vec<Vec<P>>, Vec<P>) {
    let entities = pair.block.map_or(&file.drawing.model, |b| &b.entities);
    let scaled = |points: &[P]| {
        points
            .iter()
            .map(|p| [file.scale * p[0], file.scale * p[1]])
            .collect::<Vec<P>>()
    };
    let is_line = |e: &&Entity| e.kind.ends_with("POLYLINE") && e.points.len() > 1;
    let turns = entities
        .iter()
        .filter(|e| e.layer == "2" && e.kind == "POINT");
    let turns = turns.flat_map(|e| scaled(&e.points)).collect();
    let on = |layer: &str| {
        entities
            .iter()
            .filter(|e| e.layer == layer)
            .filter(is_line)
            .map(|e| scaled(&e.points))
            .collect::<Vec<_>>()
    };
    // Several open runs, or the one closed line that is as long as the outline.
    let runs = on(if pair.panel.cut_line.is_empty() {
        "1"
    } else {
        "14"
    });
    let long = length(&pair.ring(), true);
    let closed = entities
        .iter()
        .filter(is_line)
        .filter(|e| e.closed)
        .map(|e| scaled(&e.points));
    let whole = closed.filter(|p| off(length(p, true), long) < 1e-3);
    let nearest = |p: &Vec<P>| {
        p.iter()
            .map(|q| apart(*q, &pair.ring(), true))
            .fold(0.0, f64::max)
    };
    match whole.min_by(|a, b| nearest(a).total_cmp(&nearest(b))) {
        Some(ring) if pair.block.is_none() || runs.len() <= 1 => (vec![ring], turns),
        _ => (runs, turns),
    }
}
