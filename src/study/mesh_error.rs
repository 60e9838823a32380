//! Mesh errors: references on different meshes, compared at the same points of the pattern.

use super::plan::{MeshResult, StudyScene};
use crate::mesh::{ClothMesh, Locator};
use nalgebra::Vector3;

/// Returns for each mesh the RMS distance of its reference from that on the finest mesh that has
/// one \[m\], over its vertices (of a motion: over frames too); none on the finest itself, and
/// where there is nothing to compare.
pub(super) fn mesh_errors(scenes: &[StudyScene], results: &[MeshResult]) -> Vec<Option<f64>> {
    let is_comparable =
        |i: &usize| !results[*i].shapes.is_empty() && !scenes[*i].scene.mesh.triangles.is_empty();
    let size = |i: &usize| scenes[*i].scene.mesh.uv.len();
    let comparable = (0..results.len()).filter(is_comparable);
    let Some(finest) = comparable.max_by_key(size) else {
        return vec![None; results.len()];
    };
    let error = |i: usize| {
        if i == finest || !is_comparable(&i) {
            return None;
        }
        let (mesh, fine) = (&scenes[i].scene.mesh, &scenes[finest].scene.mesh);
        let weights = interpolation_weights(mesh, fine)?;
        rms_distance_to(&results[i].shapes, &results[finest].shapes, &weights)
    };
    (0..results.len()).map(error).collect()
}

/// Corners of a triangle with the weight of each.
type CornerWeights = [(usize, f64); 3];

/// Finds each vertex of `mesh` in a triangle of `fine`, if it lies in one; none if their panels
/// differ.
fn interpolation_weights(mesh: &ClothMesh, fine: &ClothMesh) -> Option<Vec<Option<CornerWeights>>> {
    if mesh.panels.len() != fine.panels.len() {
        return None;
    }
    let mut weights = vec![None; mesh.uv.len()];
    for (index, panel) in mesh.panels.iter().enumerate() {
        let locator = Locator::new(fine, index);
        for v in panel.vertices.clone() {
            weights[v] = locator.weights(mesh.uv[v]);
        }
    }
    Some(weights)
}

/// Returns the RMS distance between `shapes` and the points of `fine` at `weights` \[m\]; none if
/// there are none.
fn rms_distance_to(
    shapes: &[Vec<Vector3<f64>>],
    fine: &[Vec<Vector3<f64>>],
    weights: &[Option<CornerWeights>],
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
