//! The openings of a garment: the closed edges of its cloth once the seams are closed.

use crate::mesh::ClothMesh;
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// An opening: neck, armhole, wrist, waist, hem.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Opening {
    /// Vertices along it, with both of each stitch.
    pub(super) vertices: Vec<usize>,
    /// Panels that it runs along, by their index, each once, in their order.
    pub(super) panels: Vec<usize>,
    /// Length along it on the pattern \[m\].
    pub(super) rest_m: f64,
}

/// An edge of one triangle alone, in the direction of that triangle.
#[derive(Clone, Copy, Debug)]
struct BorderEdge {
    from: usize,
    to: usize,
    panel: usize,
}

/// Returns the openings of a garment whose panels of `is_face_down` have their drawn side in.
///
/// Edges that end at a seam, as those of a patch pocket do, are no openings.
pub(super) fn openings(mesh: &ClothMesh, is_face_down: &[bool]) -> Vec<Opening> {
    let welded = weld(mesh);
    let mut leaving: BTreeMap<usize, Vec<BorderEdge>> = BTreeMap::new();
    for edge in border(mesh, is_face_down, &welded) {
        leaving.entry(welded[edge.from]).or_default().push(edge);
    }
    let mut found = vec![];
    while let Some((&first, _)) = leaving.first_key_value() {
        let mut way: Vec<BorderEdge> = vec![];
        let mut at = first;
        while let Some(edge) = take(&mut leaving, at, way.last().map(|edge| edge.panel)) {
            way.push(edge);
            at = welded[edge.to];
            // Where the edge of the cloth touches itself, the part that is closed is an opening.
            if let Some(start) = way.iter().position(|edge| welded[edge.from] == at) {
                found.push(opening(mesh, &way.split_off(start)));
            }
        }
    }
    found
}

/// Takes an edge that leaves `at`: one of the same panel where there is one, since where a patch
/// ends at the edge of a panel, that of the panel goes on.
fn take(
    leaving: &mut BTreeMap<usize, Vec<BorderEdge>>,
    at: usize,
    panel: Option<usize>,
) -> Option<BorderEdge> {
    let edges = leaving.get_mut(&at)?;
    let own = edges.iter().position(|edge| Some(edge.panel) == panel);
    let edge = edges.swap_remove(own.unwrap_or(0));
    if edges.is_empty() {
        leaving.remove(&at);
    }
    Some(edge)
}

fn opening(mesh: &ClothMesh, way: &[BorderEdge]) -> Opening {
    let mut vertices: Vec<usize> = way.iter().flat_map(|edge| [edge.from, edge.to]).collect();
    vertices.dedup();
    if vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    let mut panels: Vec<usize> = way.iter().map(|edge| edge.panel).collect();
    panels.sort_unstable();
    panels.dedup();
    let length = |edge: &BorderEdge| {
        let [from, to] = [edge.from, edge.to].map(|v| Vector2::from(mesh.uv[v]));
        (to - from).norm()
    };
    Opening {
        vertices,
        panels,
        rest_m: way.iter().map(length).sum(),
    }
}

/// Returns the edges that have a triangle on one side only when the seams are closed.
fn border(mesh: &ClothMesh, is_face_down: &[bool], welded: &[usize]) -> Vec<BorderEdge> {
    let mut edges = vec![];
    let mut beside: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let key = |a: usize, b: usize| {
        let (a, b) = (welded[a], welded[b]);
        [a.min(b), a.max(b)]
    };
    for (panel, (range, is_down)) in mesh.panels.iter().zip(is_face_down).enumerate() {
        for &[a, b, c] in &mesh.triangles[range.triangles.clone()] {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let (from, to) = if *is_down { (to, from) } else { (from, to) };
                *beside.entry(key(from, to)).or_default() += 1;
                edges.push(BorderEdge { from, to, panel });
            }
        }
    }
    edges.retain(|edge| {
        let key = key(edge.from, edge.to);
        beside[&key] == 1 && key[0] != key[1]
    });
    edges
}

/// Returns the vertex that each vertex is once its stitches are closed.
fn weld(mesh: &ClothMesh) -> Vec<usize> {
    let mut of: Vec<usize> = (0..mesh.uv.len()).collect();
    for stitch in &mesh.stitches {
        let (a, b) = (root(&mut of, stitch.a), root(&mut of, stitch.b));
        of[a.max(b)] = a.min(b);
    }
    (0..of.len()).map(|v| root(&mut of, v)).collect()
}

fn root(of: &mut [usize], mut v: usize) -> usize {
    while of[v] != v {
        of[v] = of[of[v]];
        v = of[v];
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{PanelRange, Stitch};

    /// A front and a back of two squares each, sewn along both sides; vertices counter-clockwise
    /// from bottom left.
    fn tube() -> ClothMesh {
        let squares = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        let corners = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]];
        let panel = |first: usize, triangles| PanelRange {
            vertices: first..first + 6,
            triangles,
            corners: vec![],
        };
        let stitches = [(0, 8), (5, 9), (2, 6), (3, 11)];
        let stitch = |(seam, (a, b)): (usize, (usize, usize))| Stitch {
            seam: seam / 2,
            stage: 0,
            a,
            b,
        };
        ClothMesh {
            uv: [squares, squares].concat(),
            triangles: [corners, corners.map(|t| t.map(|v| v + 6))].concat(),
            panels: vec![panel(0, 0..4), panel(6, 4..8)],
            stitches: stitches.into_iter().enumerate().map(stitch).collect(),
        }
    }

    #[test]
    fn a_tube_has_two_openings_along_both_panels() {
        let found = openings(&tube(), &[false, false]);
        let mut vertices: Vec<_> = found
            .iter()
            .map(|opening| sorted(&opening.vertices))
            .collect();
        vertices.sort();
        assert_eq!(vertices, [[0, 1, 2, 6, 7, 8], [3, 4, 5, 9, 10, 11]]);
        assert!(found.iter().all(|opening| opening.panels == [0, 1]));
        // Two units along the front and two along the back.
        assert!(found.iter().all(|opening| opening.rest_m == 4.0));
    }

    #[test]
    fn a_panel_alone_has_one() {
        let mut mesh = tube();
        mesh.stitches.clear();
        assert_eq!(openings(&mesh, &[false, true]).len(), 2);
    }

    #[test]
    fn the_edge_of_a_patch_is_none() {
        let mut mesh = tube();
        // A triangle on one of the front's, sewn to its diagonal.
        mesh.uv.extend([[0.0, 0.0], [1.0, 1.0], [0.2, 0.8]]);
        mesh.triangles.push([12, 13, 14]);
        mesh.panels.push(PanelRange {
            vertices: 12..15,
            triangles: 8..9,
            corners: vec![],
        });
        let patch = [(12, 0), (13, 4)].map(|(a, b)| Stitch {
            seam: 2,
            stage: 1,
            a,
            b,
        });
        mesh.stitches.extend(patch);
        let found = openings(&mesh, &[false; 3]);
        assert_eq!(found, openings(&tube(), &[false; 2]));
    }

    fn sorted(vertices: &[usize]) -> Vec<usize> {
        let mut sorted = vertices.to_vec();
        sorted.sort_unstable();
        sorted
    }
}
