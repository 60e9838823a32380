//! The triangle nearest to a point, by a tree of discs: a piece of a surface fits one far closer
//! than a box.

use super::TriangleMesh;
use nalgebra::Vector3;

/// Triangles of a leaf: few enough that testing them costs about as much as two boxes.
const LEAF: usize = 4;
/// Depth of the stack: halving at the median gives a depth below `log2` of any number of triangles.
const DEPTH: usize = 64;

/// Share of a gap that rounding may have added to it, and then some.
const ROUNDING: f64 = 1e-9;

/// Discs around discs around triangles.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Triangles in the order of the leaves: index into the mesh and corners.
    leaves: Vec<(usize, [Vector3<f64>; 3])>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    middle: Vector3<f64>,
    /// Of length 1.
    axis: Vector3<f64>,
    /// \[m\]
    half_thickness: f64,
    /// \[m\]
    radius: f64,
    /// First triangle of a leaf, or the second child (the first one follows its parent).
    at: usize,
    /// Triangles of a leaf; 0 for a node with children.
    count: usize,
}

/// The part of a triangle that a point is nearest to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feature {
    Face,
    /// The edge from corner `k` to corner `k + 1`.
    Edge(usize),
    Corner(usize),
}

/// The point of a surface that is nearest to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub(super) triangle: usize,
    pub(super) feature: Feature,
    pub(super) point: Vector3<f64>,
    pub(super) distance_squared: f64,
}

impl Tree {
    pub(super) fn new(surface: &TriangleMesh) -> Self {
        Self::of(surface, 0..surface.triangles.len())
    }

    /// The tree of these triangles of a surface alone.
    pub(super) fn of(surface: &TriangleMesh, triangles: impl IntoIterator<Item = usize>) -> Self {
        let triangles = triangles.into_iter();
        let mut leaves: Vec<_> = triangles.map(|t| (t, surface.corners(t))).collect();
        let mut nodes = Vec::new();
        let count = leaves.len();
        grow(&mut leaves, (0, count), &mut nodes);
        Self { nodes, leaves }
    }

    /// The nearest point among those closer than `within` \[m\]. Of several equally near ones,
    /// always the same.
    pub(super) fn nearest(&self, p: &Vector3<f64>, within: f64) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        let mut bound = within * within;
        let mut stack = [(0_usize, 0.0_f64); DEPTH];
        let mut height = usize::from(!self.nodes.is_empty());
        while height > 0 {
            height -= 1;
            let (index, gap) = stack[height];
            if gap > bound {
                continue;
            }
            let node = &self.nodes[index];
            if node.count > 0 {
                for (triangle, corners) in &self.leaves[node.at..node.at + node.count] {
                    let (point, feature) = nearest_in_triangle(p, corners);
                    let distance_squared = (p - point).norm_squared();
                    if distance_squared < bound {
                        bound = distance_squared;
                        best = Some(Nearest {
                            triangle: *triangle,
                            feature,
                            point,
                            distance_squared,
                        });
                    }
                }
                continue;
            }
            let children = [index + 1, node.at].map(|child| (child, self.nodes[child].gap(p)));
            let [near, far] = if children[0].1 <= children[1].1 {
                children
            } else {
                [children[1], children[0]]
            };
            stack[height] = far;
            stack[height + 1] = near;
            height += 2;
        }
        best
    }
}

impl Node {
    /// The disc around triangles that stands on their mean normal.
    fn around(inside: &[(usize, [Vector3<f64>; 3])]) -> Self {
        let corners = || inside.iter().flat_map(|(_, corners)| corners);
        let normal = |(_, [a, b, c]): &(usize, [Vector3<f64>; 3])| (b - a).cross(&(c - a));
        let sum: Vector3<f64> = inside.iter().map(normal).sum();
        let axis = sum.try_normalize(0.0).unwrap_or_else(Vector3::y);
        let mean = corners().sum::<Vector3<f64>>() / (3 * inside.len()).max(1) as f64;
        let along = || corners().map(|p| (p - mean).dot(&axis));
        let (low, high) = (
            along().fold(f64::INFINITY, f64::min),
            along().fold(f64::NEG_INFINITY, f64::max),
        );
        let middle = mean + axis * (0.5 * (low + high));
        let across = corners().map(|p| {
            let d = p - middle;
            (d - axis * d.dot(&axis)).norm_squared()
        });
        Self {
            middle,
            axis,
            half_thickness: 0.5 * (high - low),
            radius: across.fold(0.0, f64::max).sqrt(),
            at: 0,
            count: 0,
        }
    }

    /// Squared distance of `p` from the disc, or a little less.
    fn gap(&self, p: &Vector3<f64>) -> f64 {
        let d = p - self.middle;
        let along = d.dot(&self.axis);
        let across = (d.norm_squared() - along * along).max(0.0).sqrt();
        let over = (along.abs() - self.half_thickness).max(0.0);
        let beside = (across - self.radius).max(0.0);
        (over * over + beside * beside) * (1.0 - ROUNDING)
    }
}

fn grow(
    leaves: &mut [(usize, [Vector3<f64>; 3])],
    (from, to): (usize, usize),
    nodes: &mut Vec<Node>,
) {
    let inside = &mut leaves[from..to];
    let index = nodes.len();
    let count = if to - from <= LEAF { to - from } else { 0 };
    nodes.push(Node {
        at: from,
        count,
        ..Node::around(inside)
    });
    if count > 0 || to == from {
        return;
    }
    let corners = || inside.iter().flat_map(|(_, corners)| corners);
    let lower = corners().fold(Vector3::repeat(f64::INFINITY), |l, p| l.inf(p));
    let upper = corners().fold(Vector3::repeat(f64::NEG_INFINITY), |u, p| u.sup(p));
    let axis = (upper - lower).imax();
    let middle = (to - from) / 2;
    let key = |c: &[Vector3<f64>; 3]| c[0][axis] + c[1][axis] + c[2][axis];
    // the index breaks ties, so that the tree depends on nothing but the mesh
    inside.select_nth_unstable_by(middle, |a, b| {
        key(&a.1).total_cmp(&key(&b.1)).then(a.0.cmp(&b.0))
    });
    grow(leaves, (from, from + middle), nodes);
    nodes[index].at = nodes.len();
    grow(leaves, (from + middle, to), nodes);
}

/// The point of a triangle nearest to `p` (C. Ericson, "Real-Time Collision Detection", 2005,
/// section 5.1.5).
pub(super) fn nearest_in_triangle(
    p: &Vector3<f64>,
    &[a, b, c]: &[Vector3<f64>; 3],
) -> (Vector3<f64>, Feature) {
    let (ab, ac) = (b - a, c - a);
    let ap = p - a;
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, Feature::Corner(0));
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return (b, Feature::Corner(1));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (a + ab * (d1 / (d1 - d3)), Feature::Edge(0));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return (c, Feature::Corner(2));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (a + ac * (d2 / (d2 - d6)), Feature::Edge(2));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return (b + (c - b) * s, Feature::Edge(1));
    }
    let total = va + vb + vc;
    (a + ab * (vb / total) + ac * (vc / total), Feature::Face)
}
