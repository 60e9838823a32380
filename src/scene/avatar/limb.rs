//! The limbs of a body as tubes round axes.

use nalgebra::Vector3;

/// A limb of a body; its left is at +x.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Limb {
    /// The arm at +x.
    ArmLeft,
    /// The arm at -x.
    ArmRight,
    /// The leg at +x.
    LegLeft,
    /// The leg at -x.
    LegRight,
}

impl Limb {
    /// Returns +1 for a limb at +x and -1 for one at -x.
    pub fn side(self) -> f64 {
        match self {
            Self::ArmLeft | Self::LegLeft => 1.0,
            Self::ArmRight | Self::LegRight => -1.0,
        }
    }
}

/// The axis of a limb, from the shoulder joint to the wrist, or from the hip joint to the ankle.
#[derive(Clone, Debug, PartialEq)]
pub struct LimbAxis {
    /// Shoulder, elbow and wrist, or hip, knee and ankle \[m\]; they may lie beside the middle.
    pub joints: [Vector3<f64>; 3],
    /// Points of the axis \[m\], two or more.
    pub points: Vec<Vector3<f64>>,
    /// Radius of the limb at each point \[m\]: its girth over 2 pi.
    pub radii: Vec<f64>,
}

impl LimbAxis {
    /// Returns the same axis on the other side of the body.
    pub(super) fn mirrored(&self) -> Self {
        let opposite = |p: &Vector3<f64>| Vector3::new(-p.x, p.y, p.z);
        Self {
            joints: self.joints.each_ref().map(opposite),
            points: self.points.iter().map(opposite).collect(),
            radii: self.radii.clone(),
        }
    }

    /// Length of the axis \[m\].
    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|p| (p[1] - p[0]).norm()).sum()
    }

    /// Returns the point at a length along the axis \[m\] and the direction there.
    pub fn at(&self, along: f64) -> (Vector3<f64>, Vector3<f64>) {
        let mut left = along.max(0.0);
        let mut last = (self.points[0], Vector3::y());
        for pair in self.points.windows(2) {
            let piece = pair[1] - pair[0];
            let length = piece.norm();
            let direction = piece / length;
            if left <= length {
                return (pair[0] + direction * left, direction);
            }
            left -= length;
            last = (pair[1], direction);
        }
        last
    }

    /// Returns the radius at a length along the axis \[m\].
    pub fn radius(&self, along: f64) -> f64 {
        let mut left = along.max(0.0);
        for (pair, radii) in self.points.windows(2).zip(self.radii.windows(2)) {
            let length = (pair[1] - pair[0]).norm();
            if left <= length {
                return radii[0] + (radii[1] - radii[0]) * (left / length);
            }
            left -= length;
        }
        self.radii.last().copied().unwrap_or(0.0)
    }
}
