//! A scene from its parts.

use super::carriers::carriers;
use super::{Body, Cut, Fabric, Membrane, Placed, Scene};
use crate::mesh::ClothMesh;
use nalgebra::Vector3;

/// Parts of a scene.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The mesh of all panels.
    pub mesh: ClothMesh,
    /// Cut and start of each panel, in the mesh's order.
    pub panels: Vec<PanelParts>,
    /// Fabrics in use.
    pub fabrics: Vec<Fabric>,
    /// The body, if there is one.
    pub body: Option<Body>,
    /// Coulomb coefficient against the body; that of the smoothest fabric in use if absent.
    pub friction: Option<f64>,
    /// Vertices that do not move.
    pub pins: Vec<usize>,
}

/// Cut and start of one panel.
#[derive(Clone, Debug)]
pub struct PanelParts {
    /// Cut of the panel from its fabric.
    pub cut: Cut,
    /// Placement at the start.
    pub placed: Placed,
}

/// Gravity at the standard value, downwards \[m/s²\].
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.80665, 0.0);

/// Puts every vertex at its start and gives it its share of the cloth's mass: a third of each of
/// its triangles.
pub fn build(parts: Parts) -> Scene {
    let Parts {
        mesh,
        panels,
        fabrics,
        body,
        friction,
        pins,
    } = parts;
    let mut start = vec![Vector3::zeros(); mesh.uv.len()];
    let mut mass = vec![0.0; mesh.uv.len()];
    for (range, panel) in mesh.panels.iter().zip(&panels) {
        let density = fabrics[panel.cut.fabric].density_kg_m2;
        for v in range.vertices.clone() {
            start[v] = panel.placed.position(mesh.uv[v]);
        }
        for triangle in &mesh.triangles[range.triangles.clone()] {
            let [p, q, r] = triangle.map(|v| mesh.uv[v]);
            let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
            for &v in triangle {
                mass[v] += density * area / 3.0;
            }
        }
    }
    let avatar = body.as_ref().and_then(Body::avatar);
    let carriers = avatar.map(|avatar| carriers(&mesh, &start, avatar));
    let carriers = carriers.unwrap_or_default();
    let friction = friction.unwrap_or_else(|| {
        fabrics
            .iter()
            .map(|f| f.friction)
            .fold(f64::INFINITY, f64::min)
    });
    let cut = panels.into_iter().map(|panel| panel.cut).collect();
    Scene {
        mesh,
        start,
        mass,
        fabrics,
        cut,
        membrane: Membrane::Fabric,
        least_bending_n_m: 0.0,
        body,
        body_hardness: 1.0,
        fixed_cloth: None,
        friction,
        gravity: GRAVITY,
        drag: None,
        pins,
        fixed_axis: None,
        wind: None,
        layers: vec![],
        carriers,
        self_contact: true,
    }
}
