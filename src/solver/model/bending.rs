//! Bend patches of a scene: each triangle with its neighbors.

use crate::scene::{Fabric, Scene};
use crate::solver::forces::BendPatch;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::rest_shape::rest_triangles;
use std::collections::BTreeMap;

/// Returns every triangle with its neighbors, also across welded seams: a seam pressed open bends
/// like the cloth.
pub(crate) fn bend_patches(scene: &Scene, dof_map: &DofMap) -> Vec<BendPatch> {
    let sides = sides(scene, dof_map);
    let least = scene.least_bending_n_m;
    let patch = |(t, fabric, rest): ([usize; 3], Option<&Fabric>, [[f64; 2]; 3])| {
        let rigidity = fabric.map_or([0.0; 2], |f| [f.bending_warp_n_m, f.bending_weft_n_m]);
        let rigidity = rigidity.map(|b| b.max(least));
        if rigidity[0].max(rigidity[1]) <= 0.0 {
            return None;
        }
        let corners = t.map(|v| dof_map.of_vertex[v]);
        let wing = |k: usize| {
            let (key, mine) = side(corners, rest, k);
            let [a, b] = sides[&key].as_slice() else {
                return None;
            };
            let other = if a.far == corners[k] { b } else { a };
            (a.far != b.far && key.0 != key.1).then(|| (other.far, unfolded(rest, k, &mine, other)))
        };
        BendPatch::new(corners, rest, [wing(0), wing(1), wing(2)], rigidity)
    };
    rest_triangles(scene).filter_map(patch).collect()
}

/// A triangle seen from one of its edges.
struct BendSide {
    /// The particle that is not on the edge.
    far: usize,
    /// Its place from the middle of the edge: along it, from its lower to its higher particle, and
    /// across \[m\].
    along: f64,
    across: f64,
    /// True if the edge runs from its lower to its higher particle round the triangle.
    rising: bool,
}

fn sides(scene: &Scene, dof_map: &DofMap) -> BTreeMap<(usize, usize), Vec<BendSide>> {
    let mut sides: BTreeMap<_, Vec<BendSide>> = BTreeMap::new();
    for (t, _, rest) in rest_triangles(scene) {
        for k in 0..3 {
            let (key, side) = side(t.map(|v| dof_map.of_vertex[v]), rest, k);
            sides.entry(key).or_default().push(side);
        }
    }
    sides
}

/// Returns the edge across from corner `k`, and the triangle seen from it.
fn side(corners: [usize; 3], rest: [[f64; 2]; 3], k: usize) -> ((usize, usize), BendSide) {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let (a, b) = (corners[i], corners[j]);
    let rising = a < b;
    let (middle, along) = edge_frame(rest, k);
    let d = [rest[k][0] - middle[0], rest[k][1] - middle[1]];
    let forward = d[0] * along[0] + d[1] * along[1];
    let side = BendSide {
        far: corners[k],
        along: if rising { forward } else { -forward },
        across: (along[0] * d[1] - along[1] * d[0]).abs(),
        rising,
    };
    ((a.min(b), a.max(b)), side)
}

/// Returns middle and direction of the edge across from corner `k`, as it runs round the triangle.
fn edge_frame(rest: [[f64; 2]; 3], k: usize) -> ([f64; 2], [f64; 2]) {
    let (p, q) = (rest[(k + 1) % 3], rest[(k + 2) % 3]);
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0].hypot(d[1]);
    (
        [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])],
        [d[0] / length, d[1] / length],
    )
}

/// Returns the far corner of the neighbor across from corner `k`, unfolded into the plane of the
/// triangle.
fn unfolded(rest: [[f64; 2]; 3], k: usize, mine: &BendSide, other: &BendSide) -> [f64; 2] {
    let (middle, along) = edge_frame(rest, k);
    let forward = if mine.rising {
        other.along
    } else {
        -other.along
    };
    // Out of a triangle that runs counter-clockwise is to the right of its edges.
    let out = [along[1], -along[0]];
    [0, 1].map(|i| middle[i] + along[i] * forward + out[i] * other.across)
}
