//! A panel put at a key point of the body.

use super::cone::Cone;
use super::limb_pose::LimbPose;
use super::name_hint::guess;
use super::on_leg;
use super::placed::Placed;
use super::spot::Spot;
use super::taper::{Lines, Taper};
use crate::fault::{Fault, Faults, PlacementCode, pointer_token};
use crate::pattern::{Hole, Panel, Placement, PlacementAnchor, Wrap, polyline};
use crate::scene::{Avatar, Limb};
use crate::seam::Face;
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use std::f64::consts::TAU;

/// Room left between the body and a panel at the start \[m\].
pub(super) const CLEARANCE: f64 = 0.03;
/// Way down that a band is moved by at least and at most to start beside what it is sewn to \[m\].
const LEAST_DOWN: f64 = 0.03;
const MOST_DOWN: f64 = 0.4;
/// Share of a turn that is covered by what starts nearly closed, and how much wider than drawn it
/// starts for that at most.
const NEARLY_CLOSED: f64 = 0.97;
const MOST_SPREAD: f64 = 1.6;
/// Steps in height at which the width of the body is sampled \[m\].
const HEIGHT_STEP: f64 = 0.02;

/// A placement whose key point on the body is known: stated, or told by the panel's name.
#[derive(Clone, Debug, PartialEq)]
pub struct AnchoredPlacement {
    anchor: PlacementAnchor,
    placement: Placement,
    /// True if the pattern's file states it, for a body of its own.
    is_of_file: bool,
}

impl AnchoredPlacement {
    /// Anchors `panel` where it is stated to start, or where its name says.
    ///
    /// # Errors
    /// `placement/unknown` at `/panels/<id>/placement` if neither tells a key point of the body.
    pub fn new(panel: &Panel, stated: Option<&Placement>) -> Result<Self, Faults> {
        let placement = stated.cloned().unwrap_or_default();
        let anchor = placement
            .at
            .or_else(|| guess(panel))
            .ok_or_else(|| unknown(panel))?;
        Ok(Self {
            anchor,
            placement,
            is_of_file: false,
        })
    }

    /// Returns the same placement as one that the pattern's file states.
    #[must_use]
    pub fn of_file(self) -> Self {
        Self {
            is_of_file: true,
            ..self
        }
    }

    /// Returns true if a file puts the panel somewhere in space, about a body of its own.
    pub fn is_about_other_body(&self) -> bool {
        self.is_of_file && self.anchor == PlacementAnchor::Origin
    }

    /// Returns true if a panel that would start flat may start rolled about a leg: the garment puts
    /// it nowhere in space, and does not say that it starts flat.
    pub(super) fn may_be_rolled(&self) -> bool {
        let is_to_stay_flat = !self.is_of_file && self.placement.wrap == Some(Wrap::Flat);
        !self.is_fixed() && !is_to_stay_flat
    }

    /// Returns true if the garment puts the panel somewhere in space: there it starts.
    pub(super) fn is_fixed(&self) -> bool {
        !self.is_of_file && self.anchor == PlacementAnchor::Origin
    }

    /// Returns true if the panel is rolled all round and may be turned about the axis: where
    /// nothing says how it is to be turned.
    pub(super) fn turns(&self) -> bool {
        let Self {
            anchor, placement, ..
        } = self;
        let wrap = placement.wrap.unwrap_or(Wrap::Cylinder);
        let goes_round = matches!(
            anchor,
            PlacementAnchor::Waist
                | PlacementAnchor::Neck
                | PlacementAnchor::ArmLeft
                | PlacementAnchor::ArmRight
        );
        goes_round && wrap == Wrap::Cylinder && placement.rotate_deg == [0.0; 3]
    }

