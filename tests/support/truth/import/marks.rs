//! Grain, fold, notches, drill holes, and what texts say: sizes, names, quantities.

use super::super::raw::P;
use super::super::rings::{apart, distance, length};
use super::{Cell, File, Pair, list, name};
use seamster::pattern::Panel;
use serde_json::Value;
use std::collections::BTreeSet;

/// The warp runs as the longest grain line does, within a tenth of a degree; none where none is drawn.
pub(super) fn grain(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let drawn = file
        .drawing
        .model
        .iter()
        .filter(|e| e.layer == "GRAIN")
        .count();
    if file.truth.is_some() && drawn > 0 && file.drawing.blocks.is_empty() {
        let found = pairs.iter().filter(|p| p.panel.grain.is_some()).count();
        let lost = (found != drawn).then(|| format!("{found} of {drawn} grain lines"));
        return Cell::of(&lost.into_iter().collect::<Vec<_>>());
    }
    let mut wrong = Vec::new();
    for pair in pairs {
        let wanted = match pair.piece["rotation_deg"].as_f64() {
            Some(turned) if !file.drawing.blocks.is_empty() => Some(90.0 + turned),
            _ => longest(pair.piece),
        };
        let found = pair.panel.grain.map(|g| g.angle_deg);
        let same = match (found, wanted) {
            (Some(a), Some(b)) => ((a - b + 90.0).rem_euclid(180.0) - 90.0).abs() < 0.1,
            (None, None) => true,
            _ => false,
        };
        if !same {
            wrong.push(pair.says(format!("{found:?} for {wanted:?}")));
        }
    }
    Cell::of(&wrong)
}

fn longest(piece: &Value) -> Option<f64> {
    let lines = list(&piece["grain_line"]).iter().filter_map(|line| {
        let c: Vec<f64> = list(line).iter().filter_map(Value::as_f64).collect();
        let n = c.len();
        (n >= 4).then(|| [c[0], c[1], c[n - 2], c[n - 1]])
    });
    let long = |c: &[f64; 4]| (c[2] - c[0]).hypot(c[3] - c[1]);
    let found = lines.max_by(|a, b| long(a).total_cmp(&long(b)))?;
    Some(
        (found[3] - found[1])
            .atan2(found[2] - found[0])
            .to_degrees(),
    )
}

/// Half pieces are unfolded, whole ones are not.
pub(super) fn fold(pairs: &[Pair<'_>]) -> Cell {
    let wrong = pairs.iter().filter_map(|pair| {
        let half = pair.piece["mirror_on_boundary"] == true || pair.piece["cut_on_fold"] == true;
        (half != pair.panel.unfolded).then(|| pair.says(format!("on fold: {half}")))
    });
    Cell::of(&wrong.collect::<Vec<_>>())
}

/// Notches as drawn [mm].
pub(super) fn drawn_notches(file: &File<'_>, pair: &Pair<'_>) -> Vec<P> {
    let layers = ["4", "80", "81", "82", "83"];
    let block = pair.block.map_or(&[][..], |b| &b.entities);
    let marks = block
        .iter()
        .filter(|e| e.kind == "POINT" && layers.contains(&e.layer.as_str()));
    marks
        .flat_map(|e| &e.points)
        .map(|p| [file.scale * p[0], file.scale * p[1]])
        .collect()
}

/// Where a notch of a panel lies [mm].
pub(super) fn places(panel: &Panel) -> Vec<P> {
    let place = |notch: &seamster::pattern::Notch| {
        let points = &panel.edges[notch.edge].points;
        let mut left = notch.at * length(points, false);
        for w in points.windows(2) {
            let long = distance(w[0], w[1]);
            if left <= long {
                let t = left / long;
                return [0, 1].map(|k| 1000.0 * (w[0][k] + t * (w[1][k] - w[0][k])));
            }
            left -= long;
        }
        points[points.len() - 1].map(|c| 1000.0 * c)
    };
    panel.notches.iter().map(place).collect()
}

/// As many notches as lie on the outline as drawn, each where it was drawn; on a sew line, each of the cut line's.
pub(super) fn notches(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    let mut all = 0;
    for pair in pairs {
        let found = places(pair.panel);
        all += found.len();
        let sewn = !pair.panel.cut_line.is_empty();
        let fold = pair.mirror().filter(|_| pair.panel.unfolded);
        let on_cut = |p: &P| apart(*p, &pair.cut(), true) < 0.1;
        let along = |p: &P| fold.is_some_and(|fold| apart(*p, &fold, false) < 0.1);
        let all_drawn = drawn_notches(file, pair);
        let stated = pair.piece["notches_on_boundary"].as_u64();
        let counted = all_drawn.iter().filter(|p| on_cut(p) || along(p)).count();
        if stated.is_some_and(|count| count != counted as u64) {
            wrong.push(pair.says(format!("{stated:?} on the outline, {counted} read")));
        }
        // Inside the cloth once it is unfolded, a notch on the fold is on no edge.
        let drawn: Vec<&P> = all_drawn.iter().filter(|p| on_cut(p)).collect();
        let reach = |p: &P| {
            if sewn {
                apart(*p, &pair.ring(), true) + 2.0
            } else {
                0.1
            }
        };
        let lost = drawn
            .iter()
            .filter(|p| !found.iter().any(|f| distance(*f, ***p) <= reach(p)));
        wrong.extend(lost.map(|p| pair.says(format!("no notch at ({:.1}, {:.1})", p[0], p[1]))));
        if let Some(stated) = stated.filter(|_| !sewn) {
            let single = fold.map_or(0, |fold| {
                drawn.iter().filter(|p| beside(fold, ***p)).count()
            });
            let wanted = if fold.is_some() {
                2 * drawn.len() - single
            } else {
                drawn.len()
            };
            if found.len() != wanted {
                wrong.push(pair.says(format!(
                    "{} of {wanted} notches ({stated} drawn)",
                    found.len()
                )));
            }
        }
    }
    if let Some(truth) = &file.truth {
        let parts = truth["parts"].as_object();
        let stated: u64 = parts
            .into_iter()
            .flatten()
            .filter_map(|(_, p)| p["notches"].as_u64())
            .sum();
        let ignored = file
            .pattern
            .warnings
            .iter()
            .filter(|w| w.code == "pattern/notch_ignored")
            .count();
        let held = pairs.iter().map(|p| {
            if p.panel.unfolded {
                folded(p)
            } else {
                p.panel.notches.len()
            }
        });
        let held: usize = held.sum();
        if (held + ignored) as u64 != stated {
            wrong.push(format!(
                "{held} held and {ignored} warned about of {stated} notches"
            ));
        }
    }
    if wrong.is_empty() {
        return Cell::Right(all.to_string());
    }
    Cell::of(&wrong)
}

/// How many notches of an unfolded panel were drawn: mirrored pairs count as one.
fn folded(pair: &Pair<'_>) -> usize {
    let ring = pair.ring();
    let middle = ring.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min)
        + ring.iter().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
    let on_fold = places(pair.panel)
        .iter()
        .filter(|p| (p[0] - middle / 2.0).abs() < 0.3)
        .count();
    (pair.panel.notches.len() - on_fold) / 2 + on_fold
}

