//! A coarser mesh of the same panels: about a third of the vertices, all of them vertices of the
//! finer one.
//!
//! Outlines keep corners, ends of seams, and every other vertex between; the vertices of a stitch
//! stay or go together, so that stitches are carried down. Inside, a maximal independent set stays.
//! The rest is constrained Delaunay again.

mod choose;
mod weights;

use crate::mesh::boundary::Boundary;
use crate::mesh::cloth_mesh::{ClothMesh, PanelRange, Stitch, smallest_first};
use crate::mesh::delaunay::Domain;
use choose::Choice;
use std::ops::Range;

/// Meshes with fewer vertices are not made coarser.
const FEWEST: usize = 500;
/// A mesh that keeps more than this share of its vertices is not worth a level.
const LARGEST_SHARE: f64 = 0.7;

/// A coarser mesh and the interpolation from it to the finer one.
#[derive(Clone, Debug, PartialEq)]
pub struct CoarserMesh {
    /// The coarser mesh.
    pub mesh: ClothMesh,
    /// The finer vertex that each coarser one is; ascending.
    pub finer: Vec<usize>,
    /// For each finer vertex, the corners of the coarse triangle that it lies in (outside the
    /// coarse outline: of the nearest one) with its barycentric coordinates.
    pub weights: Vec<[(usize, f64); 3]>,
}

/// Returns the next coarser mesh that keeps the vertices `fixed` and the panels that are marked in
/// `whole`, all of them; `None` if there is none worth having.
///
/// A panel whose thinned outline would cross itself keeps all its vertices.
pub fn coarser(mesh: &ClothMesh, fixed: &[usize], whole: &[bool]) -> Option<CoarserMesh> {
    if mesh.uv.len() < FEWEST || mesh.triangles.is_empty() {
        return None;
    }
    let mut whole = whole.to_vec();
    loop {
        let mut choice = Choice::new(mesh, fixed, &whole);
        let panels: Vec<_> = (0..mesh.panels.len())
            .map(|panel| triangles(mesh, panel, &mut choice, whole[panel]))
            .collect();
        let refused: Vec<usize> = (0..panels.len()).filter(|&p| panels[p].is_none()).collect();
        if !refused.is_empty() {
            refused.into_iter().for_each(|panel| whole[panel] = true);
            continue;
        }
        let kept = choice.kept.iter().filter(|kept| **kept).count();
        let worth = kept as f64 <= LARGEST_SHARE * mesh.uv.len() as f64;
        return worth.then(|| renumbered(mesh, &choice, panels.into_iter().flatten().collect()));
    }
}

/// Returns the triangles between the kept vertices of a panel, in the finer mesh's numbering, and
/// deselects vertices that are in none of them. `None` if the thinned outline crosses itself, or
/// loses a vertex that must stay.
fn triangles(
    mesh: &ClothMesh,
    panel: usize,
    choice: &mut Choice,
    whole: bool,
) -> Option<Vec<[usize; 3]>> {
    let range = &mesh.panels[panel];
    if whole {
        return Some(mesh.triangles[range.triangles.clone()].to_vec());
    }
    let mut numbers = vec![];
    let mut rings: Vec<Range<usize>> = vec![];
    for ring in choice.rings[panel].iter().map(Vec::as_slice) {
        let first = numbers.len();
        numbers.extend(ring.iter().copied().filter(|&v| choice.kept[v]));
        rings.push(first..numbers.len());
    }
    if rings.iter().any(|ring| ring.len() < 3) {
        return None;
    }
    let points = |numbers: &[usize]| numbers.iter().map(|&v| mesh.uv[v]).collect::<Vec<_>>();
    let domain = Domain::new(&Boundary::of_rings(points(&numbers), rings)).ok()?;
    let inside: Vec<usize> = range
        .vertices
        .clone()
        .filter(|&v| choice.kept[v] && !choice.is_outline[v])
        .collect();
    let triangles = domain.triangles(&points(&inside));
    numbers.extend(&inside);
    let mut used = vec![false; numbers.len()];
    triangles.iter().flatten().for_each(|&v| used[v] = true);
    for (&v, _) in numbers.iter().zip(&used).filter(|(_, used)| !**used) {
        if choice.must_stay[v] {
            return None;
        }
        choice.kept[v] = false;
    }
    Some(
        triangles
            .into_iter()
            .map(|t| t.map(|v| numbers[v]))
            .collect(),
    )
}

/// The coarser mesh in its own numbering.
fn renumbered(mesh: &ClothMesh, choice: &Choice, panels: Vec<Vec<[usize; 3]>>) -> CoarserMesh {
    let finer: Vec<usize> = (0..mesh.uv.len()).filter(|&v| choice.kept[v]).collect();
    let mut number = vec![usize::MAX; mesh.uv.len()];
    finer.iter().enumerate().for_each(|(n, &v)| number[v] = n);
    let mut coarse = ClothMesh {
        uv: finer.iter().map(|&v| mesh.uv[v]).collect(),
        ..ClothMesh::default()
    };
    for (range, triangles) in mesh.panels.iter().zip(panels) {
        let first = coarse.triangles.len();
        let mut triangles: Vec<_> = triangles
            .into_iter()
            .map(|t| smallest_first(t.map(|v| number[v])))
            .collect();
        triangles.sort_unstable();
        coarse.triangles.append(&mut triangles);
        coarse.panels.push(PanelRange {
            vertices: finer.partition_point(|&v| v < range.vertices.start)
                ..finer.partition_point(|&v| v < range.vertices.end),
            triangles: first..coarse.triangles.len(),
            corners: range.corners.iter().map(|&v| number[v]).collect(),
        });
    }
    let both = |s: &&Stitch| choice.kept[s.a] && choice.kept[s.b];
    let stitch = |s: &Stitch| Stitch {
        a: number[s.a],
        b: number[s.b],
        ..*s
    };
    coarse.stitches = mesh.stitches.iter().filter(both).map(stitch).collect();
    let weights = weights::weights(mesh, &coarse, &number);
    CoarserMesh {
        mesh: coarse,
        finer,
        weights,
    }
}
