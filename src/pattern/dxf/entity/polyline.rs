//! Polylines with bulges as plain polylines.

use super::geometry::EntityPath;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Point2;
use crate::pattern::curve;
use crate::pattern::dxf::findings::at_line;

/// Largest bulge that is read: an arc that lacks 0.2 degrees of a full circle.
const LARGEST_BULGE: f64 = 1000.0;

/// Returns the polyline through vertices, each with the bulge of the arc to the next one.
///
/// # Errors
/// A bulge beyond [`LARGEST_BULGE`], or more than about `point_limit` points.
pub(super) fn with_bulges(
    vertices: &[(Point2, f64)],
    closed: bool,
    point_limit: usize,
    line: usize,
) -> Result<EntityPath, Fault> {
    let mut bulges = vertices.iter().map(|(_, bulge)| bulge);
    if let Some(bulge) = bulges.find(|bulge| bulge.abs() > LARGEST_BULGE) {
        let detail = format!("a vertex has the bulge {bulge}");
        return Err(Fault::new(PatternCode::Bulge, at_line(line), detail).fix("draw this arc anew"));
    }
    let mut points = Vec::with_capacity(vertices.len());
    let mut sampled = Vec::new();
    for (i, (a, bulge)) in vertices.iter().enumerate() {
        if points.len() > point_limit {
            return Err(too_many_points(line));
        }
        sampled.resize(points.len(), true);
        sampled.push(false);
        let first = vertices.first().filter(|_| closed);
        match vertices.get(i + 1).or(first) {
            Some((b, _)) => points.extend(curve::bulge(*a, *b, *bulge)),
            None => points.push(*a),
        }
    }
    sampled.resize(points.len(), true);
    Ok(EntityPath {
        points,
        closed,
        straight: false,
        sampled,
    })
}

/// Returns the fault for an entity at which the drawing has more points than are read.
pub(super) fn too_many_points(line: usize) -> Fault {
    Fault::new(
        PatternCode::TooLarge,
        at_line(line),
        "up to here the drawing has more points, with those that its curves are drawn with, than are read",
    )
    .fix("export fewer pieces or sizes, or fewer curves")
}
