//! Selection of the vertices that stay in a coarser mesh.

use crate::mesh::cloth_mesh::ClothMesh;
use crate::mesh::geometry;
use crate::pattern::point::{self};
use std::collections::{BTreeMap, BTreeSet};

/// An outline that turns more than this at a vertex has a corner there \[cos\]: 30 degrees.
const STRAIGHT: f64 = 0.866;

/// The vertices that stay, and the topology found while selecting them.
pub(super) struct Choice {
    /// True for each vertex that stays.
    pub(super) kept: Vec<bool>,
    /// True for each vertex that may not go: a corner, an end of a seam, a pin.
    pub(super) must_stay: Vec<bool>,
    /// True for each vertex on an outline or the edge of a hole.
    pub(super) is_outline: Vec<bool>,
    /// For each panel its closed rings of vertices, the outline first.
    pub(super) rings: Vec<Vec<Vec<usize>>>,
}

impl Choice {
    /// Selects the vertices; panels marked `whole` keep every vertex.
    pub(super) fn new(mesh: &ClothMesh, fixed: &[usize], whole: &[bool]) -> Self {
        let count = mesh.uv.len();
        let mut choice = Self {
            kept: vec![false; count],
            must_stay: vec![false; count],
            is_outline: vec![false; count],
            rings: (0..mesh.panels.len()).map(|p| rings(mesh, p)).collect(),
        };
        for &v in choice.rings.iter().flatten().flatten() {
            choice.is_outline[v] = true;
        }
        let class = classes(mesh);
        choice.fix(mesh, fixed, whole);
        choice.fix_seam_ends(mesh, &class);
        let mut class_stays = vec![false; count];
        for v in (0..count).filter(|&v| choice.must_stay[v]) {
            class_stays[class[v]] = true;
        }
        for v in 0..count {
            choice.must_stay[v] = class_stays[class[v]];
        }
        choice.thin_outlines(&class);
        choice.thin_inside(mesh);
        choice
    }

    /// Corners, pins, vertices sewn inside a panel, and whole panels.
    fn fix(&mut self, mesh: &ClothMesh, fixed: &[usize], whole: &[bool]) {
        fixed.iter().for_each(|&v| self.must_stay[v] = true);
        for (panel, range) in mesh.panels.iter().enumerate() {
            range.corners.iter().for_each(|&v| self.must_stay[v] = true);
            if whole[panel] {
                self.must_stay[range.vertices.clone()].fill(true);
            }
        }
        for stitch in &mesh.stitches {
            for v in [stitch.a, stitch.b] {
                self.must_stay[v] |= !self.is_outline[v];
            }
        }
        for ring in self.rings.iter().flatten() {
            for (i, &v) in ring.iter().enumerate() {
                let before = mesh.uv[ring[(i + ring.len() - 1) % ring.len()]];
                let after = mesh.uv[ring[(i + 1) % ring.len()]];
                let (u, w) = (
                    point::sub(mesh.uv[v], before),
                    point::sub(after, mesh.uv[v]),
                );
                let cosine = (u[0] * w[0] + u[1] * w[1]) / (u[0].hypot(u[1]) * w[0].hypot(w[1]));
                self.must_stay[v] |= cosine < STRAIGHT;
            }
        }
    }

    /// Keeps the ends of seams: of two neighbors on an outline, one is sewn to a vertex beside
    /// which the other is not sewn.
    fn fix_seam_ends(&mut self, mesh: &ClothMesh, class: &[usize]) {
        let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for stitch in &mesh.stitches {
            for v in [stitch.a, stitch.b] {
                let list = members.entry(class[v]).or_default();
                if !list.contains(&v) {
                    list.push(v);
                }
            }
        }
        let mut beside = BTreeSet::new();
        for ring in self.rings.iter().flatten() {
            for (i, &v) in ring.iter().enumerate() {
                let w = ring[(i + 1) % ring.len()];
                beside.extend([[v, w], [w, v]]);
            }
        }
        let none = vec![];
        let of = |v: usize| members.get(&class[v]).unwrap_or(&none);
        for &[v, w] in &beside {
            // Every vertex sewn to `v` should have a neighbour on its outline that is sewn to `w`,
            // and none if `w` is not sewn.
            let goes_on = of(v)
                .iter()
                .all(|&a| of(w).iter().any(|&b| beside.contains(&[a, b])));
            self.must_stay[v] |= !of(v).is_empty() && !goes_on;
        }
    }

