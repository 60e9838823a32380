//! A pattern that came as JSON: checked as a whole, all faults at once, and what is derived in it computed anew.

use super::assemble;
use super::copies;
use super::point::{Point2, distance};
use super::polyline::{crossing, length, signed_area};
use super::{Corner, Edge, Hole, Panel, Pattern};
use crate::config::Limits;
use crate::fault::{Fault, Faults};
use std::collections::BTreeSet;

/// An edge begins and ends at its corners to this accuracy: JSON writers round \[m\].
const AT_CORNER: f64 = 1e-6;

/// Coordinates up to this are read \[m\].
const FAR: f64 = 1e4;

/// Checks `pattern` and recomputes lengths, perimeters and areas.
pub(super) fn checked(mut pattern: Pattern, limits: &Limits) -> Result<Pattern, Faults> {
    let mut faults = Faults(Vec::new());
    if pattern.panels.is_empty() {
        faults.0.push(
            Fault::new("pattern/no_panels", "/panels", "the pattern has no panels")
                .fix("give at least one"),
        );
    }
    let is_drawn = |panel: &&Panel| panel.copy_of.is_none();
    let drawn = pattern.panels.iter().filter(is_drawn).count();
    if drawn > limits.panels || pattern.panels.len() > 2 * limits.panels {
        let detail = format!(
            "the pattern has {} panels; at most {} are read",
            pattern.panels.len(),
            limits.panels
        );
        return Err(Fault::new("pattern/too_many_panels", "/panels", detail)
            .fix("leave some out")
            .into());
    }
    if pattern.seams.len() > limits.seams {
        let detail = format!(
            "the pattern has {} seams; at most {} are read",
            pattern.seams.len(),
            limits.seams
        );
        return Err(Fault::new("pattern/too_many_seams", "/seams", detail)
            .fix("leave some out")
            .into());
    }
    faults.0.extend(ids(&pattern, limits));
    for (i, panel) in pattern.panels.iter_mut().enumerate() {
        let mut found = Checker {
            at: format!("/panels/{i}"),
            limits,
            faults: Vec::new(),
        };
        found.panel(panel);
        faults.0.extend(found.faults);
    }
    faults.0.extend(copies::verify(&mut pattern, AT_CORNER));
    faults.0.extend(placements(&pattern));
    faults.or(pattern)
}

/// Placements are of panels that are there, at finite places.
fn placements(pattern: &Pattern) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (id, placement) in &pattern.placements {
        let at = format!("/placements/{}", id.replace('~', "~0").replace('/', "~1"));
        if pattern.panel_index(id).is_none() {
            faults.push(
                Fault::new(
                    "pattern/unknown_panel",
                    at.clone(),
                    format!("there is no panel {id:?}"),
                )
                .fix("name a panel of this pattern"),
            );
        }
        let numbers = placement.offset_m.iter().chain(&placement.rotate_deg);
        if numbers.into_iter().any(|c| c.is_nan() || c.abs() > FAR) {
            faults.push(
                Fault::new(
                    "pattern/not_finite",
                    at,
                    "a number is not finite or is beyond 10 km",
                )
                .fix("correct it"),
            );
        }
    }
    faults
}

/// Ids are there, short and different.
fn ids(pattern: &Pattern, limits: &Limits) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    for (i, panel) in pattern.panels.iter().enumerate() {
        let at = format!("/panels/{i}/id");
        if panel.id.is_empty() || panel.id.chars().count() > limits.name_chars {
            let detail = format!("an id has 1 to {} characters", limits.name_chars);
            faults.push(Fault::new("pattern/id", at.clone(), detail).fix("give it another id"));
        }
        if !seen.insert(&panel.id) {
            let detail = format!("{:?} is the id of an earlier panel", panel.id);
            faults.push(
                Fault::new("pattern/duplicate_id", at, detail).fix("give every panel its own id"),
            );
        }
    }
    faults
}

struct Checker<'a> {
    at: String,
    limits: &'a Limits,
    faults: Vec<Fault>,
}

