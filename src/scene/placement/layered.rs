//! Starts outside of other cloth: of a garment worn beneath, and of lower layers.

use super::anchored::{CLEARANCE, outline};
use super::placed::Placed;
use crate::pattern::{Panel, Wrap};
use nalgebra::Vector3;

/// Room left between the layers of a garment at the start \[m\].
const LAYER_CLEARANCE: f64 = 0.01;

impl Placed {
    /// The same, further from the axis where `cloth` \[m\] at the panel's height reaches beyond its
    /// start; as it is at an arm, in a free place, or without cloth. Cloth further than `trunk`
    /// \[m\] from the middle is about the arms.
    #[must_use]
    pub fn outside(self, panel: &Panel, cloth: &[Vector3<f64>], trunk: f64) -> Self {
        let [low, high] = self.heights(panel);
        let is_beside = |p: &&Vector3<f64>| (low..=high).contains(&p.y) && p.x.abs() <= trunk;
        let beside = cloth.iter().filter(is_beside);
        let most = beside.map(|p| self.reach(p)).fold(0.0, f64::max);
        self.beyond(most, CLEARANCE)
    }

    /// The same, further from the axis where panels of lower layers start beside it, without the
    /// offsets that the garment states; as it is at an arm or in a free place.
    #[must_use]
    pub fn above<'a>(
        self,
        panel: &Panel,
        lower: impl Iterator<Item = (&'a Panel, &'a Self)>,
    ) -> Self {
        if self.wrap == Wrap::Level {
            return self.over_level(lower);
        }
        let [low, high] = self.heights(panel);
        let beside = lower.filter(|(panel, placed)| {
            let [lowest, highest] = placed.heights(panel);
            placed.tilt.is_none() && lowest <= high && low <= highest
        });
        let points = beside.flat_map(|(panel, placed)| {
            outline(panel).map(|uv| placed.position(uv) - placed.offset)
        });
        let most = points.map(|p| self.reach(&p)).fold(0.0, f64::max);
        self.beyond(most, LAYER_CLEARANCE)
    }

    /// Puts a level panel above the level ones beneath it.
    fn over_level<'a>(mut self, lower: impl Iterator<Item = (&'a Panel, &'a Self)>) -> Self {
        let level = lower.filter(|(_, placed)| placed.wrap == Wrap::Level);
        for (panel, placed) in level {
            let [_, top] = placed.heights(panel);
            let least = top - self.offset.y + LAYER_CLEARANCE;
            self.axis.y = self.axis.y.max(least);
        }
        self
    }

    /// Puts the panel `clearance` beyond what reaches so far from the axis, if anything does \[m\].
    fn beyond(mut self, reach: f64, clearance: f64) -> Self {
        if reach > 0.0 && self.tilt.is_none() && self.radius > 0.0 {
            self.radius = self.radius.max(reach + clearance);
        }
        self
    }

    /// Lowest and highest point of the start of `panel` \[m\].
    fn heights(&self, panel: &Panel) -> [f64; 2] {
        let heights = outline(panel).map(|uv| self.position(uv).y);
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
            [low.min(y), high.max(y)]
        })
    }

    /// Distance of a point from the axis, to the front or back where the panel is flat \[m\].
    fn reach(&self, p: &Vector3<f64>) -> f64 {
        let [x, z] = [p.x - self.axis.x, p.z - self.axis.z];
        match self.wrap {
            Wrap::Flat => z * self.outward.cos(),
            Wrap::Cylinder | Wrap::Level => x.hypot(z),
        }
    }
}
