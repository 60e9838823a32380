//! Seam allowance cut away: the outline of a panel, given as cut, moved inwards by a width.
//!
//! Every segment of the outline moves in parallel, neighbors meet where their lines do (a miter, as
//! patterns are marked), and a segment that has shrunk to nothing is left out from then on: the
//! edge events of the straight skeleton (O. Aichholzer, F. Aurenhammer, "Straight skeletons for
//! general polygonal figures", COCOON 1996), in the order in which they happen. Its other events,
//! parts of the outline that run into each other, are found as crossings at the end and refused.
//! For a smooth convex outline of area A and length L the area left is A - p L + pi p² (Steiner).
//!
//! O(n log n) for n points, besides the search for crossings.

mod faults;
mod moving_outline;

use super::crossing::crossing;
use super::mirror::mirrored;
use super::outline::{corners_of, ring_of};
use super::point::{Point2, distance, sub};
use super::polyline::{contains, length, longest_side, nearest, signed_area};
use super::{Edge, Notch, Panel};
use crate::fault::Fault;
use faults::{nothing_left, refuse};
use moving_outline::MovingOutline;

impl Panel {
    /// Returns the panel with `allowance_m` cut away inside its outline, which becomes its cut
    /// line. Corners, edges and notches keep their numbers; holes, internal lines and drill holes
    /// stay where they are.
    ///
    /// # Errors
    /// A panel that has a cut line already, an edge of which nothing is left, parts that run into
    /// each other, a corner that juts in too sharply. The pointer is empty.
    pub fn without_allowance(&self, allowance_m: f64) -> Result<Self, Fault> {
        if allowance_m == 0.0 {
            return Ok(self.clone());
        }
        if !(allowance_m > 0.0 && allowance_m.is_finite()) {
            let detail = format!("{allowance_m} m is no width");
            return Err(refuse(detail, "give a width of 0 or more"));
        }
        if self.copy_of.is_some() {
            // Reflected it runs clockwise like every other panel.
            let drawn = Self {
                copy_of: None,
                ..mirrored(self)
            };
            return Ok(Self {
                id: self.id.clone(),
                copy_of: self.copy_of.clone(),
                ..mirrored(&drawn.without_allowance(allowance_m)?)
            });
        }
        if !self.cut_line.is_empty() {
            let detail = format!(
                "panel {} has a cut line of its own: its outline is the sew line",
                self.id
            );
            return Err(refuse(detail, "give 0"));
        }
        inset(self, allowance_m)
    }
}

/// Returns the panel inside its allowance, by its moving outline.
fn inset(panel: &Panel, width: f64) -> Result<Panel, Fault> {
    let mut moving = MovingOutline::of(&panel.edges);
    moving.check_corners(panel)?;
    moving.advance(width);
    let edges = moving.edges(panel, width)?;
    let ring = ring_of(&edges);
    if let Some([x, y]) = crossing(&ring) {
        let detail = format!(
            "with {width} m cut away, parts of panel {} run into each other at ({x:.4}, {y:.4})",
            panel.id
        );
        return Err(refuse(detail, "give a smaller allowance"));
    }
    let [area, hole_area] = [
        -signed_area(&ring),
        panel
            .holes
            .iter()
            .map(|hole| signed_area(&ring_of(&hole.edges)))
            .sum(),
    ];
    // Turned inside out, or larger than before: nothing of it is left.
    if ring.len() < 3 || area <= 0.0 || longest_side(&ring) >= longest_side(&ring_of(&panel.edges))
    {
        return Err(nothing_left(panel, width));
    }
    let in_hole = panel.holes.iter().flat_map(|hole| &hole.edges);
    if let Some([x, y]) = in_hole
        .flat_map(|edge| &edge.points)
        .find(|p| !contains(&ring, **p))
    {
        let detail = format!(
            "with {width} m cut away, panel {} runs into its hole at ({x:.4}, {y:.4})",
            panel.id
        );
        return Err(refuse(detail, "give a smaller allowance"));
    }
    Ok(Panel {
        area_m2: area - hole_area.abs(),
        perimeter_m: edges.iter().map(|edge| edge.length_m).sum(),
        corners: corners_of(&edges),
        notches: notches(panel, &edges, width),
        cut_line: ring_of(&panel.edges),
        edges,
        ..panel.clone()
    })
}

/// Returns the notches, each at the place of its edge that is straight inwards.
fn notches(panel: &Panel, edges: &[Edge], width: f64) -> Vec<Notch> {
    let moved = |notch: &Notch| {
        let cut = &panel.edges[notch.edge];
        let place = inwards(cut, notch.at, width);
        let points = &edges[notch.edge].points;
        let foot = nearest(points.windows(2).map(|pair| (pair[0], pair[1])), place);
        let at = foot.map_or(notch.at, |foot| {
            let before = length(&points[..=foot.segment]);
            let part = foot.at * distance(points[foot.segment], points[foot.segment + 1]);
            ((before + part) / edges[notch.edge].length_m).clamp(0.0, 1.0)
        });
        Notch { at, ..*notch }
    };
    panel.notches.iter().map(moved).collect()
}

/// Returns the point `width` inwards from an edge at a fraction of its length.
fn inwards(edge: &Edge, at: f64, width: f64) -> Point2 {
    let mut left = at * edge.length_m;
    let last = edge.points.len() - 2;
    for (i, pair) in edge.points.windows(2).enumerate() {
        let length = distance(pair[0], pair[1]);
        if left <= length || i == last {
            let d = sub(pair[1], pair[0]).map(|c| c / length);
            let way = left.min(length);
            return [
                pair[0][0] + way * d[0] + width * d[1],
                pair[0][1] + way * d[1] - width * d[0],
            ];
        }
        left -= length;
    }
    edge.points[0]
}
