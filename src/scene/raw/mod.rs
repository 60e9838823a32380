//! A scene without a garment: particles, springs, stitches and pins as another simulator would state them.
//!
//! SI units. Springs are linear, energy k/2 (|xa - xb| - rest)², and are all the membrane there is: where there are
//! triangles they only say how much of the body a vertex covers and where penetration and strain are measured.

mod check;

use super::{Analytic, Body, Membrane, NetSpring, Scene, Wind};
use crate::config::Limits;
use crate::fault::Faults;
use crate::mesh::{ClothMesh, PanelRange, Stitch};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// A scene of particles and springs. Every length in metres, every index that of a vertex.
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
    /// Drag force over mass and velocity, the same for all vertices \[1/s\]; the method's own if absent. Rest shapes are the
    /// same with any.
    #[serde(default)]
    pub drag_1_s: Option<f64>,
    /// The coordinate in which nothing moves (0 x, 1 y, 2 z), for a problem in a plane.
    #[serde(default, rename = "held_axis")]
    pub fixed_axis: Option<usize>,
    /// Velocity of the air \[m/s\], steady; still if absent.
    #[serde(default)]
    pub wind_m_s: Option<[f64; 3]>,
}

impl RawScene {
    /// Checks everything and makes it a scene.
    ///
    /// # Errors
    /// All faults together, each with a JSON pointer: lists longer than `limits` allow or of unlike lengths, indices of no
    /// vertex, numbers that are not finite or have the wrong sign, springs and stitches from a vertex to itself, triangles
    /// without area or clockwise, a body without size or direction.
    pub fn into_scene(self, limits: &Limits) -> Result<Scene, Faults> {
        check::check(&self, limits)?;
        let vertex_count = self.start_m.len();
        let stitch = |&[a, b]: &[usize; 2]| Stitch {
            seam: 0,
            stage: 0,
            a,
            b,
        };
        let mut triangles = self.triangles;
        triangles.sort_by_key(|t| t.iter().copied().min());
        let mesh = ClothMesh {
            uv: if self.uv_m.is_empty() {
                vec![[0.0; 2]; vertex_count]
            } else {
                self.uv_m
            },
            panels: pieces(vertex_count, &triangles),
            triangles,
            stitches: self.stitches.iter().map(stitch).collect(),
        };
        Ok(Scene {
            mesh,
            start: self.start_m.into_iter().map(Vector3::from).collect(),
            mass: self.mass_kg,
            fabrics: Vec::new(),
            cut: Vec::new(),
            membrane: Membrane::Springs(self.springs),
            least_bending_n_m: 0.0,
            body: self.body.map(Body::Analytic),
            friction: self.friction,
            gravity: self.gravity_m_s2.into(),
            drag: self.drag_1_s,
            pins: self.pins,
            fixed_axis: self.fixed_axis,
            wind: self.wind_m_s.map(|velocity| Wind {
                velocity: velocity.into(),
                gust: 0.0,
            }),
        })
    }
}

/// The pieces of cloth, as far as the numbering tells them apart: a new one begins where no triangle joins the vertices
/// before to those after. `triangles` come in the order of their lowest vertex.
fn pieces(vertex_count: usize, triangles: &[[usize; 3]]) -> Vec<PanelRange> {
    let mut pieces: Vec<PanelRange> = vec![];
    let mut end = 0;
    for (index, triangle) in triangles.iter().enumerate() {
        let low = triangle.iter().copied().min().unwrap_or(0);
        if index == 0 || low >= end {
            let first = if index == 0 { 0 } else { low };
            pieces
                .iter_mut()
                .last()
                .into_iter()
                .for_each(|piece| piece.vertices.end = low);
            pieces.push(PanelRange {
                vertices: first..vertex_count,
                triangles: index..index,
                corners: vec![],
            });
        }
        end = end.max(triangle.iter().copied().max().map_or(0, |v| v + 1));
        pieces
            .iter_mut()
            .last()
            .into_iter()
            .for_each(|piece| piece.triangles.end = index + 1);
    }
    if pieces.is_empty() {
        pieces.push(PanelRange {
            vertices: 0..vertex_count,
            triangles: 0..0,
            corners: vec![],
        });
    }
    pieces
}
