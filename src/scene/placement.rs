//! Start position of each panel (P7): its key point is put at a key point of the body, in front,
//! behind or round it.

use super::Avatar;
use crate::fault::{Fault, Faults, PlacementCode, pointer_token};
use crate::pattern::{Panel, Placement, PlacementAnchor, Wrap};
use crate::seam::Face;
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Room left between the body and a panel at the start \[m\].
const CLEARANCE: f64 = 0.03;
/// Room left between the layers of a garment at the start \[m\].
const LAYER_CLEARANCE: f64 = 0.01;
/// Steps in height at which the width of the body is sampled \[m\].
const HEIGHT_STEP: f64 = 0.02;
/// Key points of a garment without a body.
const NO_BODY: BodyKeyPoints = BodyKeyPoints {
    shoulder: 1.4,
    neck: 1.42,
    waist: 1.05,
    centre: 0.0,
    arm: [0.19, 1.37],
};
/// A sleeve starts at this angle from the body \[rad\]: so that it clears the sides.
const ARM_SPREAD: f64 = 0.7;

/// Key points of a body: heights, the middle in depth, x and y of the left shoulder's tip \[m\].
#[derive(Clone, Copy, Debug)]
struct BodyKeyPoints {
    shoulder: f64,
    neck: f64,
    waist: f64,
    centre: f64,
    arm: [f64; 2],
}

impl BodyKeyPoints {
    fn of(avatar: &Avatar) -> Self {
        let height =
            |name: &str, otherwise: f64| avatar.landmarks.get(name).map_or(otherwise, |p| p.y);
        let waist = height("waist_front", NO_BODY.waist);
        let centre = avatar
            .section_bounds(waist)
            .map_or(0.0, |[_, z]| 0.5 * (z[0] + z[1]));
        let shoulder = height("neck_side_l", NO_BODY.shoulder);
        let tip = avatar.landmarks.get("shoulder_tip_l");
        Self {
            shoulder,
            neck: height("neck_front", shoulder),
            waist,
            centre,
            arm: tip.map_or(NO_BODY.arm, |tip| [tip.x, tip.y]),
        }
    }
}

/// A placement whose key point on the body is known: stated, or told by the panel's name.
#[derive(Clone, Debug, PartialEq)]
pub struct AnchoredPlacement {
    anchor: PlacementAnchor,
    placement: Placement,
}

/// The way from pattern coordinates to the start position in space.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Turns the drawing so that up on the body is +y.
    up: Rotation2<f64>,
    /// The key point and the middle of the height, in the turned drawing \[m\].
    key: [f64; 2],
    centre_y: f64,
    /// +1 where the drawn +x runs along increasing angle, -1 where it runs against it.
    sense: f64,
    /// Angle of the outward direction from +z towards +x \[rad\].
    outward: f64,
    /// Point of the axis at the key point's height \[m\].
    axis: Vector3<f64>,
    /// Distance from the axis \[m\].
    radius: f64,
    wrap: Wrap,
    /// Lean of the axis about the key point; positive takes its lower end to +x \[rad\].
    lean: f64,
    rotation: Rotation3<f64>,
    offset: Vector3<f64>,
}

impl Placed {
    /// Start position of the pattern point `uv` \[m\].
    pub fn position(&self, uv: [f64; 2]) -> Vector3<f64> {
        let upright = self.up * Vector2::from(uv);
        let middle = self.rolled(0.0, self.centre_y - self.key[1]);
        let p = self.rolled(
            self.sense * (upright.x - self.key[0]),
            upright.y - self.key[1],
        );
        middle + self.rotation * (p - middle) + self.offset
    }

    /// The same, further from the axis where `cloth` \[m\] at the panel's height reaches beyond its
    /// start; as it is at an arm, in a free place, or without cloth.
    #[must_use]
    pub fn outside(self, panel: &Panel, cloth: &[Vector3<f64>]) -> Self {
        let [low, high] = self.heights(panel);
        let beside = cloth.iter().filter(|p| (low..=high).contains(&p.y));
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
        let [low, high] = self.heights(panel);
        let beside = lower.filter(|(panel, placed)| {
            let [lowest, highest] = placed.heights(panel);
            lowest <= high && low <= highest
        });
        let points = beside.flat_map(|(panel, placed)| {
            outline(panel).map(|uv| placed.position(uv) - placed.offset)
        });
        let most = points.map(|p| self.reach(&p)).fold(0.0, f64::max);
        self.beyond(most, LAYER_CLEARANCE)
    }

