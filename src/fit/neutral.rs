//! The assembled scene in neutral JSON, for other simulators.

use crate::scene::{Body, Scene};
use crate::solver;
use serde_json::{Value, json};

/// Vertices (start), rest positions, triangles, springs `[i, j, rest length, stiffness]`, stitches, masses, pins and the
/// body as triangles; SI units, y up.
pub(super) fn scene_json(scene: &Scene) -> Value {
    let triple = |p: &nalgebra::Vector3<f64>| [p.x, p.y, p.z];
    let collider = scene.body.as_ref().and_then(Body::avatar).map(|avatar| {
        json!({
            "vertices": avatar.surface.vertices.iter().map(triple).collect::<Vec<_>>(),
            "triangles": avatar.surface.triangles,
        })
    });
    json!({
        "schema": "seamster/scene/1",
        "vertices": scene.start.iter().map(triple).collect::<Vec<_>>(),
        "rest_positions": scene.mesh.uv,
        "triangles": scene.mesh.triangles,
        "springs": solver::springs(scene),
        "stitches": scene.mesh.stitches.iter().map(|s| [s.a, s.b]).collect::<Vec<_>>(),
        "masses": scene.mass,
        "pins": scene.pins,
        "gravity": triple(&scene.gravity),
        "friction": scene.friction,
        "collider": collider,
    })
}
