//! What a pattern is to the trade: a style and its pieces.

use super::curve::Point;

/// A style: all pieces of one garment.
pub(crate) struct Style {
    pub(crate) name: &'static str,
    pub(crate) pieces: Vec<Piece>,
}

/// One piece, drawn face up without seam allowance.
pub(crate) struct Piece {
    pub(crate) name: &'static str,
    /// The outline, clockwise: one run from turn point to turn point, each beginning where the last ended.
    pub(crate) runs: Vec<Vec<Point>>,
    /// Alignment marks: vertices of the outline.
    pub(crate) notches: Vec<Point>,
    /// Both ends of the grain line.
    pub(crate) grain: [Point; 2],
    /// Where its origin lies on the sheet.
    pub(crate) origin: Point,
}
