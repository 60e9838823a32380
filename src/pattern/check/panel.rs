//! A panel that came as JSON: its numbers, outlines, holes and notches.

use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::crossing::crossing;
use crate::pattern::outline::ring_of;
use crate::pattern::point::{Point2, distance, is_readable};
use crate::pattern::polyline::{length, longest_side, signed_area};
use crate::pattern::{Corner, Edge, Hole, Panel};

/// An edge begins and ends at its corners to this accuracy: JSON writers round \[m\].
pub(super) const AT_CORNER: f64 = 1e-6;

/// A checker of one panel, which gathers its faults.
pub(super) struct PanelChecker<'a> {
    /// JSON Pointer of the panel.
    pointer: String,
    limits: &'a Limits,
    faults: Vec<Fault>,
}

impl<'a> PanelChecker<'a> {
    /// Returns the checker of the panel at `pointer`.
    pub(super) fn new(pointer: String, limits: &'a Limits) -> Self {
        Self {
            pointer,
            limits,
            faults: Vec::new(),
        }
    }

    /// Checks a panel and computes its lengths and areas; returns its faults.
    pub(super) fn check(mut self, panel: &mut Panel) -> Vec<Fault> {
        if panel.name.chars().count() > self.limits.name_chars {
            let detail = format!("a name has at most {} characters", self.limits.name_chars);
            self.fault(PatternCode::NameTooLong, "/name", detail, "shorten it");
        }
        // The outline of a mirrored copy runs the other way in its coordinates.
        let sense = if panel.copy_of.is_some() { -1.0 } else { 1.0 };
        if self.check_marks(panel)
            && self.check_outline("", &panel.corners, &mut panel.edges, -sense)
        {
            self.check_size(&panel.edges);
            self.check_notches(panel);
        }
        for (i, Hole { corners, edges }) in panel.holes.iter_mut().enumerate() {
            self.check_outline(&format!("/holes/{i}"), corners, edges, sense);
        }
        if self.faults.is_empty() {
            measure(panel);
        }
        self.faults
    }

    fn fault(&mut self, code: PatternCode, place: &str, detail: impl Into<String>, fix: &str) {
        let pointer = format!("{}{place}", self.pointer);
        self.faults.push(Fault::new(code, pointer, detail).fix(fix));
    }

    /// Checks that all numbers that are not of the outline are finite; returns false if not.
    fn check_marks(&mut self, panel: &Panel) -> bool {
        let mut marks = with_pointers("/cut_line", &panel.cut_line);
        marks.extend(with_pointers("/drill_holes", &panel.drill_holes));
        for (i, line) in panel.internal_lines.iter().enumerate() {
            marks.extend(with_pointers(&format!("/internal_lines/{i}"), line));
        }
        if let Some(grain) = panel.grain {
            marks.push(("/grain/angle_deg".to_owned(), [grain.angle_deg, 0.0]));
        }
        marks.retain(|(_, p)| !is_readable(*p));
        for (place, _) in &marks {
            let detail = "a number is not finite or is beyond 10 km";
            self.fault(PatternCode::NotFinite, place, detail, "correct it");
        }
        marks.is_empty()
    }

    /// Checks that corners and edges make up one simple closed polyline of the given sign of area,
    /// and computes lengths; returns false if not.
    fn check_outline(
        &mut self,
        place: &str,
        corners: &[Corner],
        edges: &mut [Edge],
        sign: f64,
    ) -> bool {
        let before = self.faults.len();
        if edges.len() != corners.len() || corners.is_empty() {
            let detail = format!(
                "{} corners and {} edges; an outline has as many of both, at least one",
                corners.len(),
                edges.len()
            );
            let place = format!("{place}/edges");
            let fix = "give one edge from each corner to the next";
            self.fault(PatternCode::Outline, &place, detail, fix);
            return false;
        }
        for (i, corner) in corners.iter().enumerate() {
            if corner.index != i || !is_readable([corner.x, corner.y]) {
                let detail = format!("corner {i} must have index {i} and finite coordinates");
                let place = format!("{place}/corners/{i}");
                let fix = "number corners from 0 and give meters";
                self.fault(PatternCode::Corner, &place, detail, fix);
            }
        }
        for (i, edge) in edges.iter_mut().enumerate() {
            let to = (i + 1) % corners.len();
            let ends = [(i, corners[i]), (to, corners[to])];
            self.check_edge(&format!("{place}/edges/{i}"), edge, ends);
        }
        if self.faults.len() > before {
            return false;
        }
        self.check_ring(&format!("{place}/edges"), &ring_of(edges), sign);
        self.faults.len() == before
    }

