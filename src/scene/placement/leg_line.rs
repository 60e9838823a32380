//! A leg and half of the hips as what is rolled about them sees them: a straight line, and a radius
//! that is clear of the body.

use super::limb_pose::LimbPose;
use super::placed::Placed;
use crate::scene::{Avatar, Limb};
use nalgebra::{Vector2, Vector3};

/// Room between the hips and the panel at the start \[m\].
const CLEARANCE: f64 = 0.01;
/// Room between the body's crotch and the widest line of the panel, below it \[m\].
pub(super) const BELOW_CROTCH: f64 = 0.02;
/// Height of the hem of trousers above the ankles \[m\]: below, it would close through a foot.
pub(super) const ABOVE_ANKLE: f64 = 0.02;
/// Distance from the body's middle that the panel has at least \[m\].
pub(super) const BESIDE_MIDDLE: f64 = 0.005;
/// Distance below the joint of the hip from which on a leg is apart from the trunk \[m\].
const BESIDE_TRUNK: f64 = 0.1;
/// Steps in height at which the hips are looked at, and along outlines \[m\].
const STEP: f64 = 0.01;
/// Steps in which the radius grows until both edges of the crotch are on their side \[m\].
const RADIUS_STEP: f64 = 0.002;
/// Room that the radius grows by at most to clear the hips \[m\].
const MOST_ROOM: f64 = 0.04;
/// Largest radius of a leg \[m\]: of a skirt as wide the edges need not be kept apart.
const MOST_RADIUS: f64 = 0.5;
/// Distance of the middle of a leg from that of a body that is not there \[m\].
const NO_BODY: f64 = 0.09;

/// A leg as the panel about it sees it: a straight line, and how far the body reaches from it.
pub(super) struct LegLine {
    /// Point of the line at the height of the waist \[m\].
    top: Vector3<f64>,
    /// Direction down the leg, of length 1.
    pub(super) direction: Vector3<f64>,
    /// Least radius about the hips, and at the upper and the lower end of the leg \[m\].
    pub(super) hips: f64,
    pub(super) ends: [f64; 2],
}

impl LegLine {
    /// The line along a leg for a panel of this length from the waist down \[m\].
    pub(super) fn of(
        limb: Limb,
        waist: &Vector3<f64>,
        length: f64,
        avatar: Option<&Avatar>,
    ) -> Self {
        let side = limb.side();
        let straight = |x: f64| Self {
            top: Vector3::new(side * x, waist.y, waist.z),
            direction: -Vector3::y(),
            hips: 0.0,
            ends: [0.0; 2],
        };
        let Some(avatar) = avatar else {
            return straight(NO_BODY);
        };
        let axis = avatar.limb(limb);
        let mut line = axis.map_or_else(
            || {
                let bounds = avatar.section_bounds(avatar.heights()[0].max(waist.y - length));
                straight(bounds.map_or(NO_BODY, |[x, _]| 0.5 * x[1].max(-x[0])))
            },
            |axis| {
                let joint = axis.at(0.0).0;
                let end = length - (waist.y - joint.y);
                let end = end.max(2.0 * BESIDE_TRUNK).min(axis.length());
                let start = BESIDE_TRUNK.min(0.5 * end);
                let pose = LimbPose::between(axis, &joint, [start, end]);
                let up = (waist.y - pose.top.y) / pose.direction.y;
                Self {
                    top: pose.top + pose.direction * up,
                    direction: pose.direction,
                    hips: pose.radius,
                    ends: pose.line,
                }
            },
        );
        line.hips = line.hips.max(line.reach_of_hips(side, avatar) + CLEARANCE);
        line.ends[0] = line.ends[0].max(line.hips);
        line
    }

    /// Returns the same line with its upper end aside by so much towards +x \[m\], to the same
    /// point at a length along it.
    pub(super) fn moved_out(&self, by: f64, length: f64) -> Self {
        let top = self.top + Vector3::x() * by;
        Self {
            direction: (self.at(length) - top).normalize(),
            top,
            hips: self.hips,
            ends: [self.ends[0] + by.abs(), self.ends[1]],
        }
    }

