//! Panels whose shoulder seams would close through the shoulders start so much higher that they
//! close above them, and what hangs from them goes along.
//!
//! A strap that starts below the top of the shoulder, or is pulled below it by a skirt that starts
//! far down, is drawn through it or off it to the side, and the garment ends round the waist.

use super::anchored::outline;
use super::leg_line::ABOVE_ANKLE;
use super::panel_placement::{OwnStitch, PanelPlacement, thinned};
use super::placed::Placed;
use crate::pattern::Wrap;
use crate::scene::Avatar;
use crate::scene::crotch::is_between_legs;
use nalgebra::Vector3;
use std::collections::BTreeSet;

/// Depth below the tip of the shoulder within which a seam is one of the shoulder \[m\]: most of
/// the way to the armpit of a body of middle size.
const SHOULDER_DEPTH: f64 = 0.1;
/// Distance from the body that a stitch has all along \[m\], once it is high enough.
const CLEAR: f64 = 0.01;
/// Steps in height \[m\], and their number: what is lower still starts elsewhere for a reason.
const STEP: f64 = 0.005;
const STEPS: u32 = 40;
/// Points at which a stitch is looked at, and stitches that are looked at, at most.
const POINTS: u32 = 24;
const STITCHES: usize = 500;

/// Lifts the panels of the upper trunk until their stitches from front to back over the shoulders
/// are clear of the body, and those that hang from them as far as their seams are lower; legs of
/// trousers above the ankles, as far as the crotch has room. What the garment puts somewhere in
/// space stays there. Returns the panels of such legs.
pub(super) fn lift(
    placed: &mut [Placed],
    panels: &[PanelPlacement<'_>],
    of_panel: &[Vec<OwnStitch>],
    avatar: &Avatar,
) -> BTreeSet<usize> {
    let landmark = |name| avatar.landmarks.get(name).copied();
    let (Some(tip), Some(waist)) = (landmark("shoulder_tip_l"), landmark("waist_front")) else {
        return BTreeSet::new();
    };
    let is_hung = |(panel, at): (&PanelPlacement<'_>, &Placed)| {
        !panel.placement.is_fixed() && !at.is_about_limb() && at.wrap == Wrap::Flat
    };
    let mut trunk = Trunk {
        is_hung: panels.iter().zip(&*placed).map(is_hung).collect(),
        is_settled: vec![false; panels.len()],
        placed,
        panels,
        of_panel,
    };
    if let Some(height) = trunk.height_to_clear(&tip, avatar) {
        trunk.lift_upper(height, 0.5 * (waist.y + tip.y));
    }
    let legs = trunk.legs(avatar);
    trunk.follow(&legs);
    trunk.clear_ankles(&legs);
    legs.panels
}

/// The panels about the trunk.
struct Trunk<'a> {
    placed: &'a mut [Placed],
    panels: &'a [PanelPlacement<'a>],
    of_panel: &'a [Vec<OwnStitch>],
    /// True for flat ones before or behind it, which may be lifted.
    is_hung: Vec<bool>,
    /// True for those that are as high as they start.
    is_settled: Vec<bool>,
}

/// Trousers: the panels that are sewn between the legs.
#[derive(Default)]
struct Legs {
    panels: BTreeSet<usize>,
    /// Way from where they are sewn to the crotch \[m\].
    room: f64,
    /// Way from their hems to where those start \[m\]; 0 or less if they are above.
    to_ankles: f64,
}

