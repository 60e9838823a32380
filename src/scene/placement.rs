//! Where each panel starts: its key point is put at a key point of the body, in front of it, behind it or round it (P7).

use super::Avatar;
use crate::fault::{Fault, Faults};
use crate::pattern::{Anchor, Panel, Placement, Wrap};
use crate::seam::Face;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::PI;

/// Room left between the body and a panel at the start \[m\].
const CLEARANCE: f64 = 0.03;
/// Steps in height at which the body is asked how wide it is \[m\].
const HEIGHT_STEP: f64 = 0.02;
/// Where a garment without a body starts: heights of shoulders and waist, half a depth \[m\].
const NO_BODY: Body = Body {
    shoulder: 1.4,
    waist: 1.05,
    centre: 0.0,
};

/// Heights of the key points of a body, and its middle in depth \[m\].
#[derive(Clone, Copy, Debug)]
struct Body {
    shoulder: f64,
    waist: f64,
    centre: f64,
}

impl Body {
    fn of(avatar: &Avatar) -> Self {
        let height =
            |name: &str, otherwise: f64| avatar.landmarks.get(name).map_or(otherwise, |p| p.y);
        let waist = height("waist_front", NO_BODY.waist);
        let centre = avatar
            .section_bounds(waist)
            .map_or(0.0, |[_, z]| 0.5 * (z[0] + z[1]));
        Self {
            shoulder: height("neck_side_l", NO_BODY.shoulder),
            waist,
            centre,
        }
    }
}

/// A panel to place.
#[derive(Clone, Copy, Debug)]
pub struct ToPlace<'a> {
    /// The panel.
    pub panel: &'a Panel,
    /// Which of its sides is out.
    pub face: Face,
    /// What was asked for it, or what its file says.
    pub asked: Option<&'a Placement>,
}

/// The way from pattern coordinates to the start position in space.
#[derive(Clone, Debug)]
pub struct Placed {
    key: [f64; 2],
    centre_y: f64,
    /// +1 where the drawn +x runs along increasing angle, -1 where it runs against it.
    sense: f64,
    /// Angle of the outward direction from +z towards +x \[rad\].
    outward: f64,
    /// Height of the key point and middle of the body \[m\].
    height: f64,
    centre: f64,
    /// Distance from the body's axis \[m\].
    radius: f64,
    wrap: Wrap,
    rotation: Rotation3<f64>,
    offset: Vector3<f64>,
}

impl Placed {
    /// Start position of the pattern point `uv` \[m\].
    pub fn position(&self, uv: [f64; 2]) -> Vector3<f64> {
        let middle = self.rolled(0.0, self.centre_y - self.key[1]);
        let p = self.rolled(self.sense * (uv[0] - self.key[0]), uv[1] - self.key[1]);
        middle + self.rotation * (p - middle) + self.offset
    }

    /// The point `along` the panel's width from its key point and `up` from it \[m\].
    fn rolled(&self, along: f64, up: f64) -> Vector3<f64> {
        let (angle, flat) = match self.wrap {
            Wrap::Flat => (self.outward, along),
            Wrap::Cylinder => (self.outward + along / self.radius, 0.0),
        };
        let (sin, cos) = angle.sin_cos();
        // Outward is (sin, 0, cos); (cos, 0, -sin) runs along increasing angle.
        Vector3::new(
            self.radius * sin + flat * cos,
            self.height + up,
            self.centre + self.radius * cos - flat * sin,
        )
    }
}

