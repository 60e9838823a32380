//! The same scene on a coarser mesh: what a multilevel solver starts from.

use super::{Body, FiberSpring, Membrane, Scene};
use crate::mesh::{self, ClothMesh, CoarserMesh, PanelRange};
use nalgebra::{Vector2, Vector3};
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
/// Mesh edges of the next coarser mesh over those of a mesh: it has a third of the vertices.
const COARSER_EDGE: f64 = 1.75;
/// Most that a panel may turn along one mesh edge at its start \[rad\]: the edge sags by an eighth
/// of the radius there.
const MOST_TURN: f64 = 1.0;
/// Longest mesh edges of a coarser mesh of what is worn \[m\]: a quarter of the girth of an arm.
/// Longer ones close through arms, ankles and shoulders, or beside them.
const LONGEST_WORN: f64 = 0.065;
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
    } = mesh::coarser(&scene.mesh, &scene.pins, &chords(scene))?;
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

/// Returns the panels whose edges on a coarser mesh would be chords through the body: those that
/// start so round, as a sleeve or a collar, and of what is worn those whose edges are as long.
fn chords(scene: &Scene) -> Vec<bool> {
    let is_worn = matches!(scene.body, Some(Body::Avatar(_)));
    let is_chord = |range| {
        let edge = COARSER_EDGE * mean_edge(&scene.mesh, range);
        is_worn && edge > LONGEST_WORN || edge * start_curvature(scene, range) > MOST_TURN
    };
    scene.mesh.panels.iter().map(is_chord).collect()
}

/// Returns the length of the edges of equal triangles as many as a panel has \[m\].
fn mean_edge(mesh: &ClothMesh, range: &PanelRange) -> f64 {
    let triangles = &mesh.triangles[range.triangles.clone()];
    let doubled = triangles.iter().map(|t| {
        let [p, q, r] = t.map(|v| Vector2::from(mesh.uv[v]));
        (q - p).perp(&(r - p)).abs()
    });
    let area = 0.5 * doubled.sum::<f64>() / triangles.len().max(1) as f64;
    (4.0 / 3f64.sqrt() * area).sqrt()
}

/// Returns the mean curvature of the start of a panel that is rolled one way \[1/m\]: the
/// angles of its inner edges, each times the edge's length, over the area (D. Cohen-Steiner, J.-M.
/// Morvan, "Restricted Delaunay triangulations and normal cycle", 19th Symposium on
/// Computational Geometry, 2003).
fn start_curvature(scene: &Scene, range: &PanelRange) -> f64 {
    let mut beside: BTreeMap<[usize; 2], Vector3<f64>> = BTreeMap::new();
    let (mut turned, mut area) = (0.0, 0.0);
    for &[a, b, c] in &scene.mesh.triangles[range.triangles.clone()] {
        let [p, q, r] = [a, b, c].map(|v| scene.start[v]);
        let across = (q - p).cross(&(r - p));
        area += 0.5 * across.norm();
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if let Some(other) = beside.insert([from.min(to), from.max(to)], across) {
                turned += other.angle(&across) * (scene.start[to] - scene.start[from]).norm();
            }
        }
    }
    if area > 0.0 { turned / area } else { 0.0 }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Stitch;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::{AnchoredPlacement, Cut, PanelParts, Parts, build, fabric};
    use crate::seam::Face;

    /// A panel 20 cm wide and 120 cm long of squares of 2 cm, at a place of the body.
    fn panel(at: PlacementAnchor) -> Scene {
        let (columns, rows, side) = (10, 60, 0.02);
        let uv = (0..=rows)
            .flat_map(|j| (0..=columns).map(move |i| [side * f64::from(i), side * f64::from(j)]));
        let at_corner = |i: usize, j: usize| j * (columns as usize + 1) + i;
        let (columns_of, rows_of) = (columns as usize, rows as usize);
        let triangles = (0..rows_of).flat_map(|j| {
            (0..columns_of).flat_map(move |i| {
                let [a, b, c, d] =
                    [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| at_corner(i, j));
                [[a, b, c], [a, c, d]]
            })
        });
        let uv: Vec<_> = uv.collect();
        let triangles: Vec<_> = triangles.collect();
        let corners = [(0, 0), (0, rows_of), (columns_of, rows_of), (columns_of, 0)];
        let mesh = ClothMesh {
            panels: vec![PanelRange {
                vertices: 0..uv.len(),
                triangles: 0..triangles.len(),
                corners: corners.map(|(i, j)| at_corner(i, j)).to_vec(),
            }],
            uv,
            triangles,
            stitches: Vec::<Stitch>::new(),
        };
        let outline = Panel::rectangle("sleeve", [0.2, 1.2]);
        let placement = Placement {
            at: Some(at),
            ..Placement::default()
        };
        let anchored = AnchoredPlacement::new(&outline, Some(&placement)).expect("a place");
        build(Parts {
            mesh,
            panels: vec![PanelParts {
                cut: Cut {
                    fabric: 0,
                    warp_angle: 0.0,
                    face_down: false,
                },
                placed: anchored.place(&outline, Face::Up, None),
            }],
            fabrics: vec![fabric::library().remove("linen").expect("a shipped fabric")],
            body: None,
            friction: None,
            pins: vec![],
        })
    }

    /// 20 cm rolled by a turn have a radius of 32 mm, so that edges of 35 mm turn by more than a
    /// radian.
    #[test]
    fn a_sleeve_keeps_its_vertices_where_a_front_is_made_coarser() {
        assert!(coarser(&panel(PlacementAnchor::TorsoFront)).is_some());
        assert!(coarser(&panel(PlacementAnchor::ArmLeft)).is_none());
        let sleeve = panel(PlacementAnchor::ArmLeft);
        let curvature = start_curvature(&sleeve, &sleeve.mesh.panels[0]);
        let exact = std::f64::consts::TAU / 0.2;
        // The turns between columns are those of the roll, but those at its sides are missing.
        let missing = 1.0 / 10.0;
        assert!(
            (curvature / exact - 1.0).abs() < missing + 0.01,
            "{curvature} {exact}"
        );
    }
}
