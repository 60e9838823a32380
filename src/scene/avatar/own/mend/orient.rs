//! Triangles of one sense: neighbors run along their common edge in opposite directions.

use super::edges::{EdgeUse, by_edge, edge_uses};
use crate::fault::{AvatarCode, Fault};
use crate::scene::avatar::TriangleMesh;

/// Rows of triangles of a fin, at most.
const FIN_ROWS: usize = 16;

/// Returns a piece with all triangles of the sense of the first.
///
/// # Errors
/// `avatar/not_manifold` at an edge of more than two triangles, or where the surface has one side
/// only.
pub(super) fn oriented(mut piece: TriangleMesh) -> Result<TriangleMesh, Fault> {
    let mut uses = edge_uses(&piece);
    if by_edge(&uses).any(|edge| edge.len() > 2) {
        piece = without_fins(piece);
        uses = edge_uses(&piece);
    }
    if let Some(edge) = by_edge(&uses).find(|edge| edge.len() > 2) {
        let detail = format!("{} triangles meet at the edge", edge.len());
        return Err(not_manifold(&piece, edge[0], &detail));
    }
    let mut neighbors = vec![[None; 3]; piece.triangles.len()];
    for edge in by_edge(&uses).filter(|edge| edge.len() == 2) {
        let is_same_sense = edge[0].ascends != edge[1].ascends;
        for (user, other) in [(0, 1), (1, 0)] {
            let slots = &mut neighbors[edge[user].triangle];
            if let Some(slot) = slots.iter_mut().find(|slot| slot.is_none()) {
                *slot = Some((edge[other].triangle, is_same_sense));
            }
        }
    }
    let turned = turned(&neighbors);
    for edge in by_edge(&uses).filter(|edge| edge.len() == 2) {
        let [a, b] = [edge[0], edge[1]].map(|u| u.ascends ^ turned[u.triangle]);
        if a == b {
            return Err(not_manifold(
                &piece,
                edge[0],
                "the surface has one side only",
            ));
        }
    }
    for (triangle, is_turned) in piece.triangles.iter_mut().zip(turned) {
        if is_turned {
            triangle.swap(1, 2);
        }
    }
    Ok(piece)
}

/// Returns which triangles have to be turned, going from neighbor to neighbor.
fn turned(neighbors: &[[Option<(usize, bool)>; 3]]) -> Vec<bool> {
    let mut turned: Vec<Option<bool>> = vec![None; neighbors.len()];
    let mut stack = Vec::new();
    for first in 0..neighbors.len() {
        if turned[first].is_none() {
            turned[first] = Some(false);
            stack.push(first);
        }
        while let Some(t) = stack.pop() {
            let own = turned[t].unwrap_or(false);
            for (next, is_same_sense) in neighbors[t].iter().flatten() {
                if turned[*next].is_none() {
                    turned[*next] = Some(own == *is_same_sense);
                    stack.push(*next);
                }
            }
        }
    }
    turned.into_iter().map(|t| t.unwrap_or(false)).collect()
}

/// Returns a piece without the triangles that stand out of it like fins: free on one edge at
/// least, and at an edge of more than two triangles.
fn without_fins(mut piece: TriangleMesh) -> TriangleMesh {
    for _ in 0..FIN_ROWS {
        let uses = edge_uses(&piece);
        let mut is_free = vec![false; piece.triangles.len()];
        let mut is_crowded = vec![false; piece.triangles.len()];
        for edge in by_edge(&uses) {
            for user in edge {
                is_free[user.triangle] |= edge.len() == 1;
                is_crowded[user.triangle] |= edge.len() > 2;
            }
        }
        let before = piece.triangles.len();
        let mut place = 0;
        piece.triangles.retain(|_| {
            place += 1;
            !(is_free[place - 1] && is_crowded[place - 1])
        });
        if piece.triangles.len() == before {
            break;
        }
    }
    piece
}

fn not_manifold(piece: &TriangleMesh, edge: EdgeUse, what: &str) -> Fault {
    let [a, b] = edge.ends.map(|v| piece.vertices[v]);
    let [x, y, z]: [f64; 3] = ((a + b) * 0.5).into();
    let detail = format!("{what} near ({x:.4}, {y:.4}, {z:.4}) of the file");
    Fault::new(AvatarCode::NotManifold, "", detail)
        .fix("make the surface one skin there: let two triangles meet at each edge")
}
