//! The surface of a garment as contact sees it: triangles, each with the vertices and edges that
//! are its own, so that every pair of features is looked at once.

use crate::scene::Body;
use nalgebra::Vector3;
use std::collections::{BTreeMap, BTreeSet};

/// Share of the shortest edge at a corner that cloth is taken to be thick at most: else the meshes
/// of one flat panel would press each other apart.
const THICKNESS_SHARE: f64 = 0.3;

/// The surface of a garment between its particles, and of cloth that does not move.
pub(crate) struct ClothSurface {
    /// Corners of each triangle, those of fixed cloth last.
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Vertex that each particle is once its stitches are closed; `#P + #F`.
    pub(crate) welded: Vec<usize>,
    /// Ends of the edges with their rest lengths \[m\].
    pub(crate) rest_edges: Vec<(usize, usize, f64)>,
    /// Thickness of the cloth at each particle \[m\]; `#P + #F`.
    pub(crate) thickness: Vec<f64>,
    /// Positions of the vertices of fixed cloth \[m\]; `#F`. They are numbered after the
    /// particles.
    pub(crate) fixed: Vec<Vector3<f64>>,
    /// The order of layers, if there is one.
    pub(crate) order: Option<LayerOrder>,
}

/// The order of layers from a body outwards.
#[derive(Clone, Debug)]
pub(crate) struct LayerOrder {
    /// Layer of each triangle; `#T`.
    pub(crate) layer: Vec<usize>,
    /// The body.
    pub(crate) body: Body,
}

impl LayerOrder {
    /// Returns the direction in which triangle `s`, which meets triangle `t` at `p` \[m\], is to
    /// move against it; none if they are in one layer, or it is on the body's surface.
    pub(super) fn way_out(&self, [s, t]: [usize; 2], p: &Vector3<f64>) -> Option<Vector3<f64>> {
        if self.layer[s] == self.layer[t] {
            return None;
        }
        let normal = self.body.outward(p)?;
        let is_higher = self.layer[s] > self.layer[t];
        Some(if is_higher { normal } else { -normal })
    }
}

/// The triangles of a garment with what belongs to each.
#[derive(Clone, Debug)]
pub(super) struct ContactSurface {
    /// Corners of each triangle.
    pub(super) triangles: Vec<[usize; 3]>,
    /// Number of those that are not fixed, which come first.
    pub(super) moving_triangles: usize,
    /// Of the vertices and edges of a triangle, those that no triangle before it has.
    pub(super) own: Vec<OwnFeatures>,
    /// Vertex that each particle is once its stitches are closed; `#P + #F`.
    pub(super) welded: Vec<usize>,
    /// Thickness of the cloth at each particle \[m\]; `#P + #F`.
    pub(super) thickness: Vec<f64>,
    /// Mean length of the edges that are not fixed \[m\].
    pub(super) edge_length: f64,
    /// The order of layers, if there is one.
    pub(super) order: Option<LayerOrder>,
}

/// Vertices and edges of one triangle.
#[derive(Clone, Debug, Default)]
pub(super) struct OwnFeatures {
    pub(super) vertices: Vec<usize>,
    pub(super) edges: Vec<[usize; 2]>,
}

impl ContactSurface {
    /// Returns the surface of these triangles.
    ///
    /// A triangle two corners of which are stitched together has no area in the end, and is left
    /// out.
    pub(super) fn new(cloth: ClothSurface) -> Self {
        let ClothSurface {
            triangles,
            welded,
            rest_edges,
            mut thickness,
            fixed,
            mut order,
        } = cloth;
        let particles = welded.len() - fixed.len();
        let has_area = |t: &&[usize; 3]| {
            let [a, b, c] = t.map(|i| welded[i]);
            a != b && b != c && c != a
        };
        if let Some(order) = &mut order {
            let mut kept = triangles.iter().map(|t| has_area(&t));
            order.layer.retain(|_| kept.next() == Some(true));
        }
        let triangles: Vec<_> = triangles.iter().filter(has_area).copied().collect();
        for &(a, b, length) in &rest_edges {
            for i in [a, b] {
                thickness[i] = thickness[i].min(THICKNESS_SHARE * length);
            }
        }
        let whole: f64 = rest_edges.iter().map(|edge| edge.2).sum();
        let (mut vertices, mut edges) = (BTreeSet::new(), BTreeSet::new());
        let own = triangles.iter().map(|&[a, b, c]| OwnFeatures {
            vertices: [a, b, c]
                .into_iter()
                .filter(|&v| vertices.insert(v))
                .collect(),
            edges: [[a, b], [b, c], [c, a]]
                .map(|[i, j]| [i.min(j), i.max(j)])
                .into_iter()
                .filter(|&edge| edges.insert(edge))
                .collect(),
        });
        Self {
            own: own.collect(),
            edge_length: whole / rest_edges.len().max(1) as f64,
            moving_triangles: triangles.partition_point(|t| t[0] < particles),
            triangles,
            welded,
            thickness,
            order,
        }
    }

    /// Returns the thickness of the cloth where it is thickest \[m\].
    pub(super) fn most_thickness(&self) -> f64 {
        self.thickness.iter().copied().fold(0.0, f64::max)
    }

    /// Returns the triangles beside each edge.
    pub(super) fn triangles_of_edges(&self) -> BTreeMap<[usize; 2], Vec<usize>> {
        let mut beside: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (t, &[a, b, c]) in self.triangles.iter().enumerate() {
            for [i, j] in [[a, b], [b, c], [c, a]] {
                beside.entry([i.min(j), i.max(j)]).or_default().push(t);
            }
        }
        beside
    }

    /// Returns true if a corner of one is stitched to one of the other, or is the same.
    pub(super) fn share_corner(&self, a: &[usize], b: &[usize]) -> bool {
        a.iter()
            .any(|&i| b.iter().any(|&j| self.welded[i] == self.welded[j]))
    }
}
