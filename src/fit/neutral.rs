//! The assembled scene in neutral JSON, for other simulators; made only where it is asked for.

use super::prepare::Prepared;
use super::run;
use crate::fault::Faults;
use crate::scene::{Body, Scene};
use crate::solver::{self, Context};
use nalgebra::Vector3;
use serde::Serialize;

/// A prepared garment's scene before anything moves: the format `seamster/scene/1` as bytes. SI units, y up.
///
/// # Errors
/// As [`run`](super::run()).
pub fn scene_json(prepared: &Prepared, context: &Context<'_>) -> Result<Vec<u8>, Faults> {
    let scene = run::scene(prepared, context)?;
    let json = serde_json::to_vec(&Neutral::of(&scene));
    Ok(json.expect("lists of numbers always serialise"))
}

/// Its fields in the order in which they are written.
#[derive(Serialize)]
struct Neutral<'a> {
    schema: &'static str,
    /// Where the vertices start \[m\].
    vertices: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\].
    rest_positions: &'a [[f64; 2]],
    triangles: &'a [[usize; 3]],
    /// Two vertices, rest length \[m\], stiffness \[N/m\].
    springs: Vec<(usize, usize, f64, f64)>,
    /// Vertices that are sewn together.
    stitches: Vec<[usize; 2]>,
    /// \[kg\]
    masses: &'a [f64],
    /// Vertices that do not move.
    pins: &'a [usize],
    /// \[m/s^2\]
    gravity: [f64; 3],
    friction: f64,
    collider: Option<Collider<'a>>,
    wind: Option<Wind>,
}

/// The body as triangles.
#[derive(Serialize)]
struct Collider<'a> {
    vertices: Vec<[f64; 3]>,
    triangles: &'a [[usize; 3]],
}

/// Moving air, as the garment says it.
#[derive(Serialize)]
struct Wind {
    velocity_m_s: [f64; 3],
    gust: f64,
}

impl<'a> Neutral<'a> {
    fn of(scene: &'a Scene) -> Self {
        let avatar = scene.body.as_ref().and_then(Body::avatar);
        Self {
            schema: "seamster/scene/1",
            vertices: triples(&scene.start),
            rest_positions: &scene.mesh.uv,
            triangles: &scene.mesh.triangles,
            springs: solver::springs(scene),
            stitches: scene.mesh.stitches.iter().map(|s| [s.a, s.b]).collect(),
            masses: &scene.mass,
            pins: &scene.pins,
            gravity: scene.gravity.into(),
            friction: scene.friction,
            collider: avatar.map(|avatar| Collider {
                vertices: triples(&avatar.surface.vertices),
                triangles: &avatar.surface.triangles,
            }),
            wind: scene.wind.map(|wind| Wind {
                velocity_m_s: wind.velocity.into(),
                gust: wind.gust,
            }),
        }
    }
}

fn triples(points: &[Vector3<f64>]) -> Vec<[f64; 3]> {
    points.iter().map(|point| (*point).into()).collect()
}
