//! Mesh errors: references on different meshes, compared at the same points of the pattern.

use super::run::{OnMesh, StudyScene};
use crate::mesh::{ClothMesh, Locator};
use nalgebra::Vector3;

/// For each mesh the RMS distance of its reference from that on the finest mesh that has one \[m\], over its vertices (of a motion:
/// over frames too); `None` on the finest itself, and where there is nothing to compare.
pub(super) fn mesh_errors(scenes: &[StudyScene], found: &[OnMesh]) -> Vec<Option<f64>> {
    let has =
        |i: &usize| !found[*i].shapes.is_empty() && !scenes[*i].scene.mesh.triangles.is_empty();
    let size = |i: &usize| scenes[*i].scene.mesh.uv.len();
    let Some(finest) = (0..found.len()).filter(has).max_by_key(size) else {
        return vec![None; found.len()];
    };
    let one = |i: usize| {
        if i == finest || !has(&i) {
            return None;
        }
        let (mesh, fine) = (&scenes[i].scene.mesh, &scenes[finest].scene.mesh);
        let weights = weights(mesh, fine)?;
        rms(&found[i].shapes, &found[finest].shapes, &weights)
    };
    (0..found.len()).map(one).collect()
}

/// Corners of a triangle and what each counts.
type Weights = [(usize, f64); 3];

/// Where each vertex of `mesh` lies in `fine`; `None` if their panels differ.
fn weights(mesh: &ClothMesh, fine: &ClothMesh) -> Option<Vec<Option<Weights>>> {
    if mesh.panels.len() != fine.panels.len() {
        return None;
    }
    let mut out = vec![None; mesh.uv.len()];
    for (index, panel) in mesh.panels.iter().enumerate() {
        let locator = Locator::new(fine, index);
        for v in panel.vertices.clone() {
            out[v] = locator.weights(mesh.uv[v]);
        }
    }
    Some(out)
}

fn rms(
    shapes: &[Vec<Vector3<f64>>],
    fine: &[Vec<Vector3<f64>>],
    weights: &[Option<Weights>],
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0_usize);
    for (shape, fine) in shapes.iter().zip(fine) {
        for (x, weights) in shape.iter().zip(weights) {
            let Some(weights) = weights else { continue };
            let there: Vector3<f64> = weights.iter().map(|(v, w)| fine[*v] * *w).sum();
            sum += (x - there).norm_squared();
            count += 1;
        }
    }
    (count > 0).then(|| (sum / count as f64).sqrt())
}
