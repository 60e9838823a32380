//! Borders of panels.

/// Returns the mesh edges that belong to one triangle only, each by its two vertices, in their
/// order.
pub(super) fn border_edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let edges = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<_> = edges.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    let alone = edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1);
    alone.map(|same| same[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn border_of_a_square_is_its_four_sides() {
        let edges = border_edges(&[[0, 1, 2], [0, 2, 3]]);
        assert_eq!(edges, [[0, 1], [0, 3], [1, 2], [2, 3]]);
    }

    #[test]
    fn closed_surface_has_no_border() {
        assert!(border_edges(&[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).is_empty());
    }
}