    /// Returns the placements that it leaves open: in each a quarter turn further, where it does
    /// not say which way of the drawing is up; else itself.
    pub(super) fn quarter_turns(&self) -> Vec<Self> {
        if self.placement.up_deg.is_some() {
            return vec![self.clone()];
        }
        let turned = |up_deg: f64| Self {
            placement: Placement {
                up_deg: Some(up_deg),
                ..self.placement.clone()
            },
            ..self.clone()
        };
        [90.0, 180.0, 270.0, 0.0].map(turned).to_vec()
    }

    /// Places `panel`, whose side `face` is out, on `avatar`, or in free space without one.
    pub fn place(&self, panel: &Panel, face: Face, avatar: Option<&Avatar>) -> Placed {
        let Self {
            anchor, placement, ..
        } = self;
        let up = Rotation2::new((90.0 - placement.up_deg.unwrap_or(90.0)).to_radians());
        let [[left, right], [bottom, top]] = bounds(panel, &up);
        let center_y = 0.5 * (bottom + top);
        let spot = Spot::of(*anchor, avatar, top - bottom);
        let wrap = placement.wrap.unwrap_or(match spot.turn {
            Some(_) => Wrap::Cylinder,
            None => Wrap::Flat,
        });
        let [rx, ry, rz] = placement.rotate_deg.map(f64::to_radians);
        let turn = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle);
        let mut placed = Placed {
            up,
            key: [0.5 * (left + right), if spot.hangs { top } else { bottom }],
            center_y,
            sense: if face == Face::Up { 1.0 } else { -1.0 },
            outward: spot.outward,
            axis: spot.axis,
            radius: 0.0,
            wrap,
            spread: 1.0,
            cone: None,
            taper: None,
            tilt: spot.tilt,
            rotation: turn(Vector3::x(), rx) * turn(Vector3::y(), ry) * turn(Vector3::z(), rz),
            offset: Vector3::from(placement.offset_m),
        };
        if *anchor == PlacementAnchor::Origin {
            placed.key[1] = center_y;
            placed.sense = 1.0;
            return placed;
        }
        if let (Some(limb), Wrap::Cylinder) = (leg_of(*anchor), wrap) {
            let outline: Vec<_> = outline(panel).map(|uv| up * Vector2::from(uv)).collect();
            return on_leg::place(placed, &outline, limb, avatar);
        }
        if wrap == Wrap::Level {
            placed.key = middle_of_hole(panel, &up).unwrap_or([placed.key[0], center_y]);
            return placed;
        }
        let height = spot.axis.y;
        let span = [
            height + bottom - placed.key[1],
            height + top - placed.key[1],
        ];
        // Rolled, a panel meets itself at most; half a band covers half a turn.
        let around = (right - left) / (TAU * spot.turn.unwrap_or(1.0));
        placed.radius = if spot.tilt.is_none() {
            let reach = radius(avatar, spot.axis.z, span, wrap) + CLEARANCE;
            if wrap == Wrap::Cylinder {
                reach.max(around)
            } else {
                reach
            }
        } else {
            around.max(CLEARANCE).max(spot.radius)
        };
        if spot.tilt.is_some() && spot.turn == Some(1.0) && wrap == Wrap::Cylinder {
            let outline: Vec<_> = outline(panel).map(|uv| up * Vector2::from(uv)).collect();
            placed.taper = Taper::of(&Lines::of(&outline), placed.radius, spot.line);
        }
        placed
    }

    /// Returns the same start further down the trunk by as much as `ways` \[m\] lead on the whole,
    /// and clear of the body there: a band at the hem of a bodice starts below the waist. Where
    /// they lead upwards it stays.
    pub(super) fn moved_down_the_trunk(
        &self,
        placed: Placed,
        panel: &Panel,
        ways: &[Vector3<f64>],
        avatar: Option<&Avatar>,
    ) -> Placed {
        let mean = ways.iter().map(|way| way.y).sum::<f64>() / ways.len().max(1) as f64;
        if self.anchor != PlacementAnchor::Waist || mean > -LEAST_DOWN {
            return placed;
        }
        let axis = placed.axis + Vector3::y() * mean.max(-MOST_DOWN);
        let [_, [bottom, top]] = bounds(panel, &placed.up);
        let span = [bottom, top].map(|y| axis.y + y - placed.key[1]);
        let reach = radius(avatar, axis.z, span, Wrap::Cylinder) + CLEARANCE;
        Placed {
            radius: placed.radius.max(reach),
            axis,
            ..placed
        }
    }

    /// Returns the same start further down an arm by as much as `ways` \[m\] lead on the whole, and
    /// about the arm as it is there.
    pub(super) fn moved_down_the_arm(
        &self,
        placed: Placed,
        panel: &Panel,
        ways: &[Vector3<f64>],
        avatar: Option<&Avatar>,
    ) -> Placed {
        let moved = placed.moved_down_the_limb(ways);
        let limb = match self.anchor {
            PlacementAnchor::ArmLeft => Limb::ArmLeft,
            PlacementAnchor::ArmRight => Limb::ArmRight,
            _ => return moved,
        };
        let [[left, right], [bottom, top]] = bounds(panel, &moved.up);
        let point = moved.axis + moved.offset;
        let pose = avatar.and_then(|body| LimbPose::beside(body, limb, &point, top - bottom));
        let Some(pose) = pose else { return moved };
        let radius = pose.radius.max((right - left) / TAU);
        let outline: Vec<_> = outline(panel)
            .map(|uv| moved.up * Vector2::from(uv))
            .collect();
        Placed {
            axis: pose.top,
            tilt: Some(pose.tilt()),
            radius,
            taper: Taper::of(&Lines::of(&outline), radius, pose.line),
            offset: Vector3::zeros(),
            ..moved
        }
    }

    /// Returns the same start rolled to a cone about the trunk, where the panel's stitches to
    /// itself, pairs of points of the drawing, make one of it.
    pub(super) fn coned(
        &self,
        placed: Placed,
        panel: &Panel,
        stitches: &[[[f64; 2]; 2]],
        avatar: Option<&Avatar>,
    ) -> Placed {
        let is_about_trunk = placed.wrap == Wrap::Cylinder && placed.tilt.is_none();
        let is_turned = self.placement.rotate_deg != [0.0; 3];
        if !is_about_trunk || is_turned || self.turns() || self.anchor == PlacementAnchor::Origin {
            return placed;
        }
        let upright = |uv: [f64; 2]| placed.up * Vector2::from(uv);
        let outline: Vec<_> = outline(panel).map(upright).collect();
        let stitches: Vec<_> = stitches.iter().map(|pair| pair.map(upright)).collect();
        let Some(cone) = Cone::of(&outline, &stitches) else {
            return placed;
        };
        let top = placed.axis.y;
        let span = [top - cone.height(&outline), top];
        let reach = radius(avatar, placed.axis.z, span, Wrap::Cylinder) + CLEARANCE;
        Placed {
            radius: reach.max(cone.radius()),
            cone: Some(cone),
            ..placed
        }
    }
}

