//! Templates of panels: the cycle of edge roles round each kind, with usual lengths, bends and
//! corners.

use super::labels::EdgeRole;
use serde::Deserialize;

/// Usual features of an edge of one role, each as mean and spread.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EdgeTemplate {
    pub(super) role: EdgeRole,
    /// Natural logarithm of its length over the size of the panel.
    pub(super) length: [f64; 2],
    /// Turn along it, positive where the outline is convex \[degrees\].
    pub(super) bend: [f64; 2],
    /// Turn from it to the next role, likewise \[degrees\].
    pub(super) corner: [f64; 2],
}

/// Cycle of edge roles round a panel, in clockwise order where it lies hem down.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PanelTemplate {
    /// True for a panel of one side of the body, which then has its side on the left.
    pub(super) half: bool,
    /// Misfit that any alignment with it has: templates to be taken only where no usual one fits.
    pub(super) rarity: f64,
    pub(super) edges: Vec<EdgeTemplate>,
}
