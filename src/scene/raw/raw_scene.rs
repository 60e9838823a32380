//! The raw scene as it is stated: lists of numbers, unchecked.

use crate::scene::{Analytic, NetSpring};
use serde::{Deserialize, Serialize};

/// A scene of particles and springs. Every length in meters, every index that of a vertex.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawScene {
    /// Position of each vertex at the start \[m\]; `#V`.
    pub start_m: Vec<[f64; 3]>,
    /// Mass of each vertex, above 0 \[kg\]; `#V`.
    pub mass_kg: Vec<f64>,
    /// Flat rest position of each vertex \[m\]; `#V`, or none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub uv_m: Vec<[f64; 2]>,
    /// Triangles, counter-clockwise in `uv_m`; `#T`, or none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub triangles: Vec<[usize; 3]>,
    /// Springs between vertices.
    #[serde(default)]
    pub springs: Vec<NetSpring>,
    /// Vertex pairs that are sewn together.
    #[serde(default)]
    pub stitches: Vec<[usize; 2]>,
    /// Vertices that do not move.
    #[serde(default)]
    pub pins: Vec<usize>,
    /// Body that the cloth falls on.
    #[serde(default)]
    pub body: Option<Analytic>,
    /// Coulomb coefficient against the body, 0 to 10.
    #[serde(default)]
    pub friction: f64,
    /// Acceleration, its direction being down \[m/s²\].
    pub gravity_m_s2: [f64; 3],
    /// Drag force over mass and velocity, the same for all vertices \[1/s\]; the method's own if
    /// absent. Rest shapes are the same with any.
    #[serde(default)]
    pub drag_1_s: Option<f64>,
    /// The coordinate in which nothing moves (0 x, 1 y, 2 z), for a problem in a plane.
    #[serde(default, rename = "held_axis")]
    pub fixed_axis: Option<usize>,
    /// Velocity of the air \[m/s\], steady; still if absent.
    #[serde(default)]
    pub wind_m_s: Option<[f64; 3]>,
}