    /// The point of the line at a way down from the waist \[m\].
    pub(super) fn at(&self, down: f64) -> Vector3<f64> {
        self.top + self.direction * down
    }

    /// Returns how far the hips reach from the line to the outside, the front and the back, between
    /// crotch and waist \[m\].
    fn reach_of_hips(&self, side: f64, avatar: &Avatar) -> f64 {
        let lowest = avatar.landmarks.get("crotch").map_or(0.0, |p| p.y);
        let lowest = lowest.max(avatar.heights()[0]);
        let mut reach: f64 = 0.0;
        let mut y = self.top.y;
        while y > lowest {
            let center = self.at((y - self.top.y) / self.direction.y);
            if let Some([x, z]) = avatar.section_bounds(y) {
                let outer = if side > 0.0 { x[1] } else { -x[0] };
                let depth = (z[1] - center.z).max(center.z - z[0]);
                reach = reach.max(outer - side * center.x).max(depth);
            }
            y -= STEP;
        }
        reach
    }

    /// Returns how far below the waist the panel starts \[m\], with its crotch and its hem so far
    /// below its upper end: its crotch has room below that of the body, and if that leaves it room
    /// the hem stays above the ankle.
    pub(super) fn way_down(&self, [crotch, hem]: [f64; 2], avatar: &Avatar) -> f64 {
        let along = self.way_to("crotch", avatar);
        let least = along.map_or(0.0, |down| down + BELOW_CROTCH - crotch);
        (self.lowest_hem(avatar) - hem).min(0.0).max(least)
    }

    /// Returns how far below the waist a hem is above the ankle \[m\].
    pub(super) fn lowest_hem(&self, avatar: &Avatar) -> f64 {
        let along = self.way_to("ankle_l", avatar);
        along.map_or(f64::INFINITY, |down| down - ABOVE_ANKLE)
    }

    /// Returns how far along the line it is as high as a landmark \[m\].
    fn way_to(&self, landmark: &str, avatar: &Avatar) -> Option<f64> {
        let height = avatar.landmarks.get(landmark)?.y;
        Some((height - self.top.y) / self.direction.y)
    }
}

/// Returns true if a start puts all of these points of its turned drawing on their side of the
/// body's middle, and, if they are to clear the hips, those above a crotch at this height of it off
/// the body.
pub(super) fn is_free(
    start: &Placed,
    points: &[Vector2<f64>],
    side: f64,
    hips: Option<(f64, &Avatar)>,
) -> bool {
    let touches = |p: &Vector2<f64>, place: &Vector3<f64>| {
        hips.is_some_and(|(crotch, avatar)| {
            p.y >= crotch && avatar.distance(place) < 0.5 * CLEARANCE
        })
    };
    points.iter().all(|p| {
        let place = start.position((start.up.inverse() * p).into());
        side * place.x >= BESIDE_MIDDLE && !touches(p, &place)
    })
}

/// Returns the least radius from `first` on \[m\] at which a leg is free: told the radius, and if
/// there is room to clear the hips.
pub(super) fn least_radius(first: f64, is_free: impl Fn(f64, bool) -> bool) -> f64 {
    let mut radius = first;
    while !is_free(radius, radius < first + MOST_ROOM) && radius < MOST_RADIUS {
        radius += RADIUS_STEP;
    }
    radius
}

/// Returns points of a closed outline, a step or less apart.
pub(super) fn along(outline: &[Vector2<f64>]) -> Vec<Vector2<f64>> {
    let next = outline.iter().cycle().skip(1);
    let edges = outline.iter().zip(next).flat_map(|(p, q)| {
        let count = ((q - p).norm() / STEP).ceil();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the length of an edge over a step"
        )]
        let steps = 0..count as usize;
        steps.map(move |k| p.lerp(q, k as f64 / count))
    });
    edges.collect()
}
