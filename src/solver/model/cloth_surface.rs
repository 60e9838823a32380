//! The surface by which cloth touches cloth: that of the garment, and that of cloth which does not
//! move.

use crate::scene::{FixedCloth, Scene};
use crate::solver::forces::contact::{ClothSurface, LayerOrder};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::rest_shape::{cut_triangles, vertex_areas};
use crate::solver::model::seams::Seams;

/// Returns the surface of the cloth, at least `least_thickness` thick \[m\], and the area of each
/// of its particles and fixed vertices \[m²\].
pub(crate) fn cloth_surface(
    scene: &Scene,
    dof_map: &DofMap,
    least_thickness: f64,
) -> (ClothSurface, Vec<f64>) {
    let whole = Seams::Welded.dof_map(scene);
    let mut welded = vec![0; dof_map.count];
    for (&particle, &of_whole) in dof_map.of_vertex.iter().zip(&whole.of_vertex) {
        welded[particle] = of_whole;
    }
    let mut thickness = vec![least_thickness; dof_map.count];
    for (t, fabric, _) in cut_triangles(scene) {
        for particle in t.map(|v| dof_map.of_vertex[v]) {
            thickness[particle] = thickness[particle].max(fabric.thickness_m);
        }
    }
    let mut surface = ClothSurface {
        triangles: dof_map.triangles(&scene.mesh.triangles),
        welded,
        rest_edges: rest_edges(scene, dof_map),
        thickness,
        fixed: vec![],
        order: layer_order(scene),
    };
    let mut area = dof_map.sum(&vertex_areas(scene));
    if let Some(fixed) = &scene.fixed_cloth {
        add_fixed(fixed, least_thickness, &mut surface);
        area.extend(fixed.vertex_areas());
    }
    (surface, area)
}

/// Returns the order of the layers on the body: that of panels, and cloth that does not move
/// beneath all of them; none if there is neither or no body.
fn layer_order(scene: &Scene) -> Option<LayerOrder> {
    let fixed = scene.fixed_cloth.as_ref();
    if scene.layers.is_empty() && fixed.is_none() {
        return None;
    }
    let panels = scene.mesh.panels.iter().enumerate();
    let layer = panels.flat_map(|(i, panel)| {
        let layer = scene.layers.get(i).map_or(0, |layer| *layer);
        std::iter::repeat_n(layer + 1, panel.triangles.len())
    });
    let beneath = fixed.map_or(0, |fixed| fixed.triangles.len());
    Some(LayerOrder {
        layer: layer.chain(std::iter::repeat_n(0, beneath)).collect(),
        body: scene.body.clone()?,
    })
}

/// Adds cloth that does not move, its vertices numbered after the particles.
fn add_fixed(fixed: &FixedCloth, least_thickness: f64, surface: &mut ClothSurface) {
    let particles = surface.welded.len();
    let triangles = fixed.triangles.iter();
    let triangles = triangles.map(|t| t.map(|v| v + particles));
    surface.triangles.extend(triangles);
    // Nothing of it is stitched to anything that moves.
    let vertices = particles..particles + fixed.vertices.len();
    surface.welded.extend(vertices);
    let thickness = fixed.thickness_m.iter();
    let thickness = thickness.map(|of_fabric| of_fabric.max(least_thickness));
    surface.thickness.extend(thickness);
    surface.fixed.clone_from(&fixed.vertices);
}

/// Returns the coefficient of friction of the cloth at each particle and fixed vertex, the least of
/// its fabrics'; none if the garment has no friction, whatever is beneath it.
pub(crate) fn layer_friction(scene: &Scene, dof_map: &DofMap) -> Option<Vec<f64>> {
    if scene.fabrics.iter().all(|fabric| fabric.friction == 0.0) {
        return None;
    }
    let mut coefficient = vec![f64::INFINITY; dof_map.count];
    for (t, fabric, _) in cut_triangles(scene) {
        for particle in t.map(|v| dof_map.of_vertex[v]) {
            coefficient[particle] = coefficient[particle].min(fabric.friction);
        }
    }
    let fixed = scene.fixed_cloth.iter();
    coefficient.extend(fixed.flat_map(|fixed| &fixed.friction));
    Some(coefficient)
}

/// Returns the edges of the mesh between particles, with their rest lengths \[m\].
fn rest_edges(scene: &Scene, dof_map: &DofMap) -> Vec<(usize, usize, f64)> {
    let edges = scene
        .mesh
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let rest = |(a, b): (usize, usize)| {
        let [p, q] = [a, b].map(|v| scene.mesh.uv[v]);
        let length = (p[0] - q[0]).hypot(p[1] - q[1]);
        (dof_map.of_vertex[a], dof_map.of_vertex[b], length)
    };
    edges.map(rest).collect()
}
