//! The joints of the legs, in the middles of their level slices.

use super::level::{LevelLoop, loops_at};
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Height of the joint of the knee as a share of that of the crotch.
const KNEE: f64 = 0.604;
/// Height of the joint of the ankle as a share of the height of a person, and that of the slice in
/// whose middle it is, above the instep.
const ANKLE: f64 = 0.0425;
const ABOVE_INSTEP: f64 = 0.055;
/// Height of the joint of the hip above the crotch as a share of the same, and its place between
/// the middle and the side of the hip.
const HIP_ABOVE: f64 = 0.052;
const HIP_ASIDE: f64 = 0.56;
/// Distance of the joint of the hip behind that of the knee, as a share of the height.
const HIP_BEHIND: f64 = 0.019;

/// Finds the joints of hip, knee and ankle of a leg on the side `sign` of x.
pub(super) fn joints(
    surface: &TriangleMesh,
    hip_side: &Vector3<f64>,
    (crotch, height, sign): (f64, f64, f64),
) -> Option<[Vector3<f64>; 3]> {
    let knee = leg_at(surface, KNEE * crotch, sign)?.center();
    let hip = Vector3::new(
        HIP_ASIDE * hip_side.x,
        crotch + HIP_ABOVE * height,
        knee.z - HIP_BEHIND * height,
    );
    let mut ankle = leg_at(surface, ABOVE_INSTEP * height, sign)?.center();
    ankle.y = ANKLE * height;
    Some([hip, knee, ankle])
}

/// The largest loop on a side: below the crotch, a hand is smaller.
pub(super) fn leg_at(surface: &TriangleMesh, y: f64, sign: f64) -> Option<LevelLoop> {
    let own = loops_at(surface, y)
        .into_iter()
        .filter(|found| found.center().x * sign > 0.0);
    own.max_by(|a, b| a.area.total_cmp(&b.area))
}
