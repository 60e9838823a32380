//! Areas and lengths as drawn: outlines, internal lines, sew lines.

use super::super::raw::{Entity, P};
use super::super::rings::{apart, distance, length};
use super::{Cell, File, Pair, area, list, off};

/// A tenth of a percent.
const SAME: f64 = 1e-3;

pub(super) fn areas(pairs: &[Pair<'_>]) -> Cell {
    let wrong = |p: &Pair<'_>| {
        let (found, wanted) = (1e6 * p.panel.drawn_area_m2, area(p.piece));
        (off(found, wanted) > SAME).then(|| p.says(format!("{found:.0} for {wanted:.0} mm2")))
    };
    Cell::of(&pairs.iter().filter_map(wrong).collect::<Vec<_>>())
}

/// Perimeters of what was drawn: of an unfolded panel, half its perimeter and its fold.
pub(super) fn perimeters(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    for pair in pairs {
        let own = pair.piece["perimeter_mm"].as_f64();
        let wanted = own
            .or(pair.piece["outline"]["perimeter_mm"].as_f64())
            .expect("a perimeter");
        let ring = if own.is_some() {
            pair.ring()
        } else {
            pair.cut()
        };
        let whole = length(&ring, true);
        let found = if pair.panel.unfolded {
            whole / 2.0 + fold_length(file, pair, &ring)
        } else {
            whole
        };
        if off(found, wanted) > SAME {
            wrong.push(pair.says(format!("{found:.2} for {wanted:.2} mm")));
        }
    }
    Cell::of(&wrong)
}

/// How long the panel is along its fold: between the outermost points on it, or as the truth's edges say.
fn fold_length(file: &File<'_>, pair: &Pair<'_>, ring: &[P]) -> f64 {
    if let Some(fold) = pair.mirror() {
        let [a, b] = fold;
        let (u, l) = ([b[0] - a[0], b[1] - a[1]], distance(a, b));
        let side = |p: &P| ((p[0] - a[0]) * u[1] - (p[1] - a[1]) * u[0]) / l;
        let along = |p: &P| ((p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1]) / l;
        let on: Vec<f64> = ring
            .iter()
            .filter(|p| side(p).abs() < 0.3)
            .map(along)
            .collect();
        let least = on.iter().copied().fold(f64::INFINITY, f64::min);
        return on.iter().copied().fold(f64::NEG_INFINITY, f64::max) - least;
    }
    let part = file
        .truth
        .as_ref()
        .map(|t| &t["parts"][pair.panel.name.as_str()]["edges"]);
    let edges = part.map_or(&[][..], list);
    let on_fold = edges.iter().zip(super::corners::on_fold(edges));
    on_fold
        .filter(|(_, on)| *on)
        .filter_map(|(e, _)| e["length_mm"].as_f64())
        .sum()
}

/// Internal lines: their length, all together. What became the sew line is none.
pub(super) fn lines(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    let mut compared = false;
    for pair in pairs {
        let Some(block) = pair.block else { continue };
        compared = true;
        let drawn = block
            .entities
            .iter()
            .filter(|e| e.layer == "8" && e.points.len() > 1);
        let seam = length(&pair.ring(), true);
        let is_sewn = |e: &Entity| {
            !pair.panel.cut_line.is_empty()
                && e.closed
                && off(file.scale * length(&e.points, true), seam) < SAME
        };
        let wanted: f64 = drawn
            .filter(|e| !is_sewn(e))
            .map(|e| file.scale * length(&e.points, e.closed))
            .sum();
        let found: f64 = pair
            .panel
            .internal_lines
            .iter()
            .map(|l| 1000.0 * length(l, false))
            .sum();
        let found = if pair.panel.unfolded {
            found / 2.0
        } else {
            found
        };
        if (found - wanted).abs() > SAME * wanted.max(1.0) {
            wrong.push(pair.says(format!("{found:.1} for {wanted:.1} mm of lines")));
        }
    }
    if compared {
        Cell::of(&wrong)
    } else {
        Cell::Unsaid
    }
}

/// Sew lines became the outline: layer 14, a line inside a flat outline, or the seam of a general drawing.
pub(super) fn sew(file: &File<'_>, pairs: &[Pair<'_>]) -> Cell {
    let mut wrong = Vec::new();
    let mut compared = false;
    for pair in pairs {
        let found = 1e6 * pair.panel.area_m2 / if pair.panel.unfolded { 2.0 } else { 1.0 };
        if let Some(sew) = list(&pair.piece["sew_line"]).first() {
            compared = true;
            let long = sew["perimeter_mm"].as_f64().expect("a length");
            let whole = length(&pair.ring(), true);
            let half = if pair.panel.unfolded {
                whole / 2.0
            } else {
                whole
            };
            if off(half, long) > SAME || pair.panel.cut_line.is_empty() {
                wrong.push(pair.says(format!("outline of {half:.1}, sew line of {long:.1} mm")));
            }
        } else if let Some(inner) = list(&pair.piece["inner_closed_loops"]).first() {
            compared = true;
            let wanted = inner["area_mm2"].as_f64().expect("an area");
            if off(found, wanted) > SAME {
                wrong.push(pair.says(format!("{found:.0}, sew line around {wanted:.0} mm2")));
            }
        } else if pair.piece["has_cut_line"] == true {
            compared = true;
            if pair.panel.cut_line.is_empty() {
                wrong.push(pair.says("the cut line is lost"));
            }
        } else if let Some(inner) = pair.block.and_then(|b| closed_line(b)) {
            compared = true;
            let own: Vec<P> = pair.ring();
            let scaled = |p: &P| [file.scale * p[0], file.scale * p[1]];
            if inner
                .points
                .iter()
                .any(|p| apart(scaled(p), &own, true) > 0.02)
            {
                wrong.push(pair.says("a closed line on layer 8 is not the outline"));
            }
        }
    }
    if compared {
        Cell::of(&wrong)
    } else {
        Cell::Unsaid
    }
}

/// The closed line on layer 8 of a block without a sew line: where Valentina puts it.
fn closed_line(block: &super::raw::Block) -> Option<&Entity> {
    let mut closed = block
        .entities
        .iter()
        .filter(|e| e.layer == "8" && e.closed && e.kind.ends_with("POLYLINE"));
    let found = closed.next().filter(|_| closed.next().is_none());
    found.filter(|_| !block.entities.iter().any(|e| e.layer == "2"))
}
