//! Whether an import lost anything without a word: every line, notch and drill hole of the file is looked for in the
//! pattern, and what is not there must have been warned about.

use super::raw::{Entity, P, read};
use super::rings::{apart, distance};
use seamster::pattern::Pattern;
use std::collections::BTreeSet;

/// What the layers mean, as ARCHITECTURE and the layers of ASTM D6673 have it. Other layers are general: drawn lines.
const IGNORED: [&str; 14] = [
    "3",
    "5",
    "9",
    "10",
    "12",
    "15",
    "19",
    "84",
    "85",
    "86",
    "87",
    "text",
    "label",
    "annotation",
];
const NOTCHES: [&str; 6] = ["4", "80", "81", "82", "83", "notch"];
/// Fold and grain lines and turn points: a fold or a grain says the same twice, and turn points are hints.
const SAID_ONCE: [&str; 5] = ["2", "6", "7", "fold", "grain"];

/// What became of a file's entities.
#[derive(Debug, Default)]
pub(crate) struct Account {
    /// Looked for.
    pub(crate) asked: usize,
    /// Not in the pattern: the first few, in words.
    pub(crate) lost: Vec<String>,
    /// How many are not in the pattern.
    pub(crate) missing: usize,
    /// How many the warnings name.
    pub(crate) warned: usize,
}

impl Account {
    /// Whether something is gone that no warning tells of.
    pub(crate) fn is_silent(&self) -> bool {
        self.missing > self.warned
    }
}

/// Accounts for the entities of a text DXF; `None` where they were moved, so that they cannot be looked for.
pub(crate) fn account(bytes: &[u8], pattern: &Pattern) -> Option<Account> {
    if pattern.warnings.iter().any(|w| w.code == "pattern/moved") {
        return None;
    }
    let drawing = read(bytes);
    let mut account = Account {
        missing: drawing.stray,
        warned: pattern
            .warnings
            .iter()
            .map(|w| named(&w.code, &w.detail))
            .sum(),
        ..Account::default()
    };
    let held = Held::of(pattern);
    for block in &drawing.blocks {
        let inserts = drawing
            .model
            .iter()
            .filter(|e| e.kind == "INSERT" && e.text.eq_ignore_ascii_case(&block.name));
        let piece = block.entities.iter().any(|e| e.layer == "1" && is_path(e));
        let inserts: Vec<&Entity> = inserts.collect();
        if inserts.iter().any(|e| e.transformed) || inserts.is_empty() && !piece {
            continue;
        }
        if !is_other_size(&block.entities, pattern) {
            block.entities.iter().for_each(|e| account.ask(e, &held));
        }
    }
    drawing.model.iter().for_each(|e| account.ask(e, &held));
    Some(account)
}

/// How many entities a warning names: the number that it begins with, the one that it is about, or none.
fn named(code: &str, detail: &str) -> usize {
    let words = detail.strip_prefix("and ").unwrap_or(detail);
    let number = words.split(' ').next().and_then(|word| word.parse().ok());
    match code {
        "pattern/entity_ignored" | "pattern/more" => number.expect("a count comes first"),
        "pattern/notch_ignored" | "pattern/duplicate_outline" | "pattern/zero_radius" => 1,
        _ => 0,
    }
}

/// Whether a block is of a size that was not asked for.
fn is_other_size(entities: &[Entity], pattern: &Pattern) -> bool {
    let texts = entities.iter().filter(|e| e.kind == "TEXT");
    let sizes: BTreeSet<String> = texts
        .filter_map(|e| {
            let (key, value) = e.text.split_once(':')?;
            let of_size = key.trim().eq_ignore_ascii_case("size");
            of_size.then(|| value.trim().to_owned())
        })
        .collect();
    let chosen = pattern.source.sample_size.as_ref();
    !sizes.is_empty() && !chosen.is_some_and(|chosen| sizes.contains(chosen))
}

fn is_path(entity: &Entity) -> bool {
    entity.kind == "LINE" || entity.kind.ends_with("POLYLINE")
}

/// What a pattern holds, in the file's coordinates.
struct Held {
    lines: Vec<Vec<P>>,
    points: Vec<P>,
    notches: Vec<P>,
    unfolded: bool,
    near: f64,
}

