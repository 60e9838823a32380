//! Cuffs of trousers, rolled about the ends of the legs.
//!
//! A cuff that is closed on itself has a place before a leg, flat. There it closes beside the ankle
//! or through it; rolled, and nearly closed however tight, it is round the leg from the start.

use super::anchored::{bounds, nearly_closed, outline};
use super::limb_pose::LimbPose;
use super::panel_placement::{OwnStitch, PanelPlacement, shortest_turn, thinned};
use super::placed::Placed;
use crate::pattern::{Panel, Wrap};
use crate::scene::{Avatar, Limb};
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A cuff of a leg.
pub(super) struct LegCuff {
    panel: usize,
    /// Turns the drawing so that the edge that is sewn to the leg is up.
    up: Rotation2<f64>,
    /// How far it reaches to the sides, and down and up, on the turned drawing \[m\].
    sides: [f64; 2],
    ends: [f64; 2],
    /// Its stitches to the leg.
    stitches: Vec<OwnStitch>,
}

impl LegCuff {
    /// Returns the cuffs among `panels` that are sewn to some of `legs`, and to nothing else but
    /// themselves.
    pub(super) fn all(
        placed: &[Placed],
        panels: &[PanelPlacement<'_>],
        of_panel: &[Vec<OwnStitch>],
        legs: &BTreeSet<usize>,
    ) -> Vec<Self> {
        let is_cuff = |&panel: &usize| {
            let others = || of_panel[panel].iter().map(|[_, other]| other.panel);
            let is_flat = placed[panel].wrap == Wrap::Flat
                && placed[panel].rotation == Rotation3::identity()
                && !placed[panel].is_about_limb();
            is_flat
                && panels[panel].placement.may_be_rolled()
                && !legs.contains(&panel)
                && others().any(|other| other == panel)
                && others().any(|other| legs.contains(&other))
                && others().all(|other| other == panel || legs.contains(&other))
        };
        let panels = (0..panels.len()).filter(is_cuff).map(|panel| {
            let to_leg = of_panel[panel]
                .iter()
                .filter(|[_, other]| other.panel != panel);
            let stitches = thinned(to_leg.copied().collect()).collect();
            Self::of(panel, panels[panel].panel, stitches)
        });
        panels.collect()
    }

    fn of(panel: usize, drawn: &Panel, stitches: Vec<OwnStitch>) -> Self {
        let mean = |points: &mut dyn Iterator<Item = [f64; 2]>| {
            let (sum, count) = points.fold((Vector2::zeros(), 0.0), |(sum, count), p| {
                (sum + Vector2::from(p), count + 1.0)
            });
            sum / count
        };
        let sewn = mean(&mut stitches.iter().map(|[own, _]| own.uv));
        let middle = mean(&mut outline(drawn));
        let quarters = ((sewn - middle).y.atan2((sewn - middle).x) / FRAC_PI_2).round();
        let up = Rotation2::new((1.0 - quarters) * FRAC_PI_2);
        let [sides, ends] = bounds(drawn, &up);
        Self {
            panel,
            up,
            sides,
            ends,
            stitches,
        }
    }

    /// Returns true if it is sewn to one of these panels.
    pub(super) fn is_sewn_to(&self, panels: [usize; 2]) -> bool {
        self.stitches
            .iter()
            .any(|[_, leg]| panels.contains(&leg.panel))
    }

    /// Its height as it is worn \[m\].
    pub(super) fn height(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// Rolls the cuff about the leg, whose panels have their starts.
    pub(super) fn roll(&self, placed: &mut [Placed], limb: Limb, avatar: &Avatar) {
        let hem = self
            .stitches
            .iter()
            .map(|[_, leg]| placed[leg.panel].position(leg.uv));
        let center = hem.sum::<Vector3<f64>>() / self.stitches.len() as f64;
        let Some(pose) = LimbPose::beside(avatar, limb, &center, self.height()) else {
            return;
        };
        let width = self.sides[1] - self.sides[0];
        let radius = pose.radius.max(width / TAU);
        let flat = &placed[self.panel];
        let rolled = |outward: f64| Placed {
            up: self.up,
            key: [0.5 * (self.sides[0] + self.sides[1]), self.ends[1]],
            center_y: 0.5 * (self.ends[0] + self.ends[1]),
            outward,
            axis: pose.top,
            radius,
            wrap: Wrap::Cylinder,
            spread: nearly_closed(width, radius),
            tilt: Some(pose.tilt()),
            offset: Vector3::zeros(),
            ..flat.clone()
        };
        let cost = |outward: f64| -> f64 {
            let start = rolled(outward);
            let length = |[own, leg]: &OwnStitch| {
                (start.position(own.uv) - placed[leg.panel].position(leg.uv)).norm_squared()
            };
            self.stitches.iter().map(length).sum()
        };
        placed[self.panel] = rolled(shortest_turn(cost));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Placement, PlacementAnchor};
    use crate::scene::placement::test_body::body;
    use crate::scene::placement::{AnchoredPlacement, SeamPoint, place_panels};
    use crate::seam::Face;
    use std::f64::consts::PI;

    const LENGTH: f64 = 0.9;
    const CROTCH: f64 = 0.62;

    /// Half a leg whose outside is on the left of the drawing, 16 cm wide at the hem.
    fn half() -> Panel {
        let corners = [
            [0.03, 0.0],
            [0.0, CROTCH],
            [0.01, LENGTH],
            [0.22, LENGTH],
            [0.3, CROTCH],
            [0.19, 0.0],
        ];
        Panel::polygon("half", &corners)
    }

    /// A cuff of 20 cm, tighter than the ankle with its room, at the hem of 32 cm of the left leg,
    /// sewn by the upper or the lower edge of its drawing.
    #[test]
    fn a_cuff_is_closed_round_the_leg_above_the_foot() {
        let avatar = body();
        let ankle = avatar.landmarks["ankle_l"].y;
        let panels = [half(), half(), Panel::rectangle("cuff", [0.2, 0.06])];
        let at = [
            (PlacementAnchor::SkirtFront, 0.15, 0.0),
            (PlacementAnchor::SkirtBack, 0.15, 0.0),
            (PlacementAnchor::SkirtFront, 0.1, -LENGTH),
        ];
        let placements = at.map(|(at, x, y)| {
            let placement = Placement {
                at: Some(at),
                offset_m: [x, y, 0.0],
                ..Placement::default()
            };
            AnchoredPlacement::new(&panels[0], Some(&placement)).expect("a place")
        });
        let faces = [Face::Down, Face::Up, Face::Up];
        let placed = [0, 1, 2].map(|k| PanelPlacement {
            panel: &panels[k],
            placement: &placements[k],
            face: faces[k],
        });
        let point = |panel, uv| SeamPoint { panel, uv };
        for sewn in [0.06, 0.0] {
            // Upside down it runs the other way round.
            let along = |x: f64| if sewn > 0.0 { x } else { 0.2 - x };
            let shares = (0..=10).map(|k| 0.1 * f64::from(k));
            let stitches = shares.flat_map(|share| {
                let inseam = [0, 1].map(|half| point(half, [0.19 + 0.11 * share, CROTCH * share]));
                let [front, back] = [0, 1].map(|half| point(half, [0.19 - 0.16 * share, 0.0]));
                // From the inside over the front and back again behind.
                let to_front = [front, point(2, [along(0.1 * share), sewn])];
                let to_back = [back, point(2, [along(0.2 - 0.1 * share), sewn])];
                let ends = [0.0, 0.2].map(|x| point(2, [x, 0.06 * share]));
                [inseam, to_front, to_back, ends]
            });
            let start = place_panels(&placed, &stitches.collect::<Vec<_>>(), Some(&avatar));
            let [front, _, cuff] = &start[..] else {
                panic!("three panels")
            };
            for k in 0..=20 {
                for v in [0.0, 0.03, 0.06] {
                    let p = cuff.position([0.01 * f64::from(k), v]);
                    assert!(avatar.exact_distance(&p) > 0.0 && p.y > ankle, "{sewn} {p}");
                }
            }
            let ends = [0.0, 0.2].map(|x| cuff.position([x, 0.03]));
            assert!((ends[0] - ends[1]).norm() < 0.02, "{ends:?}");
            let [hem, upper] = [
                front.position([0.11, 0.0]),
                cuff.position([along(0.05), sewn]),
            ];
            // Nearer than to the other side of the leg.
            assert!((hem - upper).norm() < 0.32 / PI, "{sewn} {hem} {upper}");
            assert!(cuff.position([0.1, sewn]).y > cuff.position([0.1, 0.06 - sewn]).y);
        }
    }
}
