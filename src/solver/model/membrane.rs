//! The membrane of a system: triangles of the continuum, springs on mesh edges, springs as given,
//! fibers.

use crate::scene::{FiberSpring, Membrane, NetSpring, Scene};
use crate::solver::forces::{
    ContinuumForce, FiberForce, MembraneTriangle, Potential, Spring, SpringForce,
};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::rest_shape::{cut_triangles, rest_area};
use crate::solver::options::MembraneModel;
use std::collections::BTreeMap;

/// Returns the springs of the paper's membrane on `scene`, every vertex a particle:
/// `(i, j, rest length [m], stiffness [N/m])`.
pub fn springs(scene: &Scene) -> Vec<(usize, usize, f64, f64)> {
    let dof_map = DofMap::identity(scene.mesh.uv.len());
    let springs = match &scene.membrane {
        Membrane::Springs(springs) => given_springs(springs, &dof_map),
        Membrane::Fabric | Membrane::Fibers(_) => edge_springs(scene, &dof_map),
    };
    springs
        .into_iter()
        .map(|s| (s.a, s.b, s.rest_length, s.stiffness))
        .collect()
}

/// Returns the membrane of `scene`; `model` is that of fabrics, springs and fibers are what they
/// are.
pub(crate) fn membrane_force(
    scene: &Scene,
    model: MembraneModel,
    dof_map: &DofMap,
) -> Box<dyn Potential> {
    match (&scene.membrane, model) {
        (Membrane::Fibers(fibers), _) => Box::new(FiberForce::new(on_particles(fibers, dof_map))),
        (Membrane::Springs(springs), _) => {
            Box::new(SpringForce::new(given_springs(springs, dof_map)))
        }
        (Membrane::Fabric, MembraneModel::Continuum) => {
            Box::new(ContinuumForce::new(triangles(scene, dof_map)))
        }
        (Membrane::Fabric, MembraneModel::Springs) => {
            Box::new(SpringForce::new(edge_springs(scene, dof_map)))
        }
    }
}

/// Returns the triangles of the continuum, each of its panel's fabric.
fn triangles(scene: &Scene, dof_map: &DofMap) -> Vec<MembraneTriangle> {
    let edge = scene.mesh.mean_edge();
    cut_triangles(scene)
        .filter_map(|(t, fabric, rest)| {
            let moduli = [
                fabric.stretch_warp_n_m,
                fabric.stretch_weft_n_m,
                fabric.shear_n_m,
            ];
            let rigidity = [fabric.bending_warp_n_m, fabric.bending_weft_n_m];
            let rigidity = rigidity.map(|b| b.max(scene.least_bending_n_m));
            let membrane = MembraneTriangle::new(t.map(|v| dof_map.of_vertex[v]), rest, moduli);
            membrane.map(|m| m.with_buckling(rigidity, edge))
        })
        .collect()
}

/// Returns springs on the edges of the mesh, panel by panel.
///
/// Their constants are those of A. Van Gelder, "Approximate simulation of elastic membranes by
/// triangulated spring meshes" (Journal of Graphics Tools 3(2), 1998), k = E sum A / l² over the
/// edge's triangles, with the modulus of an orthotropic cloth along the edge, 1/E = cos⁴/Kw +
/// sin⁴/Kf + sin² cos²/G.
fn edge_springs(scene: &Scene, dof_map: &DofMap) -> Vec<Spring> {
    let mut edges: BTreeMap<(usize, usize), Spring> = BTreeMap::new();
    for (t, fabric, rest) in cut_triangles(scene) {
        let area = rest_area(rest).abs();
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let d = [rest[j][0] - rest[i][0], rest[j][1] - rest[i][1]];
            let square = d[0] * d[0] + d[1] * d[1];
            let (cos2, sin2) = (d[0] * d[0] / square, d[1] * d[1] / square);
            let softness = cos2 * cos2 / fabric.stretch_warp_n_m
                + sin2 * sin2 / fabric.stretch_weft_n_m
                + sin2 * cos2 / fabric.shear_n_m;
            let (a, b) = (dof_map.of_vertex[t[i]], dof_map.of_vertex[t[j]]);
            let key = (t[i].min(t[j]), t[i].max(t[j]));
            edges
                .entry(key)
                .or_insert(Spring {
                    a,
                    b,
                    rest_length: square.sqrt(),
                    stiffness: 0.0,
                })
                .stiffness += area / square / softness;
        }
    }
    // Both points of an edge may be one particle where a seam gathers.
    edges.into_values().filter(|s| s.a != s.b).collect()
}

/// Returns the fibers with particles for their corners.
fn on_particles(fibers: &[FiberSpring], dof_map: &DofMap) -> Vec<FiberSpring> {
    let carry = |f: &FiberSpring| FiberSpring {
        corners: f.corners.map(|v| dof_map.of_vertex[v]),
        ..*f
    };
    fibers.iter().map(carry).collect()
}

/// Returns the springs that join two particles.
fn given_springs(springs: &[NetSpring], dof_map: &DofMap) -> Vec<Spring> {
    springs
        .iter()
        .map(|s| Spring {
            a: dof_map.of_vertex[s.a],
            b: dof_map.of_vertex[s.b],
            rest_length: s.rest_length_m,
            stiffness: s.stiffness_n_m,
        })
        .filter(|s| s.a != s.b)
        .collect()
}
