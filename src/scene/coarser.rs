//! The same scene on a coarser mesh: what a multilevel solver starts from.

use super::chords;
use super::{FiberSpring, Membrane, Scene};
use crate::mesh::{self, ClothMesh, CoarserMesh};
use std::collections::BTreeMap;

/// A scene on a coarser mesh, and how the finer one hangs on it.
#[derive(Clone, Debug)]
pub struct CoarserScene {
    /// The coarser scene.
    pub scene: Scene,
    /// The finer vertex that each coarser one is; ascending.
    pub finer: Vec<usize>,
    /// For each finer vertex, three coarser ones with barycentric coordinates; see
    /// [`CoarserMesh::weights`].
    pub weights: Vec<[(usize, f64); 3]>,
}

/// Least bending length of cloth on a coarser mesh, as a share of its mesh edges.
const BENDING_LENGTH: f64 = 1.0;
/// Directions of fibers are told apart to this much of a turn.
const TURN: f64 = 1e6;

/// The scene on the next coarser mesh; `None` if there is none worth having.
///
/// Mass goes to the corners of the triangle that it lies in. A net of springs becomes fibers: a
/// spring that lies in a triangle which deforms as a whole has the same energy as a fiber along it,
/// and all springs of one direction in a triangle are one fiber. So the coarser net is the finer
/// one with its shapes restricted, not a model of its own.
pub fn coarser(scene: &Scene) -> Option<CoarserScene> {
    let CoarserMesh {
        mesh,
        finer,
        weights,
    } = mesh::coarser(&scene.mesh, &scene.pins, &chords::chords(scene))?;
    let mut number = vec![usize::MAX; scene.start.len()];
    finer.iter().enumerate().for_each(|(n, &v)| number[v] = n);
    let mut mass = vec![0.0; finer.len()];
    for (m, corners) in scene.mass.iter().zip(&weights) {
        // A vertex outside the coarse outline has a negative coordinate; no particle may lose mass
        // by it.
        let sum: f64 = corners.iter().map(|(_, w)| w.max(0.0)).sum();
        for &(v, w) in corners {
            mass[v] += m * w.max(0.0) / sum;
        }
    }
    let coarse = Scene {
        start: finer.iter().map(|&v| scene.start[v]).collect(),
        mass,
        fabrics: scene.fabrics.clone(),
        cut: scene.cut.clone(),
        membrane: membrane(scene, &mesh, &weights),
        least_bending_n_m: least_bending(scene, &mesh),
        body: scene.body.clone(),
        body_hardness: scene.body_hardness,
        fixed_cloth: scene.fixed_cloth.clone(),
        friction: scene.friction,
        gravity: scene.gravity,
        drag: scene.drag,
        pins: scene.pins.iter().map(|&v| number[v]).collect(),
        fixed_axis: scene.fixed_axis,
        wind: scene.wind,
        layers: scene.layers.clone(),
        carriers: scene.carriers.clone(),
        self_contact: scene.self_contact,
        mesh,
    };
    Some(CoarserScene {
        scene: coarse,
        finer,
        weights,
    })
}

/// The rigidity of a cloth whose bending length (B / (g density))^(1/3) is a share of the mesh
/// edges: folds much narrower than that have no shape on this mesh, and searching for one takes
/// long.
fn least_bending(scene: &Scene, mesh: &ClothMesh) -> f64 {
    let weight = scene.gravity.norm() * scene.mass.iter().sum::<f64>() / mesh.area();
    weight * (BENDING_LENGTH * mesh.mean_edge()).powi(3)
}

/// Returns the membrane of `scene` on `mesh`: of the same fabrics, or its springs as fibers of
/// triangles.
fn membrane(scene: &Scene, mesh: &ClothMesh, weights: &[[(usize, f64); 3]]) -> Membrane {
    match scene.membrane {
        Membrane::Fabric => Membrane::Fabric,
        Membrane::Springs(_) | Membrane::Fibers(_) => {
            fibers(scene, mesh, weights).map_or(Membrane::Fabric, Membrane::Fibers)
        }
    }
}

