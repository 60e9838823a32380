//! Landmarks of the neck and the tips of the shoulders.

use super::found::{Found, Missing};
use super::level::trunk_at;
use crate::scene::avatar::TriangleMesh;
use crate::scene::avatar::head::is_head;
use crate::scene::avatar::slice::Plane;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// Distance between slices \[m\].
const STEP: f64 = 0.002;
/// Height over which the slope of the outline is taken \[m\].
const SPAN: f64 = 0.004;
/// Depth of the pit of the neck below its sides, as a share of the height of a person: it is that
/// of the joint of the collarbones.
const PIT: f64 = 0.0455;
/// Height above the armpits over which the neck is looked for, as a share of the same.
const REACH: f64 = 0.16;
/// Height of the sides of the neck, likewise.
const NECK_SIDE: f64 = 0.856;
/// Depth of the joint of the shoulder below its tip, and its distance out of the armpit, likewise:
/// under a level arm, and what is added with the square of the angle to a hanging one.
const JOINT_BELOW: f64 = 0.0315;
const JOINT_OUT: [f64; 2] = [-0.004, 0.0245];

/// Finds the landmarks of the neck, above the armpits; returns the height of the person, with a
/// head if the body has none.
pub(super) fn neck(
    surface: &TriangleMesh,
    (armpit, height): (f64, f64),
    found: &mut Found,
) -> Result<f64, Missing> {
    let missing = Missing("neck_side", "no neck above the shoulders");
    let mut narrowest = (f64::INFINITY, 0.0);
    let mut y = armpit;
    while y < armpit + REACH * height {
        if let Some(level) = trunk_at(surface, y) {
            let girth = level.girth();
            if girth < narrowest.0 {
                narrowest = (girth, y);
            }
        }
        y += STEP;
    }
    let sides = |y: f64| trunk_at(surface, y).map(|level| level.sides());
    let mut side = [None; 2];
    for (k, place) in side.iter_mut().enumerate() {
        let mut y = narrowest.1;
        let mut is_upright = false;
        while y > armpit {
            let (here, below) = (sides(y), sides(y - SPAN));
            let (here, below) = here.zip(below).ok_or(missing)?;
            // the top of a neck without a head is level too
            let is_outward = below[k].x.abs() - here[k].x.abs() > SPAN;
            if is_outward && is_upright {
                *place = Some(here[k]);
                break;
            }
            is_upright |= !is_outward;
            y -= 0.5 * STEP;
        }
    }
    let [Some(left), Some(right)] = side else {
        return Err(missing);
    };
    found.insert("neck_side_l".to_owned(), left);
    found.insert("neck_side_r".to_owned(), right);
    let side = (left + right) * 0.5;
    let height = if is_head(height - side.y, height) {
        height
    } else {
        side.y / NECK_SIDE
    };
    front_and_back(surface, &side, (height, narrowest.1), found)?;
    Ok(height)
}

/// The pit of the neck, and the point behind in the plane of the three.
fn front_and_back(
    surface: &TriangleMesh,
    side: &Vector3<f64>,
    (height, top): (f64, f64),
    found: &mut Found,
) -> Result<(), Missing> {
    let missing = Missing("neck_front", "no outline in the middle of the neck");
    let middle = |y: f64| trunk_at(surface, y).and_then(|level| level.middle());
    let [front, _] = middle(side.y - PIT * height).ok_or(missing)?;
    let slope = (side.y - front.y) / (side.z - front.z);
    // behind, the height above the plane grows on the way up
    let above = |back: &Vector3<f64>| back.y - front.y - slope * (back.z - front.z);
    let mut y = front.y;
    let mut last = None;
    while y < top + 2.0 * PIT * height {
        if let Some([_, back]) = middle(y) {
            if above(&back) >= 0.0 {
                found.insert("neck_front".to_owned(), front);
                found.insert("neck_back".to_owned(), last.unwrap_or(back));
                return Ok(());
            }
            last = Some(back);
        }
        y += STEP;
    }
    Err(Missing("neck_back", "no outline behind the neck"))
}

/// Finds the tip of a shoulder and its joint: on top of the body outward of the armpit.
pub(super) fn shoulder(
    surface: &TriangleMesh,
    armpit: &Vector3<f64>,
    (hand, height): (Option<Vector3<f64>>, f64),
) -> Option<[Vector3<f64>; 2]> {
    let arm = hand.map_or(-Vector3::y(), |hand| hand - armpit);
    let hanging = (-arm.y).atan2(arm.x.hypot(arm.z)) / FRAC_PI_2;
    let out = JOINT_OUT[0] + JOINT_OUT[1] * hanging.clamp(0.0, 1.0).powi(2);
    let x = armpit.x + out * height * armpit.x.signum();
    let plane = Plane {
        point: Vector3::new(x, 0.0, 0.0),
        across: Vector3::y(),
        along: Vector3::z(),
    };
    let loops = plane.loops(surface).into_iter().flatten();
    let near = loops.filter(|p| (armpit.y..armpit.y + REACH * height).contains(&p[0]));
    let [y, z] = near.max_by(|a, b| a[0].total_cmp(&b[0]))?;
    let joint = Vector3::new(x, y - JOINT_BELOW * height, 0.5 * (z + armpit.z));
    Some([Vector3::new(x, y, z), joint])
}