    /// Puts the panel `clearance` beyond what reaches so far from the axis, if anything does \[m\].
    fn beyond(mut self, reach: f64, clearance: f64) -> Self {
        if reach > 0.0 && self.lean == 0.0 && self.radius > 0.0 {
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
            Wrap::Flat => z.abs(),
            Wrap::Cylinder => x.hypot(z),
        }
    }

    /// The point `along` the panel's width from its key point and `up` from it \[m\].
    fn rolled(&self, along: f64, up: f64) -> Vector3<f64> {
        let (angle, flat) = match self.wrap {
            Wrap::Flat => (self.outward, along),
            Wrap::Cylinder => (self.outward + along / self.radius, 0.0),
        };
        let (sin, cos) = angle.sin_cos();
        // Outward is (sin, 0, cos); (cos, 0, -sin) runs along increasing angle.
        let from_key = Vector3::new(
            self.radius * sin + flat * cos,
            up,
            self.radius * cos - flat * sin,
        );
        self.axis + Rotation3::new(Vector3::z() * self.lean) * from_key
    }
}

/// Position of an anchor, and the pose of panels there.
struct Spot {
    /// Point of the axis at the key point's height \[m\].
    axis: Vector3<f64>,
    /// True if the key point is the top of the panel, not its bottom.
    hangs: bool,
    /// Angle of the outward direction from +z towards +x \[rad\].
    outward: f64,
    /// The part of a turn that a rolled panel covers at least; nothing where panels lie flat unless
    /// told.
    turn: Option<f64>,
    lean: f64,
}

impl Spot {
    fn of(anchor: PlacementAnchor, body: &BodyKeyPoints) -> Self {
        let spot = |height: f64, hangs: bool, outward: f64, turn: Option<f64>| Self {
            axis: Vector3::new(0.0, height, body.centre),
            hangs,
            outward,
            turn,
            lean: 0.0,
        };
        let arm = |side: f64, outward: f64, turn: f64| Self {
            axis: Vector3::new(side * body.arm[0], body.arm[1], body.centre),
            lean: side * ARM_SPREAD,
            ..spot(0.0, true, outward, Some(turn))
        };
        match anchor {
            PlacementAnchor::TorsoFront => spot(body.shoulder, true, 0.0, None),
            PlacementAnchor::TorsoBack => spot(body.shoulder, true, PI, None),
            PlacementAnchor::SkirtFront => spot(body.waist, true, 0.0, None),
            PlacementAnchor::SkirtBack => spot(body.waist, true, PI, None),
            PlacementAnchor::Waist => spot(body.waist, false, 0.0, Some(1.0)),
            PlacementAnchor::WaistFront => spot(body.waist, false, 0.0, Some(0.5)),
            PlacementAnchor::WaistBack => spot(body.waist, false, PI, Some(0.5)),
            PlacementAnchor::Neck => spot(body.neck, false, 0.0, Some(1.0)),
            PlacementAnchor::NeckFront => spot(body.neck, false, 0.0, Some(0.5)),
            PlacementAnchor::NeckBack => spot(body.neck, false, PI, Some(0.5)),
            PlacementAnchor::ArmLeft => arm(1.0, FRAC_PI_2, 1.0),
            PlacementAnchor::ArmRight => arm(-1.0, -FRAC_PI_2, 1.0),
            PlacementAnchor::ArmLeftFront => arm(1.0, 0.0, 0.5),
            PlacementAnchor::ArmRightFront => arm(-1.0, 0.0, 0.5),
            PlacementAnchor::ArmLeftBack => arm(1.0, PI, 0.5),
            PlacementAnchor::ArmRightBack => arm(-1.0, PI, 0.5),
            PlacementAnchor::Origin => Self {
                axis: Vector3::zeros(),
                ..spot(0.0, true, 0.0, None)
            },
        }
    }
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
        Ok(Self { anchor, placement })
    }

    /// Places `panel`, whose side `face` is out, on `avatar`, or in free space without one.
    pub fn place(&self, panel: &Panel, face: Face, avatar: Option<&Avatar>) -> Placed {
        let Self { anchor, placement } = self;
        let body = avatar.map_or(NO_BODY, BodyKeyPoints::of);
        let spot = Spot::of(*anchor, &body);
        let up = Rotation2::new((90.0 - placement.up_deg.unwrap_or(90.0)).to_radians());
        let [[left, right], [bottom, top]] = bounds(panel, &up);
        let centre_y = 0.5 * (bottom + top);
        let wrap = placement.wrap.unwrap_or(match spot.turn {
            Some(_) => Wrap::Cylinder,
            None => Wrap::Flat,
        });
        let [rx, ry, rz] = placement.rotate_deg.map(f64::to_radians);
        let turn = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle);
        let mut placed = Placed {
            up,
            key: [0.5 * (left + right), if spot.hangs { top } else { bottom }],
            centre_y,
            sense: if face == Face::Up { 1.0 } else { -1.0 },
            outward: spot.outward,
            axis: spot.axis,
            radius: 0.0,
            wrap,
            lean: spot.lean,
            rotation: turn(Vector3::x(), rx) * turn(Vector3::y(), ry) * turn(Vector3::z(), rz),
            offset: Vector3::from(placement.offset_m),
        };
        if *anchor == PlacementAnchor::Origin {
            placed.key[1] = centre_y;
            placed.sense = 1.0;
            return placed;
        }
        let height = spot.axis.y;
        let span = [
            height + bottom - placed.key[1],
            height + top - placed.key[1],
        ];
        // Rolled, a panel meets itself at most; half a band covers half a turn.
        let around = (right - left) / (TAU * spot.turn.unwrap_or(1.0));
        placed.radius = if spot.lean == 0.0 {
            let reach = radius(avatar, body.centre, span, wrap) + CLEARANCE;
            if wrap == Wrap::Cylinder {
                reach.max(around)
            } else {
                reach
            }
        } else {
            around.max(CLEARANCE)
        };
        placed
    }
}

