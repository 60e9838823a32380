//! Edges, each with the triangles that meet at it.

use crate::scene::avatar::TriangleMesh;

/// A triangle at an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct EdgeUse {
    /// Its lower and its higher vertex.
    pub(super) ends: [usize; 2],
    /// Index of the triangle.
    pub(super) triangle: usize,
    /// True if the triangle runs from the lower to the higher vertex.
    pub(super) ascends: bool,
}

/// Returns the uses of all edges, those of one edge side by side.
pub(super) fn edge_uses(surface: &TriangleMesh) -> Vec<EdgeUse> {
    let triangles = surface.triangles.iter().enumerate();
    let mut uses: Vec<_> = triangles
        .flat_map(|(triangle, &[a, b, c])| {
            [(a, b), (b, c), (c, a)].map(|(a, b)| EdgeUse {
                ends: [a.min(b), a.max(b)],
                triangle,
                ascends: a < b,
            })
        })
        .collect();
    uses.sort_unstable();
    uses
}

/// Returns the uses of each edge.
pub(super) fn by_edge(uses: &[EdgeUse]) -> impl Iterator<Item = &[EdgeUse]> {
    uses.chunk_by(|a, b| a.ends == b.ends)
}
