//! Panels whose shoulder seams would close through the shoulders start so much higher that they
//! close above them, and what hangs from them goes along.
//!
//! A strap that starts below the top of the shoulder, or is pulled below it by a skirt that starts
//! far down, is drawn through it or off it to the side, and the garment ends round the waist.

use super::panel_placement::{PanelPlacement, SeamPoint};
use super::placed::Placed;
use crate::pattern::Wrap;
use crate::scene::Avatar;
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
/// Distance from the middle, and above the crotch, within which a seam from front to back goes
/// between the legs \[m\].
const BETWEEN_LEGS: f64 = 0.1;
/// Height of the hem of trousers above the ankles \[m\]: below, it would close through a foot.
const ABOVE_ANKLE: f64 = 0.02;

/// The flat panels about the trunk, and their stitches to each other.
struct Trunk<'a> {
    placed: &'a mut [Placed],
    stitches: Vec<[SeamPoint; 2]>,
}

/// Lifts the panels of the upper trunk until their stitches from front to back over the shoulders
/// are clear of the body, and those that hang from them as far as their seams are lower; legs of
/// trousers above the ankles, as far as the crotch has room.
pub(super) fn lift(
    placed: &mut [Placed],
    panels: &[PanelPlacement<'_>],
    stitches: &[[SeamPoint; 2]],
    avatar: &Avatar,
) {
    let landmark = |name| avatar.landmarks.get(name).copied();
    let (Some(tip), Some(waist)) = (landmark("shoulder_tip_l"), landmark("waist_front")) else {
        return;
    };
    let stitches = stitches.iter().copied();
    let of_trunk = stitches.filter(|pair| pair.iter().all(|p| is_about_trunk(&placed[p.panel])));
    let mut trunk = Trunk {
        stitches: of_trunk.collect(),
        placed,
    };
    let mut is_settled = vec![false; panels.len()];
    if let Some(height) = trunk.height_to_clear(&tip, avatar) {
        let heights: Vec<_> = panels.iter().zip(&*trunk.placed).map(heights).collect();
        for (panel, at) in trunk.placed.iter_mut().enumerate() {
            if is_about_trunk(at) && heights[panel][1] > 0.5 * (waist.y + tip.y) {
                at.offset.y += height;
                is_settled[panel] = true;
            }
        }
    }
    let legs = trunk.legs(panels, avatar);
    trunk.follow(&mut is_settled, &legs);
    trunk.clear_ankles(&mut is_settled, &legs);
}

/// Trousers: the panels that are sewn between the legs.
#[derive(Default)]
struct Legs {
    panels: BTreeSet<usize>,
    /// Way from where they are sewn to the crotch \[m\].
    room: f64,
    /// Way from their hems to the ankles \[m\].
    to_ankles: f64,
}

impl Trunk<'_> {
    fn ends(&self, stitch: &[SeamPoint; 2]) -> [Vector3<f64>; 2] {
        stitch.map(|p| self.placed[p.panel].position(p.uv))
    }

    /// Returns how much higher the stitches over the shoulders are clear of the body \[m\]; nothing
    /// where there are none.
    fn height_to_clear(&self, tip: &Vector3<f64>, avatar: &Avatar) -> Option<f64> {
        let is_of_shoulder = |[a, b]: &[Vector3<f64>; 2]| {
            let is_there =
                |p: &Vector3<f64>| p.y > tip.y - SHOULDER_DEPTH && p.x.abs() < tip.x.abs();
            is_there(a) && is_there(b) && (a.z - tip.z) * (b.z - tip.z) < 0.0
        };
        let ends = self.stitches.iter().map(|stitch| self.ends(stitch));
        let over: Vec<_> = ends.filter(is_of_shoulder).collect();
        let some = over.iter().step_by(over.len().div_ceil(STITCHES).max(1));
        some.filter_map(|stitch| height_to_clear(stitch, avatar))
            .reduce(f64::max)
    }

    /// Lifts the panels that are sewn to settled ones as far as their seams start lower, one after
    /// another; those of trousers all at once.
    fn follow(&mut self, is_settled: &mut [bool], legs: &Legs) {
        loop {
            let next = (0..is_settled.len()).find_map(|panel| {
                let gap = (!is_settled[panel]).then(|| self.gap(panel, is_settled))?;
                Some((panel, gap?))
            });
            let Some((panel, gap)) = next else {
                return;
            };
            if legs.panels.contains(&panel) {
                self.lift_legs(is_settled, legs, gap.max(legs.to_ankles));
            } else {
                self.placed[panel].offset.y += gap.max(0.0);
                is_settled[panel] = true;
            }
        }
    }

    /// Lifts the panels of trousers that hang from nothing.
    fn clear_ankles(&mut self, is_settled: &mut [bool], legs: &Legs) {
        if legs.panels.iter().all(|&panel| !is_settled[panel]) {
            self.lift_legs(is_settled, legs, legs.to_ankles);
        }
    }

    fn lift_legs(&mut self, is_settled: &mut [bool], legs: &Legs, height: f64) {
        for &panel in &legs.panels {
            self.placed[panel].offset.y += height.min(legs.room).max(0.0);
            is_settled[panel] = true;
        }
    }

    /// Returns how much lower the seams of a panel to settled ones start on its side \[m\], if it
    /// has any.
    fn gap(&self, panel: usize, is_settled: &[bool]) -> Option<f64> {
        let (mut sum, mut count) = (0.0, 0.0);
        for stitch in &self.stitches {
            let [a, b] = self.ends(stitch);
            let [from, to] = stitch.map(|p| p.panel);
            if from == panel && is_settled[to] {
                sum += b.y - a.y;
                count += 1.0;
            } else if to == panel && is_settled[from] {
                sum += a.y - b.y;
                count += 1.0;
            }
        }
        (count > 0.0).then(|| sum / count)
    }

    fn legs(&self, panels: &[PanelPlacement<'_>], avatar: &Avatar) -> Legs {
        let height = |name| avatar.landmarks.get(name).map(|p| p.y);
        let (Some(crotch), Some(ankle)) = (height("crotch"), height("ankle_l")) else {
            return Legs::default();
        };
        let is_low = |p: &Vector3<f64>| p.y < crotch + BETWEEN_LEGS && p.x.abs() < BETWEEN_LEGS;
        let mut legs = Legs {
            room: f64::INFINITY,
            ..Legs::default()
        };
        for stitch in &self.stitches {
            let ends = self.ends(stitch);
            if ends.iter().all(is_low) && ends[0].z * ends[1].z < 0.0 {
                legs.room = legs.room.min(crotch - ends[0].y.max(ends[1].y));
                legs.panels.extend(stitch.map(|p| p.panel));
            }
        }
        let lowest = legs
            .panels
            .iter()
            .map(|&panel| heights((&panels[panel], &self.placed[panel]))[0]);
        let hem = lowest.fold(f64::INFINITY, f64::min);
        legs.to_ankles = if hem < ankle + ABOVE_ANKLE {
            ankle + ABOVE_ANKLE - hem
        } else {
            0.0
        };
        legs
    }
}

fn is_about_trunk(at: &Placed) -> bool {
    at.tilt.is_none() && at.wrap == Wrap::Flat
}

/// Returns the heights of the lowest and the highest point of a panel \[m\].
fn heights((panel, at): (&PanelPlacement<'_>, &Placed)) -> [f64; 2] {
    let points = panel.panel.edges.iter().flat_map(|edge| &edge.points);
    let heights = points.map(|uv| at.position(*uv).y);
    heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], y| {
        [least.min(y), most.max(y)]
    })
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
    use crate::scene::placement::{AnchoredPlacement, place_panels};
    use crate::scene::{DressForm, Limbs};
    use crate::seam::Face;

    fn body() -> Avatar {
        let limbs = Some(Limbs {
            arms: true,
            legs: true,
        });
        let form = DressForm {
            limbs,
            ..DressForm::default()
        };
        form.build().expect("a body")
    }

    /// Places rectangles of these sizes with their middles at these points.
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
            (panel, placed)
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

    /// Half a trouser leg before the left leg and half behind it, sewn between the legs from 15 cm
    /// below the crotch on, whose hem starts 3 cm below the ankle.
    #[test]
    fn trousers_start_above_the_ankles_and_below_the_crotch() {
        let avatar = body();
        let [crotch, ankle] = ["crotch", "ankle_l"].map(|name| avatar.landmarks[name].y);
        let hem = ankle - 0.03;
        for (below, rises) in [(0.15, 0.03 + ABOVE_ANKLE), (0.02, 0.02)] {
            let high = crotch - below - hem;
            let size = [0.3, high];
            let at = |z: f64| (size, [0.17, hem + 0.5 * high, z]);
            let inner = [[0.0, 0.0], [0.0, high]];
            let stitches = row([0, 1], inner, inner);
            let placed = place(&[at(0.25), at(-0.25)], &stitches, &avatar);
            for at in placed {
                let rise = at.position([0.0, 0.0]).y - hem;
                assert!((rise - rises).abs() < 1e-9, "{rise}");
            }
        }
    }
}
