//! Landmarks found on the surface of an upright body: from its level slices, and along its limbs.
//!
//! What the shape shows is read from it: the loops of level slices part and join at crotch and
//! armpits, girths have their least and largest values, the outline of the neck its turn. What lies
//! beneath the skin, the joints, and the pit of the neck are put where they are in people as a
//! share of the body's own lengths.

mod arm;
mod found;
mod geodesic;
mod leg;
mod level;
mod neck;
mod trunk;

use crate::scene::avatar::TriangleMesh;
use geodesic::EdgeGraph;
use nalgebra::Vector3;

pub(super) use found::{Found, Missing};

/// Finds the landmarks of a body that stands on the floor, those in `given` from there; with them
/// the limbs that were not found.
///
/// # Errors
/// The first landmark of the trunk that was not found.
pub(super) fn find(
    surface: &TriangleMesh,
    given: &Found,
) -> Result<(Found, Vec<Missing>), Missing> {
    let height = surface.vertices.iter().map(|p| p.y).fold(0.0, f64::max);
    let mut found = Found::new();
    let crotch = match given.get("crotch") {
        Some(crotch) => *crotch,
        None => trunk::crotch(surface, height)?,
    };
    found.insert("crotch".to_owned(), crotch);
    let armpits = match pair(given, "armpit") {
        Some(armpits) => armpits,
        None => trunk::armpits(surface, crotch.y, height)?,
    };
    add_pair(&mut found, "armpit", armpits);
    let bust = match pair(given, "bust_point") {
        Some(points) => points,
        None => trunk::bust_points(surface, &armpits, height)?,
    };
    add_pair(&mut found, "bust_point", bust);
    let levels = (0.5 * (bust[0].y + bust[1].y), crotch.y);
    trunk::girth_levels(surface, levels, &mut found)?;
    let armpit = 0.5 * (armpits[0].y + armpits[1].y);
    let height = neck::neck(surface, (armpit, height), &mut found)?;
    let mut missing = Vec::new();
    limbs(surface, (&armpits, height), &mut found, &mut missing)?;
    found.extend(given.iter().map(|(name, p)| (name.clone(), *p)));
    Ok((found, missing))
}

/// Finds the tips of the shoulders, and the joints of the limbs that there are.
fn limbs(
    surface: &TriangleMesh,
    (armpits, height): (&[Vector3<f64>; 2], f64),
    found: &mut Found,
    missing: &mut Vec<Missing>,
) -> Result<(), Missing> {
    let no_tip = Missing("shoulder_tip", "no surface above the armpit");
    let crotch = found["crotch"].y;
    let graph = EdgeGraph::new(surface);
    let graph = (surface, &graph);
    let heights = (crotch, found["neck_side_l"].y, height);
    let hands = arm::hand_tips(graph, heights, &found["bust_front"]);
    for ((side, armpit), hand) in ["l", "r"].iter().zip(armpits).zip(hands) {
        let tip = hand.map(|v| surface.vertices[v]);
        let [tip, joint] = neck::shoulder(surface, armpit, (tip, height)).ok_or(no_tip)?;
        found.insert(format!("shoulder_tip_{side}"), tip);
        let arm = hand.and_then(|tip| arm::elbow_and_wrist(graph, (joint, tip), height));
        let Some([elbow, wrist]) = arm else {
            missing.push(Missing("wrist", "no arm was found along the skin"));
            continue;
        };
        found.insert(format!("shoulder_joint_{side}"), joint);
        found.insert(format!("elbow_{side}"), elbow);
        found.insert(format!("wrist_{side}"), wrist);
    }
    for (side, sign) in [("l", 1.0), ("r", -1.0)] {
        let hip = found[&format!("hip_side_{side}")];
        match leg::joints(surface, &hip, (crotch, height, sign)) {
            Some(joints) => {
                for (name, joint) in ["hip_joint", "knee", "ankle"].iter().zip(joints) {
                    found.insert(format!("{name}_{side}"), joint);
                }
            }
            None => missing.push(Missing("ankle", "no leg was found below the crotch")),
        }
    }
    Ok(())
}

fn pair(given: &Found, name: &str) -> Option<[Vector3<f64>; 2]> {
    let left = given.get(&format!("{name}_l"))?;
    let right = given.get(&format!("{name}_r"))?;
    Some([*left, *right])
}

fn add_pair(found: &mut Found, name: &str, [left, right]: [Vector3<f64>; 2]) {
    found.insert(format!("{name}_l"), left);
    found.insert(format!("{name}_r"), right);
}
