//! Panels rolled about the body are turned so that their stitches are short: a band that is drawn
//! upright is laid round, a sleeve has its cap at the shoulder, or further down the arm where the
//! shoulder is dropped, a collar its ends where the neck opens.

use super::Placed;
use super::anchored::{bounds, nearly_closed};
use super::half_legs;
use super::lifted;
use super::on_limb;
use super::panel_placement::{
    OwnStitch, PanelPlacement, SeamPoint, own_stitches, shortest_turn, thinned,
};
use crate::pattern::Panel;
use crate::scene::Avatar;
use nalgebra::{Vector2, Vector3};
use std::cmp::Reverse;

/// Share of the sum of squares that another pose must save to be taken: where a panel fits alike
/// in several, it stays as it was placed.
const SAVED: f64 = 0.1;

/// Share of a panel's width that two sides of it are apart by which close it: more than those of a
/// dart.
const ACROSS: f64 = 0.5;

/// Places `panels` on `avatar`, or in free space without one.
///
/// Flat panels are put where they are anchored, those that a file puts about a limb are rolled
/// about it, those of the trunk are lifted above what their seams would close through, and halves
/// of legs are rolled about the legs. Those that are rolled all round follow, each turned about its
/// axis, and by quarters on the drawing where the placement does not say which way is up, so that
/// its `stitches` to the panels before it and to itself are short.
pub fn place_panels(
    panels: &[PanelPlacement<'_>],
    stitches: &[[SeamPoint; 2]],
    avatar: Option<&Avatar>,
) -> Vec<Placed> {
    let of_panel = own_stitches(panels.len(), stitches);
    let place = |index: usize| {
        let panel = &panels[index];
        let placed = panel.placement.place(panel.panel, panel.face, avatar);
        panel.placement.coned(
            placed,
            panel.panel,
            &to_itself(index, &of_panel[index]),
            avatar,
        )
    };
    let mut placed: Vec<Placed> = (0..panels.len()).map(place).collect();
    if let Some(avatar) = avatar {
        on_limb::roll(&mut placed, panels, &of_panel, avatar);
        let legs = lifted::lift(&mut placed, panels, &of_panel, avatar);
        half_legs::roll(&mut placed, panels, &of_panel, &legs, avatar);
    }
    let mut is_settled: Vec<bool> = panels
        .iter()
        .map(|panel| !panel.placement.turns())
        .collect();
    while let Some(panel) = most_joined(&of_panel, &is_settled) {
        let is_known = |[_, other]: &&OwnStitch| other.panel == panel || is_settled[other.panel];
        let known = of_panel[panel].iter().filter(is_known).copied().collect();
        let seams = Seams {
            stitches: thinned(known).collect(),
            to_itself: to_itself(panel, &of_panel[panel]),
            placed: &placed,
            index: panel,
        };
        placed[panel] = turned(&panels[panel], &seams, avatar);
        is_settled[panel] = true;
    }
    placed
}

/// Returns the panel that has the most stitches to settled ones, of those that are not: a short
/// seam tells little of how a panel lies.
fn most_joined(of_panel: &[Vec<OwnStitch>], is_settled: &[bool]) -> Option<usize> {
    let joins = |panel: usize| {
        let known = of_panel[panel].iter();
        known.filter(|[_, other]| is_settled[other.panel]).count()
    };
    let open = (0..of_panel.len()).filter(|&panel| !is_settled[panel]);
    let (count, panel) = open
        .map(|panel| (joins(panel), panel))
        .max_by_key(|&(count, panel)| (count, Reverse(panel)))?;
    (count > 0).then_some(panel)
}

/// Returns the stitches of a panel to itself, as pairs of points of its drawing \[m\].
fn to_itself(panel: usize, stitches: &[OwnStitch]) -> Vec<[[f64; 2]; 2]> {
    let own = stitches.iter().filter(|[_, other]| other.panel == panel);
    own.map(|pair| pair.map(|p| p.uv)).collect()
}

/// Returns the pose of `panel` in which its stitches are shortest, moved to what it is sewn to.
fn turned(panel: &PanelPlacement<'_>, seams: &Seams<'_>, avatar: Option<&Avatar>) -> Placed {
    let moved = |pose: Placed| {
        let ways = seams.ways(&pose);
        let placement = panel.placement;
        let moved = if pose.is_about_limb() {
            placement.moved_down_the_arm(pose, panel.panel, &ways, avatar)
        } else {
            placement.moved_down_the_trunk(pose, panel.panel, &ways, avatar)
        };
        seams.closed(moved, panel.panel)
    };
    let cost = |pose: &Placed, from: &Placed| {
        if pose.is_below(from) && seams.lies_over_the_others(pose) {
            f64::INFINITY
        } else {
            seams.cost(pose)
        }
    };
    let drawn = &seams.placed[seams.index];
    let mut best = moved(drawn.clone());
    let mut least = (1.0 - SAVED) * cost(&best, drawn);
    for placement in panel.placement.quarter_turns() {
        let upright = placement.place(panel.panel, panel.face, avatar);
        let turned = |pose: &Placed, angle: f64| Placed {
            outward: pose.outward + angle,
            ..pose.clone()
        };
        // Beside what it is sewn to, as a bent arm leads there.
        let beside = moved(upright.clone());
        let turn = shortest_turn(|angle| seams.cost(&turned(&beside, angle)));
        let pose = moved(turned(&upright, turn));
        let cost = cost(&pose, &upright);
        if cost < least {
            (best, least) = (pose, cost);
        }
    }
    best
}

/// The stitches of a panel to others that are placed, and to itself.
struct Seams<'a> {
    /// Some of those to panels that are settled and to itself.
    stitches: Vec<OwnStitch>,
    /// All of those to itself, as pairs of points of the drawing \[m\].
    to_itself: Vec<[[f64; 2]; 2]>,
    placed: &'a [Placed],
    index: usize,
}

