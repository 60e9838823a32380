//! A leg of trousers in one piece, rolled about a leg and that half of the hips.
//!
//! The middle of the panel lies at the outside of the leg; its edges of the crotch end short of the
//! body's middle, below the crotch, so that both seams close beside the trunk and not through it.

use super::limb_pose::{ABOVE_ANKLE, LimbPose, tilt};
use super::placed::Placed;
use super::taper::{self, Taper};
use crate::scene::{Avatar, Limb};
use nalgebra::{Vector2, Vector3};
use std::f64::consts::TAU;

/// Room between the hips and the panel at the start \[m\].
const CLEARANCE: f64 = 0.01;
/// Room between the body's crotch and the widest line of the panel, below it \[m\].
const BELOW_CROTCH: f64 = 0.02;
/// Distance from the body's middle that the panel has at least \[m\].
const BESIDE_MIDDLE: f64 = 0.005;
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
    let down = avatar.map_or(0.0, |avatar| {
        line.way_down([top - crotch, top - bottom], avatar)
    });
    let rolled = |radius: f64| Placed {
        axis: line.at(down),
        tilt: Some(tilt(&line.direction)),
        outward: side * 0.25 * TAU,
        key: [0.5 * (left + right), top],
        radius,
        taper: Taper::of(outline, radius, line.ends),
        offset: Vector3::zeros(),
        ..upright.clone()
    };
    let points = along(outline);
    let is_free = |placed: &Placed, has_room: bool| {
        points.iter().all(|p| {
            let place = placed.position((upright.up.inverse() * p).into());
            let is_of_hips = has_room && p.y >= crotch;
            side * place.x >= BESIDE_MIDDLE && !(is_of_hips && touches(&place, avatar))
        })
    };
    let first = line.hips.max((right - left) / TAU);
    let placed = rolled(least_radius(first, |radius, has_room| {
        is_free(&rolled(radius), has_room)
    }));
    Placed {
        offset: upright.offset,
        ..placed
    }
}

/// Returns the least radius from `first` on \[m\] at which a leg is free: told the radius, and if
/// there is room to clear the hips.
fn least_radius(first: f64, is_free: impl Fn(f64, bool) -> bool) -> f64 {
    let mut radius = first;
    while !is_free(radius, radius < first + MOST_ROOM) && radius < MOST_RADIUS {
        radius += RADIUS_STEP;
    }
    radius
}

fn touches(p: &Vector3<f64>, avatar: Option<&Avatar>) -> bool {
    avatar.is_some_and(|avatar| avatar.distance(p) < 0.5 * CLEARANCE)
}

/// Returns points of a closed outline, a step or less apart.
fn along(outline: &[Vector2<f64>]) -> Vec<Vector2<f64>> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::placement::AnchoredPlacement;
    use crate::scene::placement::test_body::body;
    use crate::seam::Face;

    /// The outline of a leg so wide at the crotch and so long \[m\], narrower at waist and hem: the
    /// front on the left.
    fn outline(width: f64, length: f64) -> Vec<Vector2<f64>> {
        let crotch = length - RISE;
        let points = [
            [0.25, 0.0],
            [0.0, crotch],
            [0.12, length - 0.03],
            [0.82, length],
            [1.0, crotch],
            [0.75, 0.0],
        ];
        points.map(|[x, y]| Vector2::new(width * x, y)).to_vec()
    }

    /// The start of such a leg.
    fn start(outline: &[Vector2<f64>], anchor: PlacementAnchor, avatar: &Avatar) -> Placed {
        let panel = Panel::rectangle("leg", [1.0, 1.0]);
        let placement = Placement {
            at: Some(anchor),
            ..Placement::default()
        };
        let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let waist = Placed {
            axis: Vector3::new(0.0, avatar.landmarks["waist_front"].y, 0.0),
            ..anchored.place(&panel, Face::Up, None)
        };
        let limb = match anchor {
            PlacementAnchor::LegRight => Limb::LegRight,
            _ => Limb::LegLeft,
        };
        place(waist, outline, limb, Some(avatar))
    }

    /// Height of the waist above the crotch \[m\].
    const RISE: f64 = 0.28;

    /// Tight and wide, short and long legs, on both sides.
    #[test]
    fn a_leg_starts_on_its_side_clear_of_the_body_and_of_the_foot() {
        let avatar = body();
        let [crotch, ankle] = ["crotch", "ankle_l"].map(|name| avatar.landmarks[name].y);
        let sides = [
            (PlacementAnchor::LegLeft, 1.0),
            (PlacementAnchor::LegRight, -1.0),
        ];
        for (anchor, side) in sides {
            for width in [0.48, 0.6, 0.9] {
                for length in [0.5, 0.9] {
                    let outline = outline(width, length);
                    let placed = start(&outline, anchor, &avatar);
                    let next = outline.iter().cycle().skip(1);
                    let edges = outline.iter().zip(next);
                    let along = edges
                        .flat_map(|(p, q)| (0..20).map(move |k| p.lerp(q, f64::from(k) / 20.0)));
                    for uv in along {
                        let p = placed.position(uv.into());
                        let told = format!("{anchor:?} {width} {length} {uv}: {p}");
                        assert!(side * p.x >= BESIDE_MIDDLE, "{told}");
                        assert!(avatar.exact_distance(&p) > 0.0, "{told}");
                        assert!(p.y > ankle, "{told}");
                    }
                    // Of the widest line that is looked at, within a step of a fortieth.
                    for x in [0.0, width] {
                        let end = placed.position([x, length - RISE]);
                        assert!(end.y < crotch - BELOW_CROTCH + 0.025 * length, "{end}");
                    }
                }
            }
        }
    }
}
