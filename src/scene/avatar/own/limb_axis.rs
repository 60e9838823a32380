//! The axis of a limb of a body of one's own, through the middles of its slices: joints lie beside
//! the middle, and muscles more so.

use super::super::TriangleMesh;
use super::super::limb::LimbAxis;
use super::super::slice::{Plane, middle_around};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Places between the first joint and the second one, as shares of the way: nearer to the first
/// one, a slice goes through the trunk.
const UPPER: [f64; 4] = [0.4, 0.6, 0.8, 1.0];
/// The same between the second and the third.
const LOWER: [f64; 3] = [0.33, 0.67, 1.0];

/// Returns the axis of the limb with these joints, from the first of them on.
pub(super) fn limb_axis(surface: &TriangleMesh, joints: [Vector3<f64>; 3]) -> LimbAxis {
    let mut axis = LimbAxis {
        joints,
        points: vec![joints[0]],
        radii: vec![],
    };
    for (piece, shares) in [(0, &UPPER[..]), (1, &LOWER[..])] {
        let way = joints[piece + 1] - joints[piece];
        for share in shares {
            let at = joints[piece] + way * *share;
            let slice = middle_around(surface, &Plane::normal_to(way.normalize(), at));
            let (middle, girth) = slice.unwrap_or((at, 0.0));
            axis.points.push(middle);
            axis.radii.push(girth / TAU);
        }
    }
    // Within the trunk as thick as beside it.
    axis.radii.insert(0, axis.radii[0]);
    axis
}

#[cfg(test)]
mod tests {
    use super::super::super::{DressForm, Limb, Limbs};
    use super::*;

    /// The arms of a form are straight round tubes; joints 20 mm in front of their axis give it
    /// back to a tenth of that: near the shoulder they are not quite round.
    #[test]
    fn joints_beside_the_middle_give_the_axis_in_the_middle() {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: true,
                legs: false,
            }),
            ..DressForm::default()
        };
        let avatar = form.build().expect("a body");
        let arm = avatar.limb(Limb::ArmLeft).expect("an arm");
        let moved = |along: f64| arm.at(along).0 + Vector3::z() * 0.02;
        let length = arm.length();
        let axis = limb_axis(
            &avatar.surface,
            [0.0, 0.5 * length, 0.95 * length].map(moved),
        );
        for point in &axis.points[1..] {
            let (joint, direction) = arm.at(0.0);
            let off = (point - joint) - direction * direction.dot(&(point - joint));
            assert!(off.norm() < 2e-3, "{off}");
        }
    }
}