/// Places a panel on `avatar`, or in free space without one.
///
/// # Errors
/// `placement/unknown` at `/panels/<id>/placement` if neither a key point was asked for nor the panel's name says one.
pub fn place(to_place: ToPlace<'_>, avatar: Option<&Avatar>) -> Result<Placed, Faults> {
    let ToPlace { panel, face, asked } = to_place;
    let placement = asked.cloned().unwrap_or_default();
    let anchor = placement
        .at
        .or_else(|| guess(panel))
        .ok_or_else(|| unknown(panel))?;
    let body = avatar.map_or(NO_BODY, Body::of);
    let [[left, right], [bottom, top]] = bounds(panel);
    let [rx, ry, rz] = placement.rotate_deg.map(f64::to_radians);
    let turn = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle);
    let rotation = turn(Vector3::x(), rx) * turn(Vector3::y(), ry) * turn(Vector3::z(), rz);
    let offset = Vector3::from(placement.offset_m);
    if anchor == Anchor::Origin {
        let centre_y = 0.5 * (bottom + top);
        return Ok(Placed {
            key: [0.5 * (left + right), centre_y],
            centre_y,
            sense: 1.0,
            outward: 0.0,
            height: 0.0,
            centre: 0.0,
            radius: 0.0,
            wrap: Wrap::Flat,
            rotation,
            offset,
        });
    }
    let (height, key_y) = match anchor {
        Anchor::TorsoFront | Anchor::TorsoBack => (body.shoulder, top),
        Anchor::SkirtFront | Anchor::SkirtBack => (body.waist, top),
        Anchor::Waist | Anchor::WaistFront | Anchor::WaistBack => (body.waist, bottom),
        Anchor::Origin => (0.0, 0.0),
    };
    let behind = matches!(
        anchor,
        Anchor::TorsoBack | Anchor::SkirtBack | Anchor::WaistBack
    );
    let around = matches!(
        anchor,
        Anchor::Waist | Anchor::WaistFront | Anchor::WaistBack
    );
    let wrap = placement
        .wrap
        .unwrap_or(if around { Wrap::Cylinder } else { Wrap::Flat });
    let span = [height + bottom - key_y, height + top - key_y];
    Ok(Placed {
        key: [0.5 * (left + right), key_y],
        centre_y: 0.5 * (bottom + top),
        sense: if face == Face::Up { 1.0 } else { -1.0 },
        outward: if behind { PI } else { 0.0 },
        height,
        centre: body.centre,
        radius: radius(avatar, body.centre, span, wrap) + CLEARANCE,
        wrap,
        rotation,
        offset,
    })
}

/// How far the body reaches from its axis between two heights \[m\]: to the front and back for flat panels, all round for rolled ones.
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

/// Bounding box of a panel: `[[min x, max x], [min y, max y]]` \[m\].
fn bounds(panel: &Panel) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in panel.edges.iter().flat_map(|edge| &edge.points) {
        for (bound, value) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(*value), bound[1].max(*value)];
        }
    }
    bounds
}

/// The key point that a panel's name speaks of.
fn guess(panel: &Panel) -> Option<Anchor> {
    let name = format!("{} {}", panel.id, panel.name).to_lowercase();
    let words: Vec<&str> = name.split(|c: char| !c.is_alphabetic()).collect();
    let any = |list: &[&str]| words.iter().any(|word| list.contains(word));
    let within = |list: &[&str]| list.iter().any(|part| name.contains(part));
    let back = any(&["back", "bk", "rear", "b"]) || within(&["back", "btorso"]);
    let front = any(&["front", "fr", "frt", "f"]) || within(&["front", "ftorso"]);
    let band = any(&["wb", "band", "waistband"]) || within(&["waistband"]);
    let skirt = within(&["skirt"]);
    // No key points for these yet; "sleeve_f" must not pass for a front.
    if within(&["sleeve", "collar", "cuff", "hood"]) {
        return None;
    }
    Some(match (band, skirt, front, back) {
        (true, _, true, false) => Anchor::WaistFront,
        (true, _, false, true) => Anchor::WaistBack,
        (true, ..) => Anchor::Waist,
        (false, true, _, true) => Anchor::SkirtBack,
        (false, true, _, false) => Anchor::SkirtFront,
        (false, false, true, false) => Anchor::TorsoFront,
        (false, false, false, true) => Anchor::TorsoBack,
        _ => return None,
    })
}

fn unknown(panel: &Panel) -> Faults {
    let pointer = format!(
        "/panels/{}/placement",
        panel.id.replace('~', "~0").replace('/', "~1")
    );
    Fault::new("placement/unknown", pointer, format!("the name of panel {} does not say where on the body it goes", panel.id))
        .fix("give \"at\": torso_front, torso_back, skirt_front, skirt_back, waist, waist_front, waist_back or origin")
        .into()
}
