//! A panel with the place that it is to start at, and points of its seams.

use super::AnchoredPlacement;
use crate::pattern::Panel;
use crate::seam::Face;

/// A panel and where it is to start.
#[derive(Clone, Copy, Debug)]
pub struct PanelPlacement<'a> {
    /// The panel.
    pub panel: &'a Panel,
    /// The key point of the body that it starts at.
    pub placement: &'a AnchoredPlacement,
    /// The side that is out.
    pub face: Face,
}

/// A point of a panel's seam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeamPoint {
    /// Index of the panel.
    pub panel: usize,
    /// Point on its drawing \[m\].
    pub uv: [f64; 2],
}
