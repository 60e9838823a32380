//! The pieces of a surface that hang together: the body, and what a file has besides.

use super::edges::{by_edge, edge_uses};
use super::orient::oriented;
use super::weld::compact;
use crate::fault::{AvatarCode, Fault, Warning};
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Share of the area of the largest piece below which another one is left out: eyes, teeth,
/// lashes.
const SMALL: f64 = 0.01;
/// Share below which an open piece is left out: hair, a strap.
const SMALL_AND_OPEN: f64 = 0.25;

/// A piece of a surface.
struct Piece {
    triangles: Vec<[usize; 3]>,
    area: f64,
    is_open: bool,
}

/// Returns the largest piece of a surface, its triangles of one sense.
///
/// # Errors
/// `avatar/not_manifold`.
pub(in super::super) fn largest_piece(surface: &TriangleMesh) -> Result<TriangleMesh, Fault> {
    let mut pieces = pieces(surface);
    if pieces.is_empty() {
        return Err(Fault::new(AvatarCode::Empty, "", "no triangle has an area"));
    }
    oriented(compact(&surface.vertices, &pieces.swap_remove(0).triangles))
}

/// Returns the pieces of a surface that are part of the body as one surface, each of one sense;
/// with it what was left out.
///
/// # Errors
/// `avatar/not_manifold`.
pub(in super::super) fn main_pieces(
    surface: &TriangleMesh,
    warnings: &mut Vec<Warning>,
) -> Result<TriangleMesh, Fault> {
    let pieces = pieces(surface);
    let largest = pieces.first().map_or(0.0, |piece| piece.area);
    let mut kept = TriangleMesh::default();
    let mut left_out = Vec::new();
    for piece in pieces {
        let share = piece.area / largest;
        if share < SMALL || (piece.is_open && share < SMALL_AND_OPEN) {
            left_out.push(piece);
            continue;
        }
        let piece = oriented(compact(&surface.vertices, &piece.triangles))?;
        let first = kept.vertices.len();
        kept.vertices.extend(piece.vertices);
        let triangles = piece.triangles.into_iter();
        kept.triangles
            .extend(triangles.map(|t| t.map(|v| v + first)));
    }
    if !left_out.is_empty() {
        warnings.push(left_out_warning(&left_out));
    }
    Ok(kept)
}

fn left_out_warning(left_out: &[Piece]) -> Warning {
    let triangles: usize = left_out.iter().map(|piece| piece.triangles.len()).sum();
    let largest = left_out.iter().map(|piece| piece.area).fold(0.0, f64::max);
    let detail = format!(
        "{} separate pieces of {triangles} triangles were left out, the largest of {:.0} cm²: eyes, teeth, lashes or hair",
        left_out.len(),
        largest * 1e4
    );
    Warning::new(AvatarCode::LeftOut, "", detail)
}

/// The pieces of a surface, the largest first.
fn pieces(surface: &TriangleMesh) -> Vec<Piece> {
    let mut parent: Vec<usize> = (0..surface.triangles.len()).collect();
    let uses = edge_uses(surface);
    for edge in by_edge(&uses) {
        for pair in edge.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|u| root(&mut parent, u.triangle));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut is_open = vec![false; surface.triangles.len()];
    for edge in by_edge(&uses).filter(|edge| edge.len() == 1) {
        is_open[root(&mut parent, edge[0].triangle)] = true;
    }
    let mut of_root = vec![Vec::new(); surface.triangles.len()];
    for t in 0..surface.triangles.len() {
        of_root[root(&mut parent, t)].push(surface.triangles[t]);
    }
    let found = of_root.into_iter().zip(is_open);
    let found = found.filter(|(triangles, _)| !triangles.is_empty());
    let mut pieces: Vec<_> = found
        .map(|(triangles, is_open)| Piece {
            area: area(&surface.vertices, &triangles),
            triangles,
            is_open,
        })
        .filter(|piece| piece.area > 0.0)
        .collect();
    pieces.sort_by(|a, b| b.area.total_cmp(&a.area));
    pieces
}

/// Area of triangles \[m²\].
fn area(vertices: &[Vector3<f64>], triangles: &[[usize; 3]]) -> f64 {
    let doubled = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| vertices[v]);
        (b - a).cross(&(c - a)).norm()
    });
    0.5 * doubled.sum::<f64>()
}

/// The lowest triangle that hangs together with `t`.
fn root(parent: &mut [usize], mut t: usize) -> usize {
    while parent[t] != t {
        parent[t] = parent[parent[t]];
        t = parent[t];
    }
    t
}
