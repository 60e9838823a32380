//! A raw scene as a scene, once it has been checked.

use super::check;
use super::raw_scene::RawScene;
use crate::config::Limits;
use crate::fault::Faults;
use crate::mesh::{ClothMesh, PanelRange, Stitch};
use crate::scene::{Body, Membrane, Scene, Wind};
use nalgebra::Vector3;

impl RawScene {
    /// Checks everything and makes it a scene.
    ///
    /// # Errors
    /// All faults together, each with a JSON pointer: lists longer than `limits` allow or of unlike
    /// lengths, indices of no vertex, numbers that are not finite or have the wrong sign, springs
    /// and stitches from a vertex to itself, triangles without area or clockwise, a body without
    /// size or direction.
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
            body_hardness: 1.0,
            fixed_cloth: None,
            friction: self.friction,
            gravity: self.gravity_m_s2.into(),
            drag: self.drag_1_s,
            pins: self.pins,
            fixed_axis: self.fixed_axis,
            wind: self.wind_m_s.map(|velocity| Wind {
                velocity: velocity.into(),
                gust: 0.0,
            }),
            layers: vec![],
            carriers: vec![],
            self_contact: false,
        })
    }
}

/// The pieces of cloth, as far as the numbering tells them apart: a new one begins where no
/// triangle joins the vertices before to those after. `triangles` come in the order of their lowest
/// vertex.
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
