//! A panel of a specification: one loop of edges over its vertices.
//!
//! The sign of the loop's area is the face: a loop that runs counter-clockwise shows the side that
//! is out. Outlines are stored clockwise, so that such a loop is gone backwards; the panel is never
//! mirrored.

use super::conventions::Conventions;
use super::edge::{read_edges, stored_edges};
use super::findings::SpecFindings;
use super::node::JsonNode;
use crate::fault::PatternCode;
use crate::pattern::crossing::crossing;
use crate::pattern::outline::corners_of;
use crate::pattern::point::Point2;
use crate::pattern::polyline::{longest_side, signed_area};
use crate::pattern::{Direction, Face, Panel};

/// A panel, with the relation of its drawn edges to the stored ones.
pub(super) struct DrawnPanel {
    /// The panel, without an id.
    pub(super) panel: Panel,
    /// Mean of its vertices \[m\].
    pub(super) mean: Point2,
    /// True if it was drawn counter-clockwise and its edges are stored backwards.
    reversed: bool,
}

impl DrawnPanel {
    /// Returns the stored corners from and to which drawn edge `edge` runs, and its direction;
    /// `None` if there is no such edge.
    pub(super) fn corners_of(&self, edge: usize) -> Option<(usize, usize, Direction)> {
        let count = self.panel.edges.len();
        if edge >= count {
            return None;
        }
        Some(if self.reversed {
            let from = (count - edge) % count;
            (from, count - 1 - edge, Direction::Ccw)
        } else {
            (edge, (edge + 1) % count, Direction::Cw)
        })
    }

    /// Returns the length of drawn edge `edge` \[m\].
    pub(super) fn length(&self, edge: usize) -> f64 {
        let count = self.panel.edges.len();
        let stored = if self.reversed {
            count - 1 - edge
        } else {
            edge
        };
        self.panel.edges[stored].length_m
    }
}

/// Reads a panel. Its faults are added to `findings`.
pub(super) fn read(
    (name, node): (&str, &JsonNode<'_>),
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<DrawnPanel> {
    let known = ["translation", "rotation", "vertices", "edges", "label"];
    node.fields(&known, findings)?;
    let before = findings.faults.len();
    let vertices = read_vertices(node, conventions, findings);
    let label = conventions.label(node, findings);
    let listed = node.require("edges", findings)?;
    let edges = read_edges(&listed, &vertices?, conventions, findings)?;
    let starts = edges.iter().map(|edge| edge.points[0]);
    let sum = starts.fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
    let mean = sum.map(|s| s / edges.len() as f64);
    let points = edges.iter().flat_map(|edge| edge.points.split_last());
    let ring: Vec<Point2> = points.flat_map(|(_, points)| points).copied().collect();
    check_outline(&listed, &ring, conventions, findings);
    if findings.faults.len() > before {
        return None;
    }
    let area = signed_area(&ring);
    let reversed = area > 0.0;
    let outline = stored_edges(edges, reversed);
    let face = if reversed { Face::Up } else { Face::Down };
    Some(DrawnPanel {
        panel: Panel {
            name: conventions.short(name),
            label,
            face: conventions.states_faces.then_some(face),
            area_m2: area.abs(),
            drawn_area_m2: area.abs(),
            perimeter_m: outline.iter().map(|edge| edge.length_m).sum(),
            corners: corners_of(&outline),
            edges: outline,
            ..Panel::default()
        },
        mean,
        reversed,
    })
}

/// Reads the vertices \[m\].
fn read_vertices(
    node: &JsonNode<'_>,
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<Vec<Point2>> {
    let listed = node.require("vertices", findings)?;
    let items = listed.items(conventions.limits.panel_vertices, findings)?;
    let points = items.iter().map(|item| conventions.point(item, findings));
    let points: Vec<Option<Point2>> = points.collect();
    points.into_iter().collect()
}

/// Checks that the outline is simple and has an area and a size within the limits.
fn check_outline(
    node: &JsonNode<'_>,
    ring: &[Point2],
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) {
    let limits = conventions.limits;
    findings.points += ring.len();
    let most = limits.panel_vertices;
    if ring.len() > most {
        let detail = format!(
            "the outline has {} points; at most {most} are read",
            ring.len()
        );
        findings.fault(node.fault(PatternCode::TooLarge, detail, "draw it with fewer edges"));
        return;
    }
    let side = longest_side(ring);
    let [least, most] = limits.panel_size_m;
    if !(least..=most).contains(&side) {
        let detail =
            format!("the panel is {side:.3e} m long; sizes from {least} to {most} m are read");
        let fix = "correct units_in_meter, or say the units with units=mm|cm|m|inch";
        findings.fault(node.fault(PatternCode::ImplausibleSize, detail, fix));
    } else if ring.len() < 3 || signed_area(ring).abs() < 1e-6 * side * side {
        findings.fault(node.fault(PatternCode::NoArea, "the panel has no area", "draw it anew"));
    } else if let Some([x, y]) = crossing(ring) {
        let [x, y] = [x, y].map(|c| c / conventions.scale);
        let detail = format!("the outline crosses or touches itself at ({x:.4}, {y:.4})");
        findings.fault(node.fault(PatternCode::SelfIntersecting, detail, "mend the outline"));
    }
}