    /// Between vertices that must stay, every other one stays; what one side of a seam decides
    /// holds for the other.
    fn thin_outlines(&mut self, class: &[usize]) {
        let mut decided: Vec<Option<bool>> = vec![None; class.len()];
        for v in (0..class.len()).filter(|&v| self.must_stay[v]) {
            decided[class[v]] = Some(true);
        }
        for ring in self.rings.iter().flatten() {
            let start = ring.iter().position(|&v| decided[class[v]] == Some(true));
            let start = start.unwrap_or(0);
            let at = |i: usize| class[ring[(start + i) % ring.len()]];
            let mut last_kept = false;
            for i in 0..ring.len() {
                // An odd number of parts ends with a longer one, not with a shorter one.
                let before_fixed = i > 0 && self.must_stay[ring[(start + i + 1) % ring.len()]];
                let keep = *decided[at(i)].get_or_insert(!last_kept && !before_fixed);
                last_kept = keep;
            }
        }
        for v in (0..class.len()).filter(|&v| self.is_outline[v]) {
            self.kept[v] = decided[class[v]] == Some(true);
        }
    }

    /// Inside, a vertex stays unless a neighbor does.
    fn thin_inside(&mut self, mesh: &ClothMesh) {
        let neighbors = neighbors(mesh);
        for v in 0..mesh.uv.len() {
            self.kept[v] |= self.must_stay[v];
        }
        for v in (0..mesh.uv.len()).filter(|&v| !self.is_outline[v]) {
            let free = !neighbors[v].iter().any(|&w| self.kept[w]);
            self.kept[v] |= free;
        }
    }
}

/// Returns the neighbors of each vertex, ascending.
pub(super) fn neighbors(mesh: &ClothMesh) -> Vec<Vec<usize>> {
    let mut neighbors = vec![vec![]; mesh.uv.len()];
    for &[a, b, c] in &mesh.triangles {
        for (v, w) in [(a, b), (b, c), (c, a)] {
            neighbors[v].push(w);
            neighbors[w].push(v);
        }
    }
    for list in &mut neighbors {
        list.sort_unstable();
        list.dedup();
    }
    neighbors
}

/// The closed rings of boundary vertices of a panel, the one that goes round the others first.
fn rings(mesh: &ClothMesh, panel: usize) -> Vec<Vec<usize>> {
    let mut next: BTreeMap<usize, usize> = BTreeMap::new();
    let triangles = &mesh.triangles[mesh.panels[panel].triangles.clone()];
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let directed: BTreeSet<_> = sides.collect();
    for &(a, b) in &directed {
        if !directed.contains(&(b, a)) {
            next.insert(a, b);
        }
    }
    let mut rings = vec![];
    while let Some((&first, _)) = next.first_key_value() {
        let mut ring = vec![];
        let mut v = first;
        while let Some(w) = next.remove(&v) {
            ring.push(v);
            v = w;
        }
        rings.push(ring);
    }
    let area = |ring: &[usize]| {
        let points: Vec<_> = ring.iter().map(|&v| mesh.uv[v]).collect();
        geometry::ring_area(&points).abs()
    };
    rings.sort_by(|a, b| area(b).total_cmp(&area(a)));
    rings
}

/// Returns the class of each vertex: those connected by stitches, named by the lowest.
fn classes(mesh: &ClothMesh) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..mesh.uv.len()).collect();
    let root = |parent: &mut [usize], mut v: usize| {
        while parent[v] != v {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        v
    };
    for stitch in &mesh.stitches {
        let (a, b) = (root(&mut parent, stitch.a), root(&mut parent, stitch.b));
        parent[a.max(b)] = a.min(b);
    }
    (0..parent.len()).map(|v| root(&mut parent, v)).collect()
}