impl Seams<'_> {
    /// Returns the sum of the squares of the stitches' lengths in a pose of the panel \[m²\].
    fn cost(&self, pose: &Placed) -> f64 {
        let length = |[own, other]: &OwnStitch| {
            let at = if other.panel == self.index {
                pose
            } else {
                &self.placed[other.panel]
            };
            (pose.position(own.uv) - at.position(other.uv)).norm_squared()
        };
        self.stitches.iter().map(length).sum()
    }

    fn to_others(&self) -> impl Iterator<Item = &OwnStitch> {
        let stitches = self.stitches.iter();
        stitches.filter(|[_, other]| other.panel != self.index)
    }

    /// Returns the ways from the panel to the others that it is sewn to \[m\].
    fn ways(&self, pose: &Placed) -> Vec<Vector3<f64>> {
        let way = |[own, other]: &OwnStitch| {
            self.placed[other.panel].position(other.uv) - pose.position(own.uv)
        };
        self.to_others().map(way).collect()
    }

    /// Returns the same pose so much wider that it is nearly closed, if the panel is sewn to itself
    /// across, round what it is rolled about: a tight one that starts open would be drawn together
    /// through that.
    fn closed(&self, pose: Placed, panel: &Panel) -> Placed {
        let [[left, right], _] = bounds(panel, &pose.up);
        let width = right - left;
        let is_across = |[a, b]: &[[f64; 2]; 2]| {
            let way = pose.up * (Vector2::from(*b) - Vector2::from(*a));
            way.x.abs() > ACROSS * width
        };
        if !self.to_itself.iter().any(is_across) {
            return pose;
        }
        let spread = nearly_closed(width, pose.radius);
        Placed { spread, ..pose }
    }

    /// Returns true if the panel lies over what it is sewn to: at a hem it hangs down from its
    /// seams, at the top of trousers it stands up.
    fn lies_over_the_others(&self, pose: &Placed) -> bool {
        let over = |[own, other]: &OwnStitch| {
            let own = pose.middle().y - pose.position(own.uv).y;
            let at = &self.placed[other.panel];
            own * (at.middle().y - at.position(other.uv).y)
        };
        self.to_others().map(over).sum::<f64>() > 0.0
    }
}