/// The springs or fibers of `scene` as fibers of the triangles of `mesh`.
fn fibers(
    scene: &Scene,
    mesh: &ClothMesh,
    weights: &[[(usize, f64); 3]],
) -> Option<Vec<FiberSpring>> {
    let springs = scene.membrane.springs().iter().map(|s| FiberSpring {
        corners: [s.a, s.b, s.a],
        weights: [-1.0, 1.0, 0.0],
        rest_length_m: s.rest_length_m,
        stiffness_n_m: s.stiffness_n_m,
    });
    let fibers = scene.membrane.fibers().iter().copied().chain(springs);
    let triangles = Triangles::new(mesh);
    let mut merged: BTreeMap<(usize, [i64; 3]), FiberSpring> = BTreeMap::new();
    for fiber in fibers {
        let rest = fiber.corners.map(|v| scene.mesh.uv[v]);
        let along = sum(fiber.weights, rest);
        let length = along[0].hypot(along[1]);
        let home = triangles.around(fiber.corners.map(|v| weights[v]), middle(&fiber, rest))?;
        let unit = one_way(along.map(|x| x / length));
        let ratio = fiber.rest_length_m / length;
        #[expect(clippy::cast_possible_truncation, reason = "at most a few millions")]
        let key = [unit[0], unit[1], ratio].map(|x| (x * TURN).round() as i64);
        let merged = merged.entry((home, key)).or_insert(FiberSpring {
            corners: mesh.triangles[home],
            weights: triangles.slopes[home].map(|g| g[0] * unit[0] + g[1] * unit[1]),
            rest_length_m: ratio,
            stiffness_n_m: 0.0,
        });
        merged.stiffness_n_m += fiber.stiffness_n_m * length * length;
    }
    (!merged.is_empty()).then(|| merged.into_values().collect())
}

fn sum(weights: [f64; 3], points: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|k| (0..3).map(|i| weights[i] * points[i][k]).sum())
}

/// The middle of a fiber: of its two ends, or of its triangle.
fn middle(fiber: &FiberSpring, rest: [[f64; 2]; 3]) -> [f64; 2] {
    if fiber.corners[0] == fiber.corners[2] {
        sum([0.5, 0.5, 0.0], rest)
    } else {
        sum([1.0 / 3.0; 3], rest)
    }
}

/// A direction or its opposite, whichever points right or, upright, up: one way along a fiber is as
/// good as the other.
fn one_way(unit: [f64; 2]) -> [f64; 2] {
    let upright = unit[0].abs() <= 0.5 / TURN;
    let back = if upright {
        unit[1] < 0.0
    } else {
        unit[0] < 0.0
    };
    if back { unit.map(|x| -x) } else { unit }
}

/// The triangles of a coarse mesh, to find the one that a point lies in.
struct Triangles<'a> {
    mesh: &'a ClothMesh,
    /// Gradients of the three barycentric coordinates of each \[1/m\].
    slopes: Vec<[[f64; 2]; 3]>,
    /// The triangles round each vertex.
    around: Vec<Vec<usize>>,
}

impl<'a> Triangles<'a> {
    fn new(mesh: &'a ClothMesh) -> Self {
        let mut around = vec![vec![]; mesh.uv.len()];
        for (index, triangle) in mesh.triangles.iter().enumerate() {
            triangle.iter().for_each(|&v| around[v].push(index));
        }
        let slopes = mesh.triangles.iter().map(|t| slopes(t.map(|v| mesh.uv[v])));
        Self {
            mesh,
            slopes: slopes.collect(),
            around,
        }
    }

    /// Of the triangles round some vertices, the one in which `p` lies deepest.
    fn around(&self, near: [[(usize, f64); 3]; 3], p: [f64; 2]) -> Option<usize> {
        let vertices = near.iter().flatten().map(|(v, _)| *v);
        let candidates = vertices.flat_map(|v| self.around[v].iter().copied());
        candidates
            .map(|t| (t, self.depth(t, p)))
            .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
            .map(|(t, _)| t)
    }

    /// The smallest barycentric coordinate of `p`.
    fn depth(&self, triangle: usize, p: [f64; 2]) -> f64 {
        let first = self.mesh.uv[self.mesh.triangles[triangle][0]];
        let d = [p[0] - first[0], p[1] - first[1]];
        let [_, b, c] = self.slopes[triangle].map(|g| g[0] * d[0] + g[1] * d[1]);
        b.min(c).min(1.0 - b - c)
    }
}

/// Gradients of the barycentric coordinates of a triangle \[1/m\].
fn slopes([p, q, r]: [[f64; 2]; 3]) -> [[f64; 2]; 3] {
    let (u, v) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
    let twice = u[0] * v[1] - u[1] * v[0];
    let (b, c) = ([v[1] / twice, -v[0] / twice], [-u[1] / twice, u[0] / twice]);
    [[-b[0] - c[0], -b[1] - c[1]], b, c]
}
