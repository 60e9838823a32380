//! The way of a panel from its drawing to its start in space.

use super::cone::Cone;
use super::taper::Taper;
use crate::pattern::Wrap;
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};

/// Furthest that a cuff starts below the shoulder \[m\]: the length of a long arm.
const MOST_DOWN: f64 = 0.8;

/// The way from pattern coordinates to the start position in space.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Turns the drawing so that up on the body is +y.
    pub(super) up: Rotation2<f64>,
    /// The key point and the middle of the height, in the turned drawing \[m\].
    pub(super) key: [f64; 2],
    pub(super) center_y: f64,
    /// +1 where the drawn +x runs along increasing angle, -1 where it runs against it.
    pub(super) sense: f64,
    /// Angle of the outward direction from +z towards +x \[rad\].
    pub(super) outward: f64,
    /// Point of the axis at the key point's height \[m\].
    pub(super) axis: Vector3<f64>,
    /// Distance from the axis \[m\].
    pub(super) radius: f64,
    pub(super) wrap: Wrap,
    /// Width that it starts with, over that on the drawing.
    pub(super) spread: f64,
    /// The cone that it is rolled to in place of the cylinder.
    pub(super) cone: Option<Cone>,
    /// Radii of a tube that narrows along a limb.
    pub(super) taper: Option<Taper>,
    /// Turn about the key point that lays the axis along that of an arm; none about the trunk.
    pub(super) tilt: Option<Rotation3<f64>>,
    pub(super) rotation: Rotation3<f64>,
    pub(super) offset: Vector3<f64>,
}

impl Placed {
    /// Start position of the pattern point `uv` \[m\].
    pub fn position(&self, uv: [f64; 2]) -> Vector3<f64> {
        let upright = self.up * Vector2::from(uv);
        if let Some(cone) = &self.cone {
            return self.on_cone(cone, &upright) + self.offset;
        }
        let middle = self.rolled(0.0, self.center_y - self.key[1]);
        let p = self.rolled(
            self.sense * self.spread * (upright.x - self.key[0]),
            upright.y - self.key[1],
        );
        middle + self.rotation * (p - middle) + self.offset
    }

    /// Returns true if it is rolled about an arm or a leg.
    pub fn is_about_limb(&self) -> bool {
        self.tilt.is_some()
    }

    /// Returns the direction on the drawing that is up, from its +x, counter-clockwise \[degrees\].
    pub fn up_deg(&self) -> f64 {
        (90.0 - self.up.angle().to_degrees())
            .round()
            .rem_euclid(360.0)
    }

    /// Returns where the middle of the panel's height starts, below its key point \[m\].
    pub fn middle(&self) -> Vector3<f64> {
        self.rolled(0.0, self.center_y - self.key[1]) + self.offset
    }

    /// Returns the same start further down a limb by as much as `ways` \[m\] lead on the whole;
    /// where they lead upwards, or the axis is that of the trunk, it stays.
    pub(super) fn moved_down_the_limb(mut self, ways: &[Vector3<f64>]) -> Self {
        if let Some(tilt) = self.tilt.filter(|_| !ways.is_empty()) {
            let down = tilt * -Vector3::y();
            let mean = ways.iter().sum::<Vector3<f64>>() / ways.len() as f64;
            self.axis += down * mean.dot(&down).clamp(0.0, MOST_DOWN);
        }
        self
    }

    /// Returns true if it is rolled about the trunk lower than another start of the same panel.
    pub(super) fn is_below(&self, other: &Self) -> bool {
        self.tilt.is_none() && self.axis.y < other.axis.y
    }

    /// The point of the turned drawing on a cone, whose narrow end is at the key point.
    fn on_cone(&self, cone: &Cone, upright: &Vector2<f64>) -> Vector3<f64> {
        let [turn, out, down] = cone.place(upright);
        let (sin, cos) = (self.outward + self.sense * turn).sin_cos();
        let radius = self.radius + out;
        self.axis + Vector3::new(radius * sin, -down, radius * cos)
    }

    /// The point `along` the panel's width from its key point and `up` from it \[m\].
    fn rolled(&self, along: f64, up: f64) -> Vector3<f64> {
        // Outward is (sin, 0, cos); (cos, 0, -sin) runs along increasing angle.
        let height = self.key[1] + up;
        let (radius, along, up) = self.taper.map_or((self.radius, along, up), |taper| {
            let aside = self.sense * taper.aside(height);
            let up = taper.start_height(height) - self.key[1];
            (taper.radius(self.radius, height), along - aside, up)
        });
        let round = |angle: f64, flat: f64| {
            let (sin, cos) = angle.sin_cos();
            Vector3::new(radius * sin + flat * cos, up, radius * cos - flat * sin)
        };
        let from_key = match self.wrap {
            Wrap::Flat => round(self.outward, along),
            Wrap::Cylinder => round(self.outward + along / radius, 0.0),
            Wrap::Level => return self.axis + Vector3::new(along, 0.0, -up),
        };
        self.axis + self.tilt.map_or(from_key, |tilt| tilt * from_key)
    }
}