impl Held {
    fn of(pattern: &Pattern) -> Self {
        let scale = pattern.source.scale_to_m;
        let scaled = |points: &[P]| {
            points
                .iter()
                .map(|p| p.map(|c| c / scale))
                .collect::<Vec<P>>()
        };
        let closed = |points: &[P]| {
            let mut line = scaled(points);
            line.extend(line.first().copied());
            line
        };
        let mut held = Self {
            lines: Vec::new(),
            points: Vec::new(),
            notches: Vec::new(),
            unfolded: pattern.panels.iter().any(|p| p.unfolded),
            near: 0.0,
        };
        for panel in &pattern.panels {
            held.lines
                .extend(panel.edges.iter().map(|e| scaled(&e.points)));
            held.lines.push(closed(&panel.cut_line));
            let holes = panel.holes.iter().flat_map(|hole| &hole.edges);
            held.lines.extend(holes.map(|e| scaled(&e.points)));
            held.lines
                .extend(panel.internal_lines.iter().map(|l| scaled(l)));
            held.points.extend(scaled(&panel.drill_holes));
            for notch in &panel.notches {
                let points = &panel.edges[notch.edge].points;
                held.notches.extend(scaled(&[at(points, notch.at)]));
            }
        }
        let repaired = pattern
            .warnings
            .iter()
            .any(|w| w.code == "pattern/gap_closed");
        held.near = if repaired { 6e-4 } else { 2e-5 } / scale;
        held
    }

    fn has(&self, entity: &Entity) -> bool {
        let layer = entity.layer.to_lowercase();
        if NOTCHES.iter().any(|l| layer == *l) {
            // On the sew line within the cut one: by a wide seam allowance away.
            let reach = 1500.0 * self.near;
            return entity
                .points
                .iter()
                .all(|p| self.notches.iter().any(|n| distance(*n, *p) <= reach));
        }
        if layer == "13" {
            let held = |p: &P| self.points.iter().any(|q| distance(*p, *q) <= self.near);
            return entity.kind != "POINT" || entity.points.iter().all(held);
        }
        // The stretch on the fold of an unfolded panel is inside it.
        let beside = |p: &P| {
            self.lines
                .iter()
                .any(|line| apart(*p, line, false) <= self.near)
        };
        let ends = [entity.points.first(), entity.points.last()];
        if self.unfolded && entity.points.len() >= 2 && !entity.closed {
            return ends.into_iter().flatten().all(beside);
        }
        entity.points.iter().all(beside)
    }
}

fn at(points: &[P], fraction: f64) -> P {
    let total: f64 = points.windows(2).map(|w| distance(w[0], w[1])).sum();
    let mut left = fraction * total;
    for w in points.windows(2) {
        let long = distance(w[0], w[1]);
        if left <= long {
            let t = left / long;
            return [0, 1].map(|k| w[0][k] + t * (w[1][k] - w[0][k]));
        }
        left -= long;
    }
    points[points.len() - 1]
}

impl Account {
    fn ask(&mut self, entity: &Entity, held: &Held) {
        let layer = entity.layer.to_lowercase();
        let is = |names: &[&str]| names.iter().any(|name| layer == *name);
        let known = matches!(
            entity.kind.as_str(),
            "LINE"
                | "POINT"
                | "POLYLINE"
                | "LWPOLYLINE"
                | "TEXT"
                | "MTEXT"
                | "INSERT"
                | "ATTRIB"
                | "ATTDEF"
                | "ARC"
                | "CIRCLE"
                | "ELLIPSE"
                | "SPLINE"
        );
        let drawn = is_path(entity)
            || entity.kind == "POINT" && is(&["4", "80", "81", "82", "83", "13", "notch"]);
        if known && (!drawn || is(&IGNORED) || is(&SAID_ONCE) || entity.transformed) {
            return;
        }
        self.asked += 1;
        if !known || !held.has(entity) {
            self.missing += 1;
            if self.lost.len() < 5 {
                self.lost.push(format!(
                    "{} on {:?} at {:?}",
                    entity.kind,
                    entity.layer,
                    entity.points.first()
                ));
            }
        }
    }
}
