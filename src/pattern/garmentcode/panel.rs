//! A panel of a specification: one loop of edges over its vertices.
//!
//! The sign of the loop's area is the face: a loop that runs counter-clockwise shows the side that is out. Outlines
//! are stored clockwise, so such a loop is gone backwards; the panel is never mirrored.

use super::conventions::Conventions;
use super::edge::EdgeCurve;
use super::findings::SpecFindings;
use super::node::JsonNode;
use crate::fault::PatternCode;
use crate::pattern::crossing::crossing;
use crate::pattern::point::Point2;
use crate::pattern::polyline::{length, longest_side, signed_area};
use crate::pattern::{Corner, Direction, Edge, Face, Panel};

/// An edge as drawn.
struct DrawnEdge {
    ends: [usize; 2],
    points: Vec<Point2>,
    label: Option<String>,
}

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
    /// Returns the stored corners from and to which drawn edge `edge` runs, and its direction; `None`
    /// if there is no such edge.
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
        let index = if self.reversed {
            count - 1 - edge
        } else {
            edge
        };
        self.panel.edges[index].length_m
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
    let label = read_label(node, conventions, findings);
    let listed = node.require("edges", findings)?;
    let edges = read_edges(&listed, &vertices?, conventions, findings)?;
    let used: Vec<Point2> = edges.iter().map(|edge| edge.points[0]).collect();
    let sum = used
        .iter()
        .fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
    let mean = sum.map(|s| s / used.len() as f64);
    let mut ring: Vec<Point2> = Vec::new();
    for edge in &edges {
        ring.extend(&edge.points[..edge.points.len() - 1]);
    }
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
            corners: outline.iter().map(corner).collect(),
            edges: outline,
            ..Panel::default()
        },
        mean,
        reversed,
    })
}

fn corner(edge: &Edge) -> Corner {
    let [x, y] = edge.points[0];
    let index = edge.index;
    Corner { index, x, y }
}

/// Reads a label; `None` where it is empty.
fn read_label(
    node: &JsonNode<'_>,
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<String> {
    let text = node.get("label")?.text(findings)?;
    (!text.is_empty()).then(|| conventions.short(text))
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

/// Reads the edges, each of which begins where the one before it ends.
fn read_edges(
    listed: &JsonNode<'_>,
    vertices: &[Point2],
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<Vec<DrawnEdge>> {
    let items = listed.items(conventions.limits.panel_vertices, findings)?;
    if items.is_empty() {
        let detail = "the panel has no edges";
        findings.fault(listed.fault(PatternCode::NoOutline, detail, "give its outline"));
        return None;
    }
    let read: Vec<Option<DrawnEdge>> = items
        .iter()
        .map(|item| read_edge(item, vertices, conventions, findings))
        .collect();
    let edges = read.into_iter().collect::<Option<Vec<DrawnEdge>>>()?;
    let mut used = vec![false; vertices.len()];
    for (i, item) in items.iter().enumerate() {
        let next = &edges[(i + 1) % edges.len()];
        let [from, to] = edges[i].ends;
        used[from] = true;
        if to != next.ends[0] {
            let detail = format!(
                "it ends at vertex {to} and the next begins at vertex {}",
                next.ends[0]
            );
            let fix = "list the edges of one closed loop in order";
            findings.fault(item.fault(PatternCode::OpenOutline, detail, fix));
        }
    }
    if let Some(unused) = used.iter().position(|used| !used) {
        let detail = format!("vertex {unused} is on no edge and is left out");
        findings.warn(PatternCode::VertexIgnored, &listed.pointer, detail);
    }
    Some(edges)
}

/// Reads an edge between two of `vertices`.
fn read_edge(
    node: &JsonNode<'_>,
    vertices: &[Point2],
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<DrawnEdge> {
    node.fields(&["endpoints", "curvature", "label"], findings)?;
    let label = read_label(node, conventions, findings);
    let curve = match node.get("curvature") {
        Some(given) => {
            let curve = EdgeCurve::read(&given, conventions.relative, findings);
            curve.map(|curve| curve.scaled(conventions.scale))
        }
        None => Some(EdgeCurve::Line),
    };
    let ends = node.require("endpoints", findings)?;
    let items = ends.items(2, findings)?;
    let indices: Vec<Option<usize>> = items.iter().map(|item| item.index(findings)).collect();
    let ends_at = match indices.as_slice() {
        [Some(a), Some(b)] if *a < vertices.len() && *b < vertices.len() => [*a, *b],
        _ => {
            let detail = format!("two vertices from 0 to {} are needed", vertices.len() - 1);
            findings.fault(ends.fault(PatternCode::Edge, detail, "name the vertices of the edge"));
            return None;
        }
    };
    let [a, b] = ends_at.map(|i| vertices[i]);
    if a == b {
        let detail = "both ends of the edge are at the same place";
        findings.fault(ends.fault(PatternCode::Edge, detail, "leave the edge out"));
        return None;
    }
    let Some(points) = curve?.points(a, b) else {
        let detail = "the ends of the edge are farther apart than the diameter of its arc";
        findings.fault(node.fault(PatternCode::Edge, detail, "give a larger radius"));
        return None;
    };
    let ends = ends_at;
    Some(DrawnEdge {
        ends,
        points,
        label,
    })
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

/// Returns the edges as stored: clockwise from the same first corner.
fn stored_edges(drawn: Vec<DrawnEdge>, reversed: bool) -> Vec<Edge> {
    let count = drawn.len();
    let mut drawn = drawn;
    if reversed {
        drawn.reverse();
        for edge in &mut drawn {
            edge.points.reverse();
        }
    }
    let edge = |(index, edge): (usize, DrawnEdge)| Edge {
        index,
        from: index,
        to: (index + 1) % count,
        length_m: length(&edge.points),
        points: edge.points,
        label: edge.label,
    };
    drawn.into_iter().enumerate().map(edge).collect()
}
