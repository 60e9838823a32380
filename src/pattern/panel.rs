//! A panel: one flat part of a garment, valid by construction.

use super::point::Point2;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// One flat part of a garment.
///
/// The outline is a simple closed polyline stored clockwise (y up): `corners[i]`, then `edges[i]`
/// from corner `i` to corner `i + 1` (the last edge back to corner 0). Coordinates are in meters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Panel {
    /// Id, unique in the pattern: made from the name (lower case, `-` for what is not a letter or
    /// digit).
    pub id: String,
    /// Name, as the file has it.
    pub name: String,
    /// Part of the body or garment, where the file gives it (`GarmentCode`: `body`, `arm`, `leg`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// Side that is out, where the file gives it (`GarmentCode`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<Face>,
    /// Area inside the outline less the holes \[m²\].
    pub area_m2: f64,
    /// Length of the outline \[m\].
    pub perimeter_m: f64,
    /// Area of the outline as drawn, before unfolding \[m²\].
    pub drawn_area_m2: f64,
    /// True if half of it was drawn and it was unfolded about its mirror line.
    #[serde(default)]
    pub unfolded: bool,
    /// Id of the source of a mirrored copy. The outline of a copy is that of its source reflected x
    /// -> -x with the same numbers, so that it runs counter-clockwise in coordinates and its holes
    /// clockwise.
    #[serde(default)]
    pub copy_of: Option<String>,
    /// Number that is cut, where the file gives it.
    #[serde(default)]
    pub quantity: Option<Quantity>,
    /// Corners of the outline, clockwise.
    pub corners: Vec<Corner>,
    /// Stretches between corners: as many as corners.
    pub edges: Vec<Edge>,
    /// Outlines inside the outline whose inside is not cloth.
    #[serde(default)]
    pub holes: Vec<Hole>,
    /// Line along which it is cut, where that differs from the outline (which is sewn).
    #[serde(default)]
    #[schema(value_type = Vec<[f64; 2]>)]
    pub cut_line: Vec<Point2>,
    /// Marks drilled through the cloth.
    #[serde(default)]
    #[schema(value_type = Vec<[f64; 2]>)]
    pub drill_holes: Vec<Point2>,
    /// Alignment marks on the outline.
    #[serde(default)]
    pub notches: Vec<Notch>,
    /// Direction of the warp; `None` where the file does not give it (then warp is +y).
    #[serde(default)]
    pub grain: Option<Grain>,
    /// Lines drawn inside that are not cut.
    #[serde(default)]
    #[schema(value_type = Vec<Vec<[f64; 2]>>)]
    pub internal_lines: Vec<Vec<Point2>>,
}

/// Side of a panel's cloth that is out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Face {
    /// The side that the drawing shows.
    Up,
    /// The other one.
    Down,
}

impl Face {
    /// Returns the other side.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Up => Self::Down,
            Self::Down => Self::Up,
        }
    }
}

/// Point at which an outline turns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Corner {
    /// Position in the panel's list of corners.
    pub index: usize,
    /// \[m\]
    pub x: f64,
    /// \[m\]
    pub y: f64,
}

/// A stretch of outline between two corners: what a user picks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Edge {
    /// Position in the panel's list of edges.
    pub index: usize,
    /// Index of the corner it leaves, clockwise.
    pub from: usize,
    /// Index of the corner it reaches.
    pub to: usize,
    /// Arc length \[m\].
    pub length_m: f64,
    /// Its polyline, both corners included, at least two points \[m\].
    #[schema(value_type = Vec<[f64; 2]>)]
    pub points: Vec<Point2>,
    /// Name, where the file gives it (`GarmentCode`: `left_armhole`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
}

/// An outline inside a panel whose inside is not cloth, stored counter-clockwise so that cloth lies
/// to the right of every edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Hole {
    /// Its corners.
    pub corners: Vec<Corner>,
    /// The stretches between its corners.
    pub edges: Vec<Edge>,
}

/// An alignment mark on an edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Notch {
    /// Position in the panel's list of notches.
    pub index: usize,
    /// The edge it lies on.
    pub edge: usize,
    /// Fraction of that edge's arc length, clockwise.
    pub at: f64,
    /// Its shape.
    pub kind: NotchKind,
    /// Depth to which it is cut, where the file gives it \[m\].
    #[serde(default)]
    pub depth_m: Option<f64>,
}

/// Shape of a notch, after the layers of ASTM D6673.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum NotchKind {
    /// Layer 4.
    V,
    /// Layer 80.
    T,
    /// Layer 81.
    Castle,
    /// Layer 82.
    Check,
    /// Layer 83.
    U,
    /// A plain slit, or a mark of unknown shape.
    Slit,
}

/// Direction of the warp on a panel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Grain {
    /// Counter-clockwise from +x, in [0, 180) \[degrees\].
    pub angle_deg: f64,
}

/// Number of a panel that is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Quantity {
    /// As drawn.
    pub left: u32,
    /// Mirrored.
    pub right: u32,
}

#[cfg(test)]
impl Panel {
    /// A rectangle of this width and height \[m\], its lower left corner at the origin.
    pub(crate) fn rectangle(id: &str, [width, height]: [f64; 2]) -> Self {
        let corners = [[0.0, 0.0], [0.0, height], [width, height], [width, 0.0]];
        Self::polygon(id, &corners)
    }

    /// A panel with these corners \[m\], clockwise, and straight edges.
    pub(crate) fn polygon(id: &str, points: &[Point2]) -> Self {
        let count = points.len();
        let next = |index: usize| (index + 1) % count;
        let edge = |index: usize| {
            let [p, q] = [points[index], points[next(index)]];
            Edge {
                index,
                from: index,
                to: next(index),
                length_m: (q[0] - p[0]).hypot(q[1] - p[1]),
                points: vec![p, q],
                label: None,
            }
        };
        let edges: Vec<_> = (0..count).map(edge).collect();
        let corner = |(index, &[x, y]): (usize, &Point2)| Corner { index, x, y };
        let twice = |edge: &Edge| {
            let [p, q] = [edge.points[0], edge.points[1]];
            q[0] * p[1] - p[0] * q[1]
        };
        let area = 0.5 * edges.iter().map(twice).sum::<f64>();
        Self {
            id: id.to_owned(),
            name: id.to_owned(),
            label: None,
            face: None,
            area_m2: area,
            perimeter_m: edges.iter().map(|edge| edge.length_m).sum(),
            drawn_area_m2: area,
            unfolded: false,
            copy_of: None,
            quantity: None,
            corners: points.iter().enumerate().map(corner).collect(),
            edges,
            holes: vec![],
            cut_line: vec![],
            drill_holes: vec![],
            notches: vec![],
            grain: None,
            internal_lines: vec![],
        }
    }
}
