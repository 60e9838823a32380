//! Girths of a draped garment beside those of its body.

use super::places::{Place, limbs, parts};
use super::section::{Sections, level};
use crate::scene::{Body, Scene};
use nalgebra::Vector3;

/// Girth of the cloth at a place of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct MeasuredGirth {
    /// Name of the place.
    pub(in crate::fit) at: &'static str,
    /// Height of the plane that the girths are cut by \[m\].
    pub(in crate::fit) height_m: f64,
    /// Length of the cut through the cloth as it lies \[m\].
    pub(in crate::fit) cloth_m: f64,
    /// Girth of the body in that plane; of a thigh, across it \[m\].
    pub(in crate::fit) body_m: f64,
}

/// Returns the girths of a scene at `positions` \[m; `#V`\] where its cloth goes all round: bust,
/// waist, hip, upper arms and thighs; none without a body.
pub(in crate::fit) fn measured(scene: &Scene, positions: &[Vector3<f64>]) -> Vec<MeasuredGirth> {
    let Some(avatar) = scene.body.as_ref().and_then(Body::avatar) else {
        return vec![];
    };
    let parts = parts(scene);
    let levels = [
        ("bust", "bust_point_l"),
        ("waist", "waist_front"),
        ("hip", "hip_front"),
    ];
    let trunk = levels.into_iter().filter_map(|(name, landmark)| {
        let height = avatar.landmarks.get(landmark)?.y;
        Some(Place {
            name,
            cuts: vec![(level(height), avatar.girth_at(height)?)],
            panels: parts[0].clone(),
        })
    });
    let sections = Sections::new(scene);
    let girth = |place: Place| {
        place.cuts.iter().find_map(|(plane, body_m)| {
            let section = sections.of(*plane, &place.panels, positions);
            section.is_closed.then_some(MeasuredGirth {
                at: place.name,
                height_m: plane.point.y,
                cloth_m: section.shape_m,
                body_m: *body_m,
            })
        })
    };
    let places = trunk.chain(limbs(avatar, scene, &parts));
    places.filter_map(girth).collect()
}