/// Returns how much wider than drawn \[m\] what goes round starts at a radius \[m\] to be nearly
/// closed.
pub(super) fn nearly_closed(width: f64, radius: f64) -> f64 {
    (TAU * radius * NEARLY_CLOSED / width).clamp(1.0, MOST_SPREAD)
}

/// Returns the leg that a key point is about.
fn leg_of(anchor: PlacementAnchor) -> Option<Limb> {
    match anchor {
        PlacementAnchor::LegLeft => Some(Limb::LegLeft),
        PlacementAnchor::LegRight => Some(Limb::LegRight),
        _ => None,
    }
}

/// Returns the reach of the trunk from its axis between two heights \[m\]: to the front and back
/// for flat panels, all round for rolled ones. Beyond the tips of the shoulders there are arms.
fn radius(avatar: Option<&Avatar>, center: f64, span: [f64; 2], wrap: Wrap) -> f64 {
    let Some(avatar) = avatar else {
        return CLEARANCE;
    };
    let tip = avatar.landmarks.get("shoulder_tip_l");
    let tip = tip.map_or(f64::INFINITY, |tip| tip.x);
    let [low, high] = avatar.heights();
    let [low, high] = [span[0].max(low), span[1].min(high)];
    let mut reach: f64 = 0.0;
    let mut y = low;
    while y < high + HEIGHT_STEP {
        if let Some([x, z]) = avatar.section_bounds(y.min(high)) {
            reach = reach.max(z[1] - center).max(center - z[0]);
            if wrap == Wrap::Cylinder {
                reach = reach.max(x[1].min(tip)).max((-x[0]).min(tip));
            }
        }
        y += HEIGHT_STEP;
    }
    reach
}

