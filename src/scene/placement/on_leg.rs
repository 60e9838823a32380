//! A leg of trousers in one piece, rolled about a leg and that half of the hips.
//!
//! The middle of the panel lies at the outside of the leg; its edges of the crotch end short of the
//! body's middle, below the crotch, so that both seams close beside the trunk and not through it.

use super::limb_pose::LimbPose;
use super::placed::Placed;
use super::taper::{self, Taper};
use crate::scene::{Avatar, Limb};
use nalgebra::{Rotation3, Vector2, Vector3};
use std::f64::consts::TAU;

/// Room between the hips and the panel at the start, and between the crotch and the end of the
/// edges that are sewn there \[m\].
const CLEARANCE: f64 = 0.01;
const BELOW_CROTCH: f64 = 0.02;
/// Distance from the body's middle that the edges of the crotch have at least \[m\].
const BESIDE_MIDDLE: f64 = 0.005;
/// Height of the hem above the ankle \[m\]: below, it would close through the foot.
const ABOVE_ANKLE: f64 = 0.02;
/// Distance below the joint of the hip from which on a leg is apart from the trunk \[m\].
const BESIDE_TRUNK: f64 = 0.1;
/// Steps in height at which the hips are looked at, and in radius \[m\].
const STEP: f64 = 0.01;
const RADIUS_STEP: f64 = 0.002;
/// Largest radius of a leg \[m\]: of a skirt as wide the edges need not be kept apart.
const MOST_RADIUS: f64 = 0.5;
/// Middle of the left leg, and heights of crotch, waist and ankle, without a body \[m\].
const NO_BODY: f64 = 0.09;

/// A leg as the panel about it sees it: a straight line, and how far the body reaches from it.
struct LegLine {
    /// Point of the line at the height of the waist \[m\].
    top: Vector3<f64>,
    /// Direction down the leg, of length 1.
    direction: Vector3<f64>,
    /// Least radius about the hips, and at the upper and the lower end of the leg \[m\].
    hips: f64,
    ends: [f64; 2],
}

/// Returns the start of `upright`, a panel at the waist with this outline on the turned drawing,
/// about a leg of a body.
pub(super) fn place(
    upright: Placed,
    outline: &[Vector2<f64>],
    limb: Limb,
    avatar: Option<&Avatar>,
) -> Placed {
    let side = if limb == Limb::LegRight { -1.0 } else { 1.0 };
    let [bottom, top] = taper::heights(outline);
    let (crotch, [left, right]) = taper::widest_line(outline);
    let line = LegLine::of(limb, side, &upright.axis, top - bottom, avatar);
    let middle = 0.5 * (left + right);
    let from_middle: Vec<_> = outline.iter().map(|p| [p.x - middle, top - p.y]).collect();
    let radius = radius(&line, side, right - left, &from_middle);
    let down = avatar.map_or(0.0, |avatar| {
        line.way_down([top - crotch, top - bottom], avatar)
    });
    Placed {
        axis: line.top + line.direction * down,
        tilt: Rotation3::rotation_between(&-Vector3::y(), &line.direction),
        outward: side * 0.25 * TAU,
        key: [middle, top],
        radius,
        taper: Taper::of(outline, radius, line.ends),
        ..upright
    }
}

impl LegLine {
    /// The line along a leg for a panel of this length from the waist down \[m\].
    fn of(
        limb: Limb,
        side: f64,
        waist: &Vector3<f64>,
        length: f64,
        avatar: Option<&Avatar>,
    ) -> Self {
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
                let end = (length - (waist.y - joint.y)).clamp(2.0 * BESIDE_TRUNK, axis.length());
                let pose = LimbPose::between(axis, &joint, [BESIDE_TRUNK, end]);
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
        line.ends[0] = line.hips;
        line
    }

    /// The point of the line at a way down from the waist \[m\].
    fn at(&self, down: f64) -> Vector3<f64> {
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
    fn way_down(&self, [crotch, hem]: [f64; 2], avatar: &Avatar) -> f64 {
        let along = |name: &str| {
            let height = avatar.landmarks.get(name)?.y;
            Some((height - self.top.y) / self.direction.y)
        };
        let least = along("crotch").map_or(0.0, |down| down + BELOW_CROTCH - crotch);
        let most = along("ankle_l").map_or(f64::INFINITY, |down| down - ABOVE_ANKLE - hem);
        most.min(0.0).max(least)
    }
}

/// Returns the least radius at which a panel of this width clears the hips and all of its outline
/// stays on its side of the body: points beside its middle and below its upper end \[m\].
fn radius(line: &LegLine, side: f64, width: f64, outline: &[[f64; 2]]) -> f64 {
    let is_aside = |radius: f64| {
        let reach = |[beside, below]: &[f64; 2]| {
            side * line.at(*below).x + radius * (beside / radius).cos()
        };
        outline.iter().all(|p| reach(p) >= BESIDE_MIDDLE)
    };
    let mut radius = line.hips.max(width / TAU);
    while !is_aside(radius) && radius < MOST_RADIUS {
        radius += RADIUS_STEP;
    }
    radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::placement::AnchoredPlacement;
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

    /// The start of a rectangle about a leg, with points all over it.
    fn start(size: [f64; 2], anchor: PlacementAnchor, avatar: &Avatar) -> Vec<Vector3<f64>> {
        let panel = Panel::rectangle("leg", size);
        let placement = Placement {
            at: Some(anchor),
            ..Placement::default()
        };
        let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let placed = anchored.place(&panel, Face::Up, Some(avatar));
        let share = |k: u32| f64::from(k) / 40.0;
        (0..=40)
            .flat_map(|i| (0..=40).map(move |j| [size[0] * share(i), size[1] * share(j)]))
            .map(|uv| placed.position(uv))
            .collect()
    }

    /// Narrow and wide, short and long legs, on both sides.
    #[test]
    fn a_leg_starts_on_its_side_clear_of_the_body_and_of_the_foot() {
        let avatar = body();
        let ankle = avatar.landmarks["ankle_l"].y;
        let sides = [
            (PlacementAnchor::LegLeft, 1.0),
            (PlacementAnchor::LegRight, -1.0),
        ];
        for (anchor, side) in sides {
            for width in [0.48, 0.6, 0.9] {
                for length in [0.5, 0.9] {
                    let points = start([width, length], anchor, &avatar);
                    let told = format!("{anchor:?} {width} {length}");
                    for p in &points {
                        assert!(
                            side * p.x > -0.01 && avatar.exact_distance(p) > 0.0,
                            "{told}: {p}"
                        );
                    }
                    let heights = points.iter().map(|p| p.y);
                    assert!(heights.fold(f64::INFINITY, f64::min) > ankle, "{told}");
                }
            }
        }
    }
}
