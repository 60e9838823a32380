//! Mirror images: the panel `sleeve~mirror` is `sleeve` reflected x -> -x.
//!
//! Corners, edges and notches keep their numbers and `cw` still means increasing index, so that the
//! outline of a copy runs counter-clockwise in its coordinates and its holes clockwise. The drawn
//! side stays the drawn side: a copy has the face that its source has.

use super::point::Point2;
use super::{Corner, Edge, Grain, Hole, Panel, Placement, PlacementAnchor};

/// Suffix of the id of a mirrored copy, after that of its source.
pub const MIRROR: &str = "~mirror";

/// Returns the mirrored copy of a panel.
pub(super) fn mirrored(source: &Panel) -> Panel {
    let grain = source.grain.map(|grain| Grain {
        angle_deg: (180.0 - grain.angle_deg).rem_euclid(180.0),
    });
    let hole = |hole: &Hole| Hole {
        corners: mirrored_corners(&hole.corners),
        edges: mirrored_edges(&hole.edges),
    };
    let lines = source.internal_lines.iter();
    Panel {
        id: format!("{}{MIRROR}", source.id),
        copy_of: Some(source.id.clone()),
        quantity: None,
        corners: mirrored_corners(&source.corners),
        edges: mirrored_edges(&source.edges),
        holes: source.holes.iter().map(hole).collect(),
        cut_line: mirrored_points(&source.cut_line),
        drill_holes: mirrored_points(&source.drill_holes),
        grain,
        internal_lines: lines.map(|line| mirrored_points(line)).collect(),
        ..source.clone()
    }
}

fn mirrored_points(points: &[Point2]) -> Vec<Point2> {
    points.iter().copied().map(mirrored_point).collect()
}

fn mirrored_edges(edges: &[Edge]) -> Vec<Edge> {
    let edge = |edge: &Edge| Edge {
        points: mirrored_points(&edge.points),
        ..edge.clone()
    };
    edges.iter().map(edge).collect()
}

fn mirrored_corners(corners: &[Corner]) -> Vec<Corner> {
    let corner = |corner: &Corner| Corner {
        x: mirrored_point([corner.x, corner.y])[0],
        ..*corner
    };
    corners.iter().map(corner).collect()
}

/// Returns a point reflected; 0 stays 0.
fn mirrored_point([x, y]: Point2) -> Point2 {
    [0.0 - x, y]
}

impl Placement {
    /// Returns the mirror image of this placement about the body's middle, for a mirrored copy.
    ///
    /// With S the reflection x -> -x, a copy's point S v goes to S (R v + t) = (S R S) S v + S t.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let [x, y, z] = self.offset_m;
        let [about_x, about_y, about_z] = self.rotate_deg;
        Self {
            at: self.at.map(PlacementAnchor::mirrored),
            up_deg: self.up_deg.map(|angle| 180.0 - angle),
            offset_m: [-x, y, z],
            rotate_deg: [about_x, -about_y, -about_z],
            wrap: self.wrap,
        }
    }
}

impl PlacementAnchor {
    /// Returns the key point on the other side of the body.
    fn mirrored(self) -> Self {
        match self {
            Self::ArmLeft => Self::ArmRight,
            Self::ArmRight => Self::ArmLeft,
            Self::ArmLeftFront => Self::ArmRightFront,
            Self::ArmRightFront => Self::ArmLeftFront,
            Self::ArmLeftBack => Self::ArmRightBack,
            Self::ArmRightBack => Self::ArmLeftBack,
            Self::LegLeft => Self::LegRight,
            Self::LegRight => Self::LegLeft,
            other => other,
        }
    }
}
