//! The edges of a panel of a specification, as drawn and as stored.

use super::conventions::Conventions;
use super::curve::EdgeCurve;
use super::findings::SpecFindings;
use super::node::JsonNode;
use crate::fault::PatternCode;
use crate::pattern::polyline::length;
use crate::pattern::{Edge, Point2};

/// An edge as drawn.
pub(super) struct DrawnEdge {
    /// Indices of the vertices from and to which it runs.
    ends: [usize; 2],
    /// Its polyline, both vertices included \[m\].
    pub(super) points: Vec<Point2>,
    label: Option<String>,
}

/// Reads the edges, each of which begins where the one before it ends.
pub(super) fn read_edges(
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
    check_loop(&items, &edges, findings);
    warn_of_unused(listed, vertices.len(), &edges, findings);
    Some(edges)
}

/// Checks that each edge begins where the one before it ends.
fn check_loop(items: &[JsonNode<'_>], edges: &[DrawnEdge], findings: &mut SpecFindings) {
    for (i, item) in items.iter().enumerate() {
        let to = edges[i].ends[1];
        let next = edges[(i + 1) % edges.len()].ends[0];
        if to != next {
            let detail = format!("it ends at vertex {to} and the next begins at vertex {next}");
            let fix = "list the edges of one closed loop in order";
            findings.fault(item.fault(PatternCode::OpenOutline, detail, fix));
        }
    }
}

/// Warns of the first vertex that no edge begins at.
fn warn_of_unused(
    listed: &JsonNode<'_>,
    vertex_count: usize,
    edges: &[DrawnEdge],
    findings: &mut SpecFindings,
) {
    let mut is_used = vec![false; vertex_count];
    for edge in edges {
        is_used[edge.ends[0]] = true;
    }
    if let Some(unused) = is_used.iter().position(|is_used| !is_used) {
        let detail = format!("vertex {unused} is on no edge and is left out");
        findings.warn(PatternCode::VertexIgnored, &listed.pointer, detail);
    }
}

/// Reads an edge between two of `vertices`.
fn read_edge(
    node: &JsonNode<'_>,
    vertices: &[Point2],
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) -> Option<DrawnEdge> {
    node.fields(&["endpoints", "curvature", "label"], findings)?;
    let label = conventions.label(node, findings);
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
    let vertex_indices = match indices.as_slice() {
        [Some(a), Some(b)] if *a < vertices.len() && *b < vertices.len() => [*a, *b],
        _ => {
            let detail = format!("two vertices from 0 to {} are needed", vertices.len() - 1);
            findings.fault(ends.fault(PatternCode::Edge, detail, "name the vertices of the edge"));
            return None;
        }
    };
    let [a, b] = vertex_indices.map(|i| vertices[i]);
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
    Some(DrawnEdge {
        ends: vertex_indices,
        points,
        label,
    })
}

/// Returns the edges as stored: clockwise from the same first corner.
pub(super) fn stored_edges(mut drawn: Vec<DrawnEdge>, reversed: bool) -> Vec<Edge> {
    let count = drawn.len();
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