impl Trunk<'_> {
    fn ends(&self, stitch: &OwnStitch) -> [Vector3<f64>; 2] {
        stitch.map(|p| self.placed[p.panel].position(p.uv))
    }

    /// The stitches between panels that may be lifted, those of two panels from both sides.
    fn stitches(&self) -> impl Iterator<Item = &OwnStitch> {
        let all = self.of_panel.iter().flatten();
        all.filter(|pair| pair.iter().all(|p| self.is_hung[p.panel]))
    }

    /// Returns the heights of the lowest and the highest point of a panel \[m\].
    fn heights(&self, panel: usize) -> [f64; 2] {
        let at = &self.placed[panel];
        let heights = outline(self.panels[panel].panel).map(|uv| at.position(uv).y);
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], y| {
            [least.min(y), most.max(y)]
        })
    }

    /// Returns how much higher the stitches over the shoulders are clear of the body \[m\]; nothing
    /// where there are none.
    fn height_to_clear(&self, tip: &Vector3<f64>, avatar: &Avatar) -> Option<f64> {
        let is_of_shoulder = |[a, b]: &[Vector3<f64>; 2]| {
            let is_there =
                |p: &Vector3<f64>| p.y > tip.y - SHOULDER_DEPTH && p.x.abs() < tip.x.abs();
            is_there(a) && is_there(b) && (a.z - tip.z) * (b.z - tip.z) < 0.0
        };
        let ends = self.stitches().map(|stitch| self.ends(stitch));
        let over: Vec<_> = ends.filter(is_of_shoulder).collect();
        let some = over.iter().step_by(over.len().div_ceil(STITCHES).max(1));
        some.filter_map(|stitch| height_to_clear(stitch, avatar))
            .reduce(f64::max)
    }

    /// Lifts the panels that reach above a height.
    fn lift_upper(&mut self, by: f64, above: f64) {
        for panel in 0..self.placed.len() {
            if self.is_hung[panel] && self.heights(panel)[1] > above {
                self.settle(panel, by);
            }
        }
    }

    fn settle(&mut self, panel: usize, by: f64) {
        self.placed[panel].offset.y += by;
        self.is_settled[panel] = true;
    }

    /// Lifts the panels that are sewn to settled ones as far as their seams start lower, one after
    /// another; those of trousers all at once.
    fn follow(&mut self, legs: &Legs) {
        let next = |trunk: &Self| {
            (0..trunk.placed.len()).find_map(|panel| Some((panel, trunk.gap(panel)?)))
        };
        while let Some((panel, gap)) = next(self) {
            if legs.panels.contains(&panel) {
                self.lift_legs(legs, gap.max(legs.to_ankles));
            } else {
                self.settle(panel, gap.max(0.0));
            }
        }
    }

    /// Lifts the panels of trousers that hang from nothing.
    fn clear_ankles(&mut self, legs: &Legs) {
        if !legs.panels.iter().any(|&panel| self.is_settled[panel]) {
            self.lift_legs(legs, legs.to_ankles);
        }
    }

    fn lift_legs(&mut self, legs: &Legs, by: f64) {
        for &panel in &legs.panels {
            if !self.is_settled[panel] {
                self.settle(panel, by.min(legs.room).max(0.0));
            }
        }
    }

    /// Returns how much lower the seams of an unsettled panel to settled ones start on its side
    /// \[m\], if it has any.
    fn gap(&self, panel: usize) -> Option<f64> {
        if self.is_settled[panel] || !self.is_hung[panel] {
            return None;
        }
        let to_settled = |[_, other]: &&OwnStitch| self.is_settled[other.panel];
        let own = self.of_panel[panel].iter().filter(to_settled).copied();
        let gaps: Vec<f64> = thinned(own.collect())
            .map(|stitch| {
                let [a, b] = self.ends(&stitch);
                b.y - a.y
            })
            .collect();
        (!gaps.is_empty()).then(|| gaps.iter().sum::<f64>() / gaps.len() as f64)
    }

    fn legs(&self, avatar: &Avatar) -> Legs {
        let landmark = |name| avatar.landmarks.get(name);
        let (Some(crotch), Some(ankle)) = (landmark("crotch"), landmark("ankle_l")) else {
            return Legs::default();
        };
        let mut panels = BTreeSet::new();
        let mut room = f64::INFINITY;
        for stitch in self.stitches() {
            let ends = self.ends(stitch);
            if is_between_legs(&ends, crotch) {
                room = room.min(crotch.y - ends[0].y.max(ends[1].y));
                panels.extend(stitch.map(|p| p.panel));
            }
        }
        let lowest = panels.iter().map(|&panel| self.heights(panel)[0]);
        Legs {
            to_ankles: ankle.y + ABOVE_ANKLE - lowest.fold(f64::INFINITY, f64::min),
            room,
            panels,
        }
    }
}

