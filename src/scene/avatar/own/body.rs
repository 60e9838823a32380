//! A body of one's own as it is kept: a closed surface and its landmarks.

use super::super::limb::Limb;
use super::super::{Avatar, LANDMARKS, TriangleMesh};
use super::limb_axis::limb_axis;
use crate::fault::{AvatarCode, Fault, Faults};
use crate::scene::triples::{positions_schema, triangles_schema};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// A body of one's own: y up, facing +z, its left at +x, on the floor at y = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct OwnBody {
    /// Positions \[m\]; `#V`.
    #[schema(schema_with = positions_schema)]
    pub vertices: Vec<[f64; 3]>,
    /// Corners of its triangles, counter-clockwise seen from outside; `#T`.
    #[schema(schema_with = triangles_schema)]
    pub triangles: Vec<[u32; 3]>,
    /// Named points of the body \[m\]. Those of the joints of a limb, `shoulder_joint_l`,
    /// `elbow_l`, `wrist_l` and `hip_joint_l`, `knee_l`, `ankle_l`, make its axis.
    pub landmarks: BTreeMap<String, [f64; 3]>,
}

/// Sum over the triangles of the sides of their boxes, at most \[m²\]; a body has some 10.
const SPREAD: f64 = 100.0;

/// Joints of a limb, from the trunk on.
const JOINTS: [(Limb, [&str; 3]); 4] = [
    (Limb::ArmLeft, ["shoulder_joint_l", "elbow_l", "wrist_l"]),
    (Limb::ArmRight, ["shoulder_joint_r", "elbow_r", "wrist_r"]),
    (Limb::LegLeft, ["hip_joint_l", "knee_l", "ankle_l"]),
    (Limb::LegRight, ["hip_joint_r", "knee_r", "ankle_r"]),
];

impl OwnBody {
    /// Makes the avatar.
    ///
    /// # Errors
    /// `avatar/...`: a surface that is not closed, landmarks that are missing or not on the body.
    pub fn build(&self) -> Result<Avatar, Faults> {
        Faults(self.landmark_faults()).or(())?;
        let mut avatar = Avatar::from_crossing_surface("own body", self.surface(), self.points())?;
        for (limb, names) in JOINTS {
            let points = names.map(|name| avatar.landmarks.get(name).copied());
            if let [Some(a), Some(b), Some(c)] = points {
                let axis = limb_axis(&avatar.surface, [a, b, c]);
                avatar.limbs.insert(limb, axis);
            }
        }
        Ok(avatar)
    }

    /// Returns what is wrong with its surface and its landmarks.
    pub(in super::super) fn check(&self) -> Vec<Fault> {
        let mut faults = self.landmark_faults();
        let surface = self.surface();
        faults.extend(surface.check());
        if faults.is_empty() {
            faults.extend(too_spread(&surface));
        }
        faults
    }

    fn surface(&self) -> TriangleMesh {
        let vertices = self.vertices.iter().map(|p| Vector3::from(*p));
        let triangles = self.triangles.iter().map(|t| t.map(|v| v as usize));
        TriangleMesh {
            vertices: vertices.collect(),
            triangles: triangles.collect(),
        }
    }

    fn points(&self) -> BTreeMap<String, Vector3<f64>> {
        let points = self.landmarks.iter();
        points
            .map(|(name, p)| (name.clone(), Vector3::from(*p)))
            .collect()
    }

    fn landmark_faults(&self) -> Vec<Fault> {
        let fault = |name: &str, detail: String| {
            let pointer = format!("/landmarks/{name}");
            Fault::new(AvatarCode::Landmark, pointer, detail)
                .fix("give all the landmarks of a body, with `_l` on its left at +x")
        };
        let absent = LANDMARKS
            .iter()
            .filter(|name| !self.landmarks.contains_key(**name));
        let mut faults: Vec<_> = absent
            .map(|name| fault(name, format!("the landmark {name} is missing")))
            .collect();
        for (name, p) in &self.landmarks {
            let is_far = !p.iter().all(|x| x.abs() <= 10.0);
            let is_swapped =
                (name.ends_with("_l") && p[0] < 0.0) || (name.ends_with("_r") && p[0] > 0.0);
            if is_far || is_swapped {
                let name = crate::fault::pointer_token(&name.chars().take(60).collect::<String>());
                let detail = format!("{name} is not on its side of the body");
                faults.push(fault(&name, detail));
            }
        }
        faults
    }
}

/// Returns the fault of a surface whose triangles cover more space than those of any body: the work
/// of its distances grows with that.
pub(super) fn too_spread(surface: &TriangleMesh) -> Option<Fault> {
    let boxes = (0..surface.triangles.len()).map(|t| {
        let [a, b, c] = surface.corners(t);
        let size = a.sup(&b).sup(&c) - a.inf(&b).inf(&c);
        size.x * size.y + size.y * size.z + size.z * size.x
    });
    let spread: f64 = boxes.sum();
    (spread > SPREAD).then(|| {
        let detail = format!(
            "the triangles' boxes have {spread:.0} m² of sides together; those of a body have some 10"
        );
        Fault::new(AvatarCode::TooLarge, "", detail)
            .fix("leave out what is inside or beside the body, and long thin triangles")
    })
}