/// Returns the middle of the bounding box of a panel's largest hole, turned by `up` \[m\].
fn middle_of_hole(panel: &Panel, up: &Rotation2<f64>) -> Option<[f64; 2]> {
    let around = |hole: &&Hole| -> f64 { hole.edges.iter().map(|edge| edge.length_m).sum() };
    let mut holes = panel.holes.iter();
    let first = holes.next()?;
    let largest = holes.fold(first, |most, hole| {
        if around(&hole) > around(&most) {
            hole
        } else {
            most
        }
    });
    let points = largest.edges.iter().flat_map(|edge| &edge.points);
    let turned: Vec<[f64; 2]> = points
        .map(|point| (up * Vector2::from(*point)).into())
        .collect();
    let [low, high] = polyline::bounds(&turned);
    Some([0, 1].map(|k| f64::midpoint(low[k], high[k])))
}

/// The points of a panel's outline in pattern coordinates \[m\].
pub(super) fn outline(panel: &Panel) -> impl Iterator<Item = [f64; 2]> {
    let points = panel.edges.iter().flat_map(|edge| &edge.points);
    points.copied()
}

/// Bounding box of a panel turned by `up`: `[[min x, max x], [min y, max y]]` \[m\].
pub(super) fn bounds(panel: &Panel, up: &Rotation2<f64>) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in outline(panel) {
        let turned = up * Vector2::from(point);
        for (bound, value) in bounds.iter_mut().zip(turned.iter()) {
            *bound = [bound[0].min(*value), bound[1].max(*value)];
        }
    }
    bounds
}

fn unknown(panel: &Panel) -> Faults {
    let pointer = format!("/panels/{}/placement", pointer_token(&panel.id));
    Fault::new(PlacementCode::Unknown, pointer, format!("the name of panel {} does not say where on the body it goes", panel.id))
        .fix("give \"at\": torso_front, torso_back, skirt_front, skirt_back, waist, waist_front, waist_back, neck, arm_left, arm_right, leg_left, leg_right or origin, or take suggested placements")
        .into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DressForm, Limbs};

    /// A strip of 40 cm by 4 cm, about the neck of a body with arms.
    #[test]
    fn a_collar_starts_above_the_shoulders_and_clear_of_the_neck() {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: true,
                legs: false,
            }),
            ..DressForm::default()
        };
        let avatar = form.build().expect("a body");
        let panel = Panel::rectangle("collar", [0.4, 0.04]);
        let placement = Placement {
            at: Some(PlacementAnchor::Neck),
            ..Placement::default()
        };
        let placement = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let placed = placement.place(&panel, Face::Up, Some(&avatar));
        let side = avatar.landmarks["neck_side_l"];
        for k in 0..=40 {
            let p = placed.position([0.01 * f64::from(k), 0.0]);
            assert!(p.y > side.y && avatar.exact_distance(&p) > 0.01, "{p}");
            // Round the neck, not round the shoulders.
            assert!(p.x.hypot(p.z) < 2.0 * side.x.hypot(side.z), "{p}");
        }
    }
}