/// Returns the reach of the body from its axis between two heights \[m\]: to the front and back for
/// flat panels, all round for rolled ones.
fn radius(avatar: Option<&Avatar>, centre: f64, span: [f64; 2], wrap: Wrap) -> f64 {
    let Some(avatar) = avatar else {
        return CLEARANCE;
    };
    let mut reach: f64 = 0.0;
    let mut y = span[0];
    while y < span[1] + HEIGHT_STEP {
        if let Some([x, z]) = avatar.section_bounds(y.min(span[1])) {
            reach = reach.max(z[1] - centre).max(centre - z[0]);
            if wrap == Wrap::Cylinder {
                reach = reach.max(x[1]).max(-x[0]);
            }
        }
        y += HEIGHT_STEP;
    }
    reach
}

/// The points of a panel's outline in pattern coordinates \[m\].
fn outline(panel: &Panel) -> impl Iterator<Item = [f64; 2]> {
    let points = panel.edges.iter().flat_map(|edge| &edge.points);
    points.copied()
}

/// Bounding box of a panel turned by `up`: `[[min x, max x], [min y, max y]]` \[m\].
fn bounds(panel: &Panel, up: &Rotation2<f64>) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in outline(panel) {
        let turned = up * Vector2::from(point);
        for (bound, value) in bounds.iter_mut().zip(turned.iter()) {
            *bound = [bound[0].min(*value), bound[1].max(*value)];
        }
    }
    bounds
}

/// The key point that a panel's name speaks of.
fn guess(panel: &Panel) -> Option<PlacementAnchor> {
    let name = format!("{} {}", panel.id, panel.name).to_lowercase();
    let words: Vec<&str> = name.split(|c: char| !c.is_alphabetic()).collect();
    let any = |list: &[&str]| words.iter().any(|word| list.contains(word));
    let within = |list: &[&str]| list.iter().any(|part| name.contains(part));
    let back = any(&["back", "bk", "rear", "b"]) || within(&["back", "btorso"]);
    let front = any(&["front", "fr", "frt", "f"]) || within(&["front", "ftorso"]);
    let band = any(&["wb", "band", "waistband"]) || within(&["waistband"]);
    let skirt = within(&["skirt"]);
    // Which arm, which opening: a name alone does not tell, and "sleeve_f" must not pass for a
    // front.
    if within(&["sleeve", "collar", "cuff", "hood"]) {
        return None;
    }
    Some(match (band, skirt, front, back) {
        (true, _, true, false) => PlacementAnchor::WaistFront,
        (true, _, false, true) => PlacementAnchor::WaistBack,
        (true, ..) => PlacementAnchor::Waist,
        (false, true, _, true) => PlacementAnchor::SkirtBack,
        (false, true, _, false) => PlacementAnchor::SkirtFront,
        (false, false, true, false) => PlacementAnchor::TorsoFront,
        (false, false, false, true) => PlacementAnchor::TorsoBack,
        _ => return None,
    })
}

fn unknown(panel: &Panel) -> Faults {
    let pointer = format!("/panels/{}/placement", pointer_token(&panel.id));
    Fault::new(PlacementCode::Unknown, pointer, format!("the name of panel {} does not say where on the body it goes", panel.id))
        .fix("give \"at\": torso_front, torso_back, skirt_front, skirt_back, waist, waist_front, waist_back, neck, arm_left, arm_right or origin, or take suggested placements")
        .into()
}
