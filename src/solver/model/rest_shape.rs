//! The rest shape of a scene: its triangles flat, in the coordinates of their cloth, and the area
//! of each vertex.

use crate::scene::{Fabric, Scene};

/// Mass per area of cloth of which only the mass is known \[kg/m²\]: a shirt's.
const TYPICAL_DENSITY: f64 = 0.2;

/// Returns the cloth area that each vertex stands for: a third of each of its triangles \[m²\];
/// guessed from its mass where there are none.
pub(crate) fn vertex_areas(scene: &Scene) -> Vec<f64> {
    if scene.mesh.triangles.is_empty() {
        return scene.mass.iter().map(|m| m / TYPICAL_DENSITY).collect();
    }
    let mut area = vec![0.0; scene.mesh.uv.len()];
    for triangle in &scene.mesh.triangles {
        let third = rest_area(triangle.map(|v| scene.mesh.uv[v])) / 3.0;
        for &v in triangle {
            area[v] += third;
        }
    }
    area
}

/// Returns the signed area of a triangle \[m²\], positive counter-clockwise.
pub(crate) fn rest_area([p, q, r]: [[f64; 2]; 3]) -> f64 {
    0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
}

/// Returns each triangle with the panel's fabric and its rest positions in warp-weft coordinates.
pub(crate) fn cut_triangles(
    scene: &Scene,
) -> impl Iterator<Item = ([usize; 3], &Fabric, [[f64; 2]; 3])> {
    scene
        .mesh
        .panels
        .iter()
        .zip(&scene.cut)
        .flat_map(move |(panel, cut)| {
            let (sin, cos) = cut.warp_angle.sin_cos();
            scene.mesh.triangles[panel.triangles.clone()]
                .iter()
                .map(move |t| {
                    let rest = t.map(|v| {
                        let [u, v] = scene.mesh.uv[v];
                        [u * cos + v * sin, v * cos - u * sin]
                    });
                    (*t, &scene.fabrics[cut.fabric], rest)
                })
        })
}

/// Returns each triangle with its fabric, if it has one, and its rest positions: in warp-weft
/// coordinates if it has.
pub(crate) fn rest_triangles(
    scene: &Scene,
) -> impl Iterator<Item = ([usize; 3], Option<&Fabric>, [[f64; 2]; 3])> {
    let cut = cut_triangles(scene).map(|(t, fabric, rest)| (t, Some(fabric), rest));
    let bare = scene.mesh.triangles.iter().filter(|_| scene.cut.is_empty());
    cut.chain(bare.map(|t| (*t, None, t.map(|v| scene.mesh.uv[v]))))
}