impl Checker<'_> {
    fn fault(&mut self, code: &str, place: &str, detail: impl Into<String>, fix: &str) {
        self.faults
            .push(Fault::new(code, format!("{}{place}", self.at), detail).fix(fix));
    }

    fn panel(&mut self, panel: &mut Panel) {
        if panel.name.chars().count() > self.limits.name_chars {
            let detail = format!("a name has at most {} characters", self.limits.name_chars);
            self.fault("pattern/name_too_long", "/name", detail, "shorten it");
        }
        // The outline of a mirrored copy runs the other way in its coordinates.
        let sense = if panel.copy_of.is_some() { -1.0 } else { 1.0 };
        if self.marks(panel) && self.outline("", &panel.corners, &mut panel.edges, -sense) {
            self.size(&panel.edges);
            self.notches(panel);
        }
        for (i, Hole { corners, edges }) in panel.holes.iter_mut().enumerate() {
            self.outline(&format!("/holes/{i}"), corners, edges, sense);
        }
        if self.faults.is_empty() {
            derive(panel);
        }
    }

    /// All numbers that are not of the outline are finite.
    fn marks(&mut self, panel: &Panel) -> bool {
        let mut places: Vec<(String, Point2)> = Vec::new();
        places.extend(
            panel
                .cut_line
                .iter()
                .enumerate()
                .map(|(i, p)| (format!("/cut_line/{i}"), *p)),
        );
        places.extend(
            panel
                .drill_holes
                .iter()
                .enumerate()
                .map(|(i, p)| (format!("/drill_holes/{i}"), *p)),
        );
        for (i, line) in panel.internal_lines.iter().enumerate() {
            places.extend(
                line.iter()
                    .enumerate()
                    .map(|(k, p)| (format!("/internal_lines/{i}/{k}"), *p)),
            );
        }
        if let Some(grain) = panel.grain {
            places.push(("/grain/angle_deg".to_owned(), [grain.angle_deg, 0.0]));
        }
        let far: Vec<String> = places
            .into_iter()
            .filter(|(_, p)| !near(*p))
            .map(|(place, _)| place)
            .collect();
        for place in &far {
            self.fault(
                "pattern/not_finite",
                place,
                "a number is not finite or is beyond 10 km",
                "correct it",
            );
        }
        far.is_empty()
    }

    /// Corners and edges make up one simple closed polyline of the given sign of area; lengths are recomputed.
    fn outline(&mut self, place: &str, corners: &[Corner], edges: &mut [Edge], sign: f64) -> bool {
        let before = self.faults.len();
        if edges.len() != corners.len() || corners.is_empty() {
            let detail = format!(
                "{} corners and {} edges; an outline has as many of both, at least one",
                corners.len(),
                edges.len()
            );
            self.fault(
                "pattern/outline",
                &format!("{place}/edges"),
                detail,
                "give one edge from each corner to the next",
            );
            return false;
        }
        for (i, corner) in corners.iter().enumerate() {
            if corner.index != i || !near([corner.x, corner.y]) {
                let detail = format!("corner {i} must have index {i} and finite coordinates");
                self.fault(
                    "pattern/corner",
                    &format!("{place}/corners/{i}"),
                    detail,
                    "number corners from 0 and give metres",
                );
            }
        }
        for (i, edge) in edges.iter_mut().enumerate() {
            let to = (i + 1) % corners.len();
            self.edge(
                &format!("{place}/edges/{i}"),
                edge,
                [(i, corners[i]), (to, corners[to])],
            );
        }
        if self.faults.len() > before {
            return false;
        }
        self.closed(place, &assemble::ring(edges), sign);
        self.faults.len() == before
    }

    fn edge(&mut self, place: &str, edge: &mut Edge, [(i, from), (k, to)]: [(usize, Corner); 2]) {
        if edge.index != i || edge.from != i || edge.to != k {
            let detail =
                format!("edge {i} must have index {i} and run from corner {i} to corner {k}");
            self.fault(
                "pattern/edge",
                place,
                detail,
                "number edges like the corners that they leave",
            );
        }
        if let Some(at) = edge.points.iter().position(|p| !near(*p)) {
            self.fault(
                "pattern/not_finite",
                &format!("{place}/points/{at}"),
                "a coordinate is not finite or is beyond 10 km",
                "correct it",
            );
            return;
        }
        let ends = edge
            .points
            .first()
            .copied()
            .zip(edge.points.last().copied());
        let at = |p: Point2, corner: Corner| distance(p, [corner.x, corner.y]) <= AT_CORNER;
        match ends {
            Some((a, b)) if edge.points.len() > 1 && at(a, from) && at(b, to) => {
                let last = edge.points.len() - 1;
                edge.points[0] = [from.x, from.y];
                edge.points[last] = [to.x, to.y];
                edge.length_m = length(&edge.points);
                if let Some(at) = edge.points.windows(2).position(|w| w[0] == w[1]) {
                    self.fault(
                        "pattern/duplicate_point",
                        &format!("{place}/points/{}", at + 1),
                        "a point repeats the one before it",
                        "leave it out",
                    );
                }
            }
            _ => {
                let detail =
                    format!("the points must run from corner {i} to corner {k}, both included");
                self.fault(
                    "pattern/open_outline",
                    &format!("{place}/points"),
                    detail,
                    "begin and end an edge at its corners",
                );
            }
        }
    }

    fn closed(&mut self, place: &str, ring: &[Point2], sign: f64) {
        let edges = format!("{place}/edges");
        if ring.len() > self.limits.panel_vertices {
            let detail = format!(
                "the outline has {} points; at most {} are read",
                ring.len(),
                self.limits.panel_vertices
            );
            self.fault(
                "pattern/too_large",
                &edges,
                detail,
                "draw curves with fewer points",
            );
        } else if ring.len() < 3 {
            self.fault(
                "pattern/no_area",
                &edges,
                "the outline has fewer than 3 points",
                "draw it anew",
            );
        } else if let Some([x, y]) = crossing(ring) {
            let detail = format!("the outline crosses or touches itself at ({x:.4}, {y:.4})");
            self.fault(
                "pattern/self_intersecting",
                &edges,
                detail,
                "mend the outline",
            );
        } else if signed_area(ring) * sign <= 0.0 {
            let way = if sign < 0.0 {
                "clockwise"
            } else {
                "counter-clockwise"
            };
            self.fault(
                "pattern/orientation",
                &edges,
                format!("the outline does not run {way} (y up)"),
                "reverse corners and edges",
            );
        }
    }

    fn size(&mut self, edges: &[Edge]) {
        let [low, high] = super::polyline::bounds(&assemble::ring(edges));
        let side = (high[0] - low[0]).max(high[1] - low[1]);
        let [least, most] = self.limits.panel_size_m;
        if !(least..=most).contains(&side) {
            let detail =
                format!("the panel is {side} m long; sizes from {least} to {most} m are read");
            self.fault(
                "pattern/implausible_size",
                "/edges",
                detail,
                "give coordinates in metres",
            );
        }
    }

    fn notches(&mut self, panel: &Panel) {
        for (i, notch) in panel.notches.iter().enumerate() {
            if notch.index != i
                || notch.edge >= panel.edges.len()
                || !(0.0..=1.0).contains(&notch.at)
            {
                let detail = format!(
                    "a notch has its own index ({i}), an edge below {} and a fraction from 0 to 1",
                    panel.edges.len()
                );
                self.fault(
                    "pattern/notch",
                    &format!("/notches/{i}"),
                    detail,
                    "correct it",
                );
            }
        }
    }
}

fn near(p: Point2) -> bool {
    p.iter().all(|c| c.abs() <= FAR)
}

/// Lengths and areas of a panel whose outline is right.
fn derive(panel: &mut Panel) {
    let outline = signed_area(&assemble::ring(&panel.edges)).abs();
    let holes: f64 = panel
        .holes
        .iter()
        .map(|hole| signed_area(&assemble::ring(&hole.edges)).abs())
        .sum();
    panel.area_m2 = outline - holes;
    panel.perimeter_m = panel.edges.iter().map(|edge| edge.length_m).sum();
    let drawn_otherwise = panel.unfolded || !panel.cut_line.is_empty();
    let plausible = panel.drawn_area_m2 > 0.0 && panel.drawn_area_m2.is_finite();
    if !(drawn_otherwise && plausible) {
        panel.drawn_area_m2 = outline;
    }
}