fn beside([a, b]: [P; 2], p: P) -> bool {
    let u = [b[0] - a[0], b[1] - a[1]];
    ((p[0] - a[0]) * u[1] - (p[1] - a[1]) * u[0]).abs() / distance(a, b) < 0.2
}

pub(super) fn drills(pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    let mut all = 0;
    for pair in pairs {
        let stated = pair.piece["drill_holes"].as_u64().unwrap_or(0);
        let found = pair.panel.drill_holes.len();
        all += found;
        let wanted = if pair.panel.unfolded {
            2 * stated
        } else {
            stated
        };
        if found as u64 != wanted {
            wrong.push(pair.says(format!("{found} of {wanted}")));
        }
    }
    if wrong.is_empty() {
        return Cell::Right(all.to_string());
    }
    Cell::of(&wrong)
}

/// All sizes are listed and the sample size is the one read.
pub(super) fn sizes(file: &File<'_>) -> Cell {
    let Some(sizes) = file.entry["sizes"].as_object() else {
        return Cell::Unsaid;
    };
    let source = &file.pattern.source;
    let wanted: BTreeSet<&str> = sizes.keys().map(String::as_str).collect();
    let found: BTreeSet<&str> = source.sizes.iter().map(String::as_str).collect();
    let sample = file.entry["sample_size"].as_str();
    if found != wanted || source.sample_size.as_deref() != sample {
        return Cell::Wrong(format!(
            "{:?} of {found:?}, {sample:?} of {wanted:?}",
            source.sample_size
        ));
    }
    Cell::Right(found.len().to_string())
}

/// Panels are called what the file calls them; names of a byte or two misread by the manifest's reader are not compared.
pub(super) fn names(pairs: &[Pair<'_>]) -> Cell {
    let known = |piece: &Value| {
        name(piece).is_some_and(|n| !n.chars().any(|c| ('\u{180}'..='\u{2af}').contains(&c)))
    };
    let wrong = pairs.iter().filter_map(|pair| {
        let wanted = name(pair.piece).filter(|_| known(pair.piece))?;
        (wanted != pair.panel.name)
            .then(|| pair.says(format!("{:?} for {wanted:?}", pair.panel.name)))
    });
    let wrong: Vec<String> = wrong.collect();
    let ids: BTreeSet<&str> = pairs.iter().map(|p| p.panel.id.as_str()).collect();
    match pairs.iter().any(|p| name(p.piece).is_some()) {
        _ if ids.len() != pairs.len() => Cell::Wrong("ids are not distinct".into()),
        true => Cell::of(&wrong),
        false => Cell::Unsaid,
    }
}

/// `2` as drawn, or `1,1` as drawn and mirrored.
pub(super) fn quantities(pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    let mut compared = false;
    for pair in pairs {
        let Some(stated) = pair.piece["quantity"].as_str() else {
            continue;
        };
        compared = true;
        let mut parts = stated
            .split(',')
            .map(|n| n.trim().parse::<u32>().expect("a number"));
        let wanted = (parts.next().unwrap_or(0), parts.next().unwrap_or(0));
        let found = pair.panel.quantity.map(|q| (q.left, q.right));
        if found != Some(wanted) {
            wrong.push(pair.says(format!("{found:?} for {wanted:?}")));
        }
    }
    if compared {
        Cell::of(&wrong)
    } else {
        Cell::Unsaid
    }
}
