//! Barycentric coordinates of the finer mesh's vertices in the coarser mesh.

use super::choose::neighbors;
use crate::mesh::cloth_mesh::ClothMesh;
use crate::mesh::locate::barycentric;

/// For each finer vertex the corners of its coarse triangle, with barycentric coordinates; `number`
/// is the coarse vertex that each finer one is, or `usize::MAX`.
pub(super) fn weights(
    mesh: &ClothMesh,
    coarse: &ClothMesh,
    number: &[usize],
) -> Vec<[(usize, f64); 3]> {
    let neighbors = neighbors(mesh);
    let mut around = vec![vec![]; coarse.uv.len()];
    for (index, triangle) in coarse.triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v].push(index));
    }
    let of = |v: usize| {
        if number[v] != usize::MAX {
            return [(number[v], 1.0), (number[v], 0.0), (number[v], 0.0)];
        }
        let mut candidates = vec![];
        let mut ring = vec![v];
        // Two rings nearly always hold the triangle; further ones are for outlines thinned a lot.
        for depth in 0..6 {
            ring = ring
                .iter()
                .flat_map(|&w| neighbors[w].iter().copied())
                .collect();
            ring.sort_unstable();
            ring.dedup();
            let kept = ring.iter().map(|&w| number[w]).filter(|&n| n != usize::MAX);
            candidates.extend(kept.flat_map(|n| around[n].iter().copied()));
            if depth >= 1 && !candidates.is_empty() {
                break;
            }
        }
        candidates.sort_unstable();
        candidates.dedup();
        let best = candidates
            .into_iter()
            .map(|t| {
                let corners = coarse.triangles[t];
                (
                    corners,
                    barycentric(mesh.uv[v], corners.map(|c| coarse.uv[c])),
                )
            })
            .max_by(|(_, p), (_, q)| smallest(p).total_cmp(&smallest(q)))
            .expect("each panel has a coarse triangle, and six rings reach one");
        [0, 1, 2].map(|i| (best.0[i], best.1[i]))
    };
    (0..mesh.uv.len()).map(of).collect()
}

fn smallest(weights: &[f64; 3]) -> f64 {
    weights.iter().copied().fold(f64::INFINITY, f64::min)
}