    /// Checks an edge between two corners, and sets its ends to them.
    fn check_edge(
        &mut self,
        place: &str,
        edge: &mut Edge,
        [(i, from), (k, to)]: [(usize, Corner); 2],
    ) {
        if edge.index != i || edge.from != i || edge.to != k {
            let detail =
                format!("edge {i} must have index {i} and run from corner {i} to corner {k}");
            let fix = "number edges like the corners that they leave";
            self.fault(PatternCode::Edge, place, detail, fix);
        }
        if let Some(at) = edge.points.iter().position(|p| !is_readable(*p)) {
            let place = format!("{place}/points/{at}");
            let detail = "a coordinate is not finite or is beyond 10 km";
            self.fault(PatternCode::NotFinite, &place, detail, "correct it");
            return;
        }
        let is_at = |p: Point2, corner: Corner| distance(p, [corner.x, corner.y]) <= AT_CORNER;
        let [first, .., last] = edge.points.as_mut_slice() else {
            return self.open_edge(place, [i, k]);
        };
        if !is_at(*first, from) || !is_at(*last, to) {
            return self.open_edge(place, [i, k]);
        }
        *first = [from.x, from.y];
        *last = [to.x, to.y];
        edge.length_m = length(&edge.points);
        if let Some(at) = edge.points.windows(2).position(|w| w[0] == w[1]) {
            let place = format!("{place}/points/{}", at + 1);
            let detail = "a point repeats the one before it";
            self.fault(PatternCode::DuplicatePoint, &place, detail, "leave it out");
        }
    }

    fn open_edge(&mut self, place: &str, [from, to]: [usize; 2]) {
        let place = format!("{place}/points");
        let detail =
            format!("the points must run from corner {from} to corner {to}, both included");
        let fix = "begin and end an edge at its corners";
        self.fault(PatternCode::OpenOutline, &place, detail, fix);
    }

    /// Checks that a closed polyline is simple and has the given sign of area.
    fn check_ring(&mut self, place: &str, ring: &[Point2], sign: f64) {
        if ring.len() > self.limits.panel_vertices {
            let detail = format!(
                "the outline has {} points; at most {} are read",
                ring.len(),
                self.limits.panel_vertices
            );
            let fix = "draw curves with fewer points";
            self.fault(PatternCode::TooLarge, place, detail, fix);
        } else if ring.len() < 3 {
            let detail = "the outline has fewer than 3 points";
            self.fault(PatternCode::NoArea, place, detail, "draw it anew");
        } else if let Some([x, y]) = crossing(ring) {
            let detail = format!("the outline crosses or touches itself at ({x:.4}, {y:.4})");
            let code = PatternCode::SelfIntersecting;
            self.fault(code, place, detail, "mend the outline");
        } else if signed_area(ring) * sign <= 0.0 {
            let way = if sign < 0.0 {
                "clockwise"
            } else {
                "counter-clockwise"
            };
            let detail = format!("the outline does not run {way} (y up)");
            let fix = "reverse corners and edges";
            self.fault(PatternCode::Orientation, place, detail, fix);
        }
    }

    fn check_size(&mut self, edges: &[Edge]) {
        let side = longest_side(&ring_of(edges));
        let [least, most] = self.limits.panel_size_m;
        if !(least..=most).contains(&side) {
            let detail =
                format!("the panel is {side} m long; sizes from {least} to {most} m are read");
            let fix = "give coordinates in meters";
            self.fault(PatternCode::ImplausibleSize, "/edges", detail, fix);
        }
    }

    fn check_notches(&mut self, panel: &Panel) {
        for (i, notch) in panel.notches.iter().enumerate() {
            let is_on_edge = notch.edge < panel.edges.len() && (0.0..=1.0).contains(&notch.at);
            if notch.index != i || !is_on_edge {
                let detail = format!(
                    "a notch has its own index ({i}), an edge below {} and a fraction from 0 to 1",
                    panel.edges.len()
                );
                let place = format!("/notches/{i}");
                self.fault(PatternCode::Notch, &place, detail, "correct it");
            }
        }
    }
}

/// Returns points with the pointer of each in its list.
fn with_pointers(list: &str, points: &[Point2]) -> Vec<(String, Point2)> {
    let points = points.iter().enumerate();
    points.map(|(i, p)| (format!("{list}/{i}"), *p)).collect()
}

/// Computes lengths and areas of a panel whose outline is right.
fn measure(panel: &mut Panel) {
    let outline = signed_area(&ring_of(&panel.edges)).abs();
    let holes: f64 = panel
        .holes
        .iter()
        .map(|hole| signed_area(&ring_of(&hole.edges)).abs())
        .sum();
    panel.area_m2 = outline - holes;
    panel.perimeter_m = panel.edges.iter().map(|edge| edge.length_m).sum();
    let is_drawn_otherwise = panel.unfolded || !panel.cut_line.is_empty();
    let is_plausible = panel.drawn_area_m2 > 0.0 && panel.drawn_area_m2.is_finite();
    if !(is_drawn_otherwise && is_plausible) {
        panel.drawn_area_m2 = outline;
    }
}
