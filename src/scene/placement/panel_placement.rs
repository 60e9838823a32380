//! A panel with the place that it is to start at, and its stitches to others.

use super::AnchoredPlacement;
use crate::pattern::Panel;
use crate::seam::Face;
use std::f64::consts::{FRAC_PI_2, PI};

/// Stitches of a panel that are looked at at most.
const STITCHES: usize = 100;

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

/// A stitch of a panel: its point, and the point it is sewn to.
pub(super) type OwnStitch = [SeamPoint; 2];

/// Returns the stitches of each of `count` panels, its own point first.
pub(super) fn own_stitches(count: usize, stitches: &[[SeamPoint; 2]]) -> Vec<Vec<OwnStitch>> {
    let mut of_panel = vec![vec![]; count];
    for &[a, b] in stitches {
        of_panel[a.panel].push([a, b]);
        if a.panel != b.panel {
            of_panel[b.panel].push([b, a]);
        }
    }
    of_panel
}

/// Returns some of the stitches, evenly spread.
pub(super) fn thinned(stitches: Vec<OwnStitch>) -> impl Iterator<Item = OwnStitch> {
    let step = stitches.len().div_ceil(STITCHES).max(1);
    stitches.into_iter().step_by(step)
}

/// Returns the turn about its axis \[rad\] in which the sum of the squares of a panel's stitches is
/// least: points run on circles, so that it is a constant and one wave of the angle.
pub(super) fn shortest_turn(sum_of_squares: impl Fn(f64) -> f64) -> f64 {
    let [ahead, aside, behind] = [0.0, FRAC_PI_2, PI].map(sum_of_squares);
    let mean = 0.5 * (ahead + behind);
    (mean - aside).atan2(mean - ahead)
}