/// Returns how much higher a stitch is clear of the body all along \[m\], if it is at all.
fn height_to_clear([a, b]: &[Vector3<f64>; 2], avatar: &Avatar) -> Option<f64> {
    let is_clear = |height: &f64| {
        (0..=POINTS).all(|k| {
            let share = f64::from(k) / f64::from(POINTS);
            let point = a.lerp(b, share) + Vector3::y() * *height;
            avatar.distance(&point) > CLEAR
        })
    };
    (0..=STEPS).map(|k| STEP * f64::from(k)).find(is_clear)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::placement::test_body::body;
    use crate::scene::placement::{AnchoredPlacement, SeamPoint, place_panels};
    use crate::seam::Face;

    /// Rectangles of these sizes that a file puts with their middles at these points.
    fn place(
        rectangles: &[([f64; 2], [f64; 3])],
        stitches: &[[SeamPoint; 2]],
        avatar: &Avatar,
    ) -> Vec<Placed> {
        let placement = |offset_m| Placement {
            at: Some(PlacementAnchor::Origin),
            offset_m,
            wrap: Some(Wrap::Flat),
            ..Placement::default()
        };
        let panels = rectangles.iter().map(|(size, at)| {
            let panel = Panel::rectangle("one", *size);
            let placed = AnchoredPlacement::new(&panel, Some(&placement(*at))).expect("a place");
            (panel, placed.of_file())
        });
        let panels: Vec<_> = panels.collect();
        let placements = panels.iter().map(|(panel, placement)| PanelPlacement {
            panel,
            placement,
            face: Face::Up,
        });
        let placements: Vec<_> = placements.collect();
        place_panels(&placements, stitches, Some(avatar))
    }

    /// Stitches between the tops, bottoms or sides of two panels.
    fn row(panels: [usize; 2], from: [[f64; 2]; 2], to: [[f64; 2]; 2]) -> Vec<[SeamPoint; 2]> {
        let point = |panel: usize, ends: [[f64; 2]; 2], share: f64| SeamPoint {
            panel: panels[panel],
            uv: [0, 1].map(|i| ends[0][i] + share * (ends[1][i] - ends[0][i])),
        };
        let shares = (0..=10).map(|k| 0.1 * f64::from(k));
        shares
            .map(|share| [point(0, from, share), point(1, to, share)])
            .collect()
    }

    /// A top whose shoulders start 5 cm below those of the body, with a skirt 10 cm below its hem.
    #[test]
    fn shoulder_seams_start_above_the_body_and_a_skirt_goes_along() {
        let avatar = body();
        let tip = avatar.landmarks["shoulder_tip_l"];
        let size = [0.3, 0.5];
        let low = tip.y - 0.05 - 0.25;
        let at = |y: f64, z: f64| (size, [0.0, y, tip.z + z]);
        let rectangles = [at(low, 0.25), at(low, -0.25), at(low - 0.6, 0.25)];
        let [bottom, top] = [0.0, 0.5].map(|v| [[0.02, v], [0.28, v]]);
        let mut stitches = row([0, 1], top, top);
        stitches.extend(row([0, 2], bottom, top));
        let placed = place(&rectangles, &stitches, &avatar);
        for [a, b] in &stitches[..11] {
            let [a, b] = [a, b].map(|p| placed[p.panel].position(p.uv));
            for k in 0..=100 {
                let point = a.lerp(&b, 0.01 * f64::from(k));
                // Between two places that were looked at it may be nearer by half their distance.
                assert!(
                    avatar.distance(&point) > CLEAR - 0.25 / f64::from(POINTS),
                    "{point}"
                );
            }
        }
        for [a, b] in &stitches[11..] {
            let [a, b] = [a, b].map(|p| placed[p.panel].position(p.uv));
            assert!((a - b).norm() < 1e-9, "{a} {b}");
        }
    }

    /// Trousers of two panels before the left leg and one behind it, 20 cm higher than the crotch,
    /// sewn between the legs as far as some way below it, whose hem starts 3 cm below the ankle.
    #[test]
    fn trousers_start_above_the_ankles_and_below_the_crotch() {
        let avatar = body();
        let [crotch, ankle] = ["crotch", "ankle_l"].map(|name| avatar.landmarks[name].y);
        let hem = ankle - 0.03;
        for (below, rises) in [(0.15, 0.03 + ABOVE_ANKLE), (0.02, 0.02)] {
            let size = [0.3, crotch + 0.2 - hem];
            let at = |z: f64| (size, [0.17, hem + 0.5 * size[1], z]);
            let inner = [[0.0, 0.0], [0.0, crotch - below - hem]];
            let mut stitches = row([0, 2], inner, inner);
            stitches.extend(row([1, 2], inner, inner));
            let placed = place(&[at(0.25), at(0.25), at(-0.25)], &stitches, &avatar);
            for at in placed {
                let rise = at.position([0.0, 0.0]).y - hem;
                assert!((rise - rises).abs() < 1e-9, "{rise}");
            }
        }
    }
}
