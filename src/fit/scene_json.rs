//! The assembled scene in neutral JSON, for other simulators; made only where it is asked for.

use super::resolve::ResolvedGarment;
use super::run;
use crate::fault::Faults;
use crate::pattern::Point2;
use crate::scene::{Body, FixedCloth, Scene};
use crate::solver::{self, Context};
use nalgebra::Vector3;
use serde::Serialize;

/// Writes the scene of a resolved garment before anything moves, in the format `seamster/scene/1`.
/// SI units, y up.
///
/// # Errors
/// As [`run`](super::run()).
pub fn scene_json(garment: &ResolvedGarment, context: &Context<'_>) -> Result<Vec<u8>, Faults> {
    let scene = run::scene(garment, context)?;
    let json = serde_json::to_vec(&SceneJson::of(&scene));
    Ok(json.expect("lists of numbers always serialize"))
}

/// The file, its fields in the order in which they are written.
#[derive(Serialize)]
struct SceneJson<'a> {
    schema: &'static str,
    /// Positions of the vertices at the start \[m\].
    vertices: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\].
    rest_positions: &'a [Point2],
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
    collider: Option<SceneJsonBody<'a>>,
    /// Cloth worn beneath, which does not move.
    over: Option<SceneJsonFixedCloth<'a>>,
    wind: Option<SceneJsonWind>,
}

/// The body as triangles.
#[derive(Serialize)]
struct SceneJsonBody<'a> {
    vertices: Vec<[f64; 3]>,
    triangles: &'a [[usize; 3]],
}

/// Cloth that does not move as triangles.
#[derive(Serialize)]
struct SceneJsonFixedCloth<'a> {
    vertices: Vec<[f64; 3]>,
    triangles: &'a [[usize; 3]],
    /// At each vertex \[m\].
    thickness_m: &'a [f64],
    /// Coulomb coefficient at each vertex.
    friction: &'a [f64],
}

impl<'a> From<&'a FixedCloth> for SceneJsonFixedCloth<'a> {
    fn from(cloth: &'a FixedCloth) -> Self {
        Self {
            vertices: triples(&cloth.vertices),
            triangles: &cloth.triangles,
            thickness_m: &cloth.thickness_m,
            friction: &cloth.friction,
        }
    }
}

/// Moving air, as the garment states it.
#[derive(Serialize)]
struct SceneJsonWind {
    velocity_m_s: [f64; 3],
    gust: f64,
}

impl<'a> SceneJson<'a> {
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
            collider: avatar.map(|avatar| SceneJsonBody {
                vertices: triples(&avatar.surface.vertices),
                triangles: &avatar.surface.triangles,
            }),
            over: scene.fixed_cloth.as_deref().map(SceneJsonFixedCloth::from),
            wind: scene.wind.map(|wind| SceneJsonWind {
                velocity_m_s: wind.velocity.into(),
                gust: wind.gust,
            }),
        }
    }
}

fn triples(points: &[Vector3<f64>]) -> Vec<[f64; 3]> {
    points.iter().map(|point| (*point).into()).collect()
}
