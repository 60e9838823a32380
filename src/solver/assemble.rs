//! From a scene to the particles and terms of one stage: sewing, or the drape that follows.

use super::ask::{Membrane as MembraneKind, Simulate};
use super::contact::{BodyContact, Friction};
use super::forces::{
    BendForce, BendPatch, ContinuumForce, FibreForce, Force, Gravity, Membrane, SewingForce,
    Spring, SpringForce, WindForce,
};
use super::system::{System, TimedForce};
use super::topology::Particles;
use crate::scene::{Fabric, Fibre, NetSpring, Scene};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Distance that cloth is kept from the skin, besides half its thickness \[m\]: what keeps the middles of triangles, which
/// cut across the body's curves, outside too (an edge of 12 mm sags 0.9 mm into a shoulder of 20 mm radius).
const SKIN_OFFSET: f64 = 2e-3;

/// Mass per area of cloth of which only the mass is known \[kg/m²\]: a shirt's.
const TYPICAL_DENSITY: f64 = 0.2;

/// What one stage of a fit asks for.
pub(crate) struct Stage<'a> {
    /// Which vertices are one particle.
    pub(crate) particles: &'a Particles,
    /// Vertex pairs that a spring pulls together, and its stiffness \[N/m\].
    pub(crate) stitches: Option<(Vec<(usize, usize)>, f64)>,
    /// Whether weight acts.
    pub(crate) gravity: bool,
    /// Whether the body holds cloth by friction.
    pub(crate) friction: bool,
    /// How far samples of the body are carried on \[m\].
    pub(crate) reuse: f64,
}

/// The particles and terms of `stage`.
pub(crate) fn assemble<'a>(
    scene: &Scene,
    ask: &Simulate,
    stage: &Stage<'_>,
    clock: &'a dyn Fn() -> f64,
) -> System<'a> {
    let particles = stage.particles;
    let mass = particles.sum(&scene.mass);
    let mut forces: Vec<Box<dyn Force>> = vec![match (&scene.net, &scene.fibres, ask.membrane) {
        (_, Some(fibres), _) => Box::new(FibreForce::new(carried(fibres, particles))),
        (None, None, MembraneKind::Continuum) => {
            Box::new(ContinuumForce::new(membranes(scene, particles)))
        }
        _ => Box::new(SpringForce::new(spring_net(scene, particles))),
    }];
    let patches = bend_patches(scene, particles);
    if !patches.is_empty() {
        forces.push(Box::new(BendForce::new(patches)));
    }
    if stage.gravity && scene.gravity != Vector3::zeros() {
        let weight = mass.iter().map(|m| scene.gravity * *m).collect();
        forces.push(Box::new(Gravity {
            weight,
            start: particles.mean(&scene.start),
        }));
    }
    // Wind acts as weight does: on a garment that is sewn.
    if let Some(wind) = scene.wind.filter(|_| stage.gravity) {
        let triangles = particle_triangles(scene, particles);
        let start = particles.mean(&scene.start);
        forces.push(Box::new(WindForce::new(wind, triangles, &start)));
    }
    if let Some((stitches, stiffness)) = &stage.stitches {
        let pairs = stitches
            .iter()
            .map(|&(a, b)| (particles.of_vertex[a], particles.of_vertex[b]))
            .filter(|(a, b)| a != b)
            .collect();
        forces.push(Box::new(SewingForce::new(pairs, *stiffness)));
    }
    let mut held = vec![false; mass.len()];
    for &pin in &scene.pins {
        held[particles.of_vertex[pin]] = true;
    }
    let contact = scene.body.as_ref().map(|body| {
        let area = particles.sum(&vertex_areas(scene));
        let friction = (stage.friction && scene.friction > 0.0)
            .then(|| Friction::new(scene.friction, mass.len()));
        BodyContact::new(body.clone(), kept_distance(scene), &area)
            .with_friction(friction)
            .with_reuse(stage.reuse)
    });
    let terms = forces
        .into_iter()
        .map(|force| TimedForce { force, cpu_s: 0.0 })
        .collect();
    System {
        mass,
        held,
        held_axis: scene.held_axis,
        terms,
        contact,
        contact_cpu_s: 0.0,
        clock,
    }
}

/// Distance that cloth is kept from the skin \[m\].
pub fn kept_distance(scene: &Scene) -> f64 {
    let thickness = scene.fabrics.iter().map(|f| f.thickness_m);
    SKIN_OFFSET + 0.5 * thickness.fold(0.0, f64::max)
}

fn particle_triangles(scene: &Scene, particles: &Particles) -> Vec<[usize; 3]> {
    let of_vertex = |t: &[usize; 3]| t.map(|v| particles.of_vertex[v]);
    scene.mesh.triangles.iter().map(of_vertex).collect()
}

/// Cloth area that each vertex stands for: a third of each of its triangles \[m²\]; guessed from its mass where there are none.
pub(crate) fn vertex_areas(scene: &Scene) -> Vec<f64> {
    if scene.mesh.triangles.is_empty() {
        return scene.mass.iter().map(|m| m / TYPICAL_DENSITY).collect();
    }
    let mut area = vec![0.0; scene.mesh.uv.len()];
    for triangle in &scene.mesh.triangles {
        let third = rest_area(triangle.map(|v| scene.mesh.uv[v])) / 3.0;
        for &v in triangle {
            area[v] += third;
        }
    }
    area
}

fn rest_area([p, q, r]: [[f64; 2]; 3]) -> f64 {
    0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
}

/// Each triangle with the panel's fabric and its rest positions in warp-weft coordinates.
fn cut_triangles(scene: &Scene) -> impl Iterator<Item = ([usize; 3], &Fabric, [[f64; 2]; 3])> {
    scene
        .mesh
        .panels
        .iter()
        .zip(&scene.cut)
        .flat_map(move |(panel, cut)| {
            let (sin, cos) = cut.warp_angle.sin_cos();
            scene.mesh.triangles[panel.triangles.clone()]
                .iter()
                .map(move |t| {
                    let rest = t.map(|v| {
                        let [u, v] = scene.mesh.uv[v];
                        [u * cos + v * sin, v * cos - u * sin]
                    });
                    (*t, &scene.fabrics[cut.fabric], rest)
                })
        })
}

/// The springs of the paper's membrane on `scene`, every vertex a particle: `(i, j, rest length [m], stiffness [N/m])`.
pub fn springs(scene: &Scene) -> Vec<(usize, usize, f64, f64)> {
    let apart = Particles::apart(scene.mesh.uv.len());
    spring_net(scene, &apart)
        .into_iter()
        .map(|s| (s.a, s.b, s.rest_length, s.stiffness))
        .collect()
}

fn membranes(scene: &Scene, particles: &Particles) -> Vec<Membrane> {
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
            let membrane = Membrane::new(t.map(|v| particles.of_vertex[v]), rest, moduli);
            membrane.map(|m| m.that_buckles(rigidity, edge))
        })
        .collect()
}

/// The springs that the scene gives, or those on the edges of the mesh, panel by panel.
///
/// Their constants are those of A. Van Gelder, "Approximate simulation of elastic membranes by triangulated spring meshes"
/// (Journal of Graphics Tools 3(2), 1998), k = E sum A / l² over the edge's triangles, with the modulus of an orthotropic cloth
/// along the edge, 1/E = cos⁴/Kw + sin⁴/Kf + sin² cos²/G.
fn spring_net(scene: &Scene, particles: &Particles) -> Vec<Spring> {
    if let Some(net) = &scene.net {
        return given_net(net, particles);
    }
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
            let (a, b) = (particles.of_vertex[t[i]], particles.of_vertex[t[j]]);
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

fn carried(fibres: &[Fibre], particles: &Particles) -> Vec<Fibre> {
    let carry = |f: &Fibre| Fibre {
        corners: f.corners.map(|v| particles.of_vertex[v]),
        ..*f
    };
    fibres.iter().map(carry).collect()
}

fn given_net(net: &[NetSpring], particles: &Particles) -> Vec<Spring> {
    net.iter()
        .map(|s| Spring {
            a: particles.of_vertex[s.a],
            b: particles.of_vertex[s.b],
            rest_length: s.rest_length_m,
            stiffness: s.stiffness_n_m,
        })
        .filter(|s| s.a != s.b)
        .collect()
}

/// Every triangle with its neighbours, across seams that are welded too: a seam pressed open bends like the cloth.
fn bend_patches(scene: &Scene, particles: &Particles) -> Vec<BendPatch> {
    let sides = sides(scene, particles);
    let least = scene.least_bending_n_m;
    let patch = |(t, fabric, rest): ([usize; 3], Option<&Fabric>, [[f64; 2]; 3])| {
        let rigidity = fabric.map_or([0.0; 2], |f| [f.bending_warp_n_m, f.bending_weft_n_m]);
        let rigidity = rigidity.map(|b| b.max(least));
        if rigidity[0].max(rigidity[1]) <= 0.0 {
            return None;
        }
        let corners = t.map(|v| particles.of_vertex[v]);
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

/// Each triangle with its fabric, if it has one, and its rest positions: in warp-weft coordinates if it has.
fn rest_triangles(
    scene: &Scene,
) -> impl Iterator<Item = ([usize; 3], Option<&Fabric>, [[f64; 2]; 3])> {
    let cut = cut_triangles(scene).map(|(t, fabric, rest)| (t, Some(fabric), rest));
    let bare = scene.mesh.triangles.iter().filter(|_| scene.cut.is_empty());
    cut.chain(bare.map(|t| (*t, None, t.map(|v| scene.mesh.uv[v]))))
}

/// A triangle seen from one of its edges.
struct BendSide {
    /// The particle that is not on the edge.
    far: usize,
    /// Where it lies from the middle of the edge: along it, from its lower to its higher particle, and across \[m\].
    along: f64,
    across: f64,
    /// Whether the edge runs from its lower to its higher particle round the triangle.
    rising: bool,
}

fn sides(scene: &Scene, particles: &Particles) -> BTreeMap<(usize, usize), Vec<BendSide>> {
    let mut sides: BTreeMap<_, Vec<BendSide>> = BTreeMap::new();
    for (t, _, rest) in rest_triangles(scene) {
        for k in 0..3 {
            let (key, side) = side(t.map(|v| particles.of_vertex[v]), rest, k);
            sides.entry(key).or_default().push(side);
        }
    }
    sides
}

/// The edge across from corner `k`, and the triangle seen from it.
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

/// Middle and direction of the edge across from corner `k`, as it runs round the triangle.
fn edge_frame(rest: [[f64; 2]; 3], k: usize) -> ([f64; 2], [f64; 2]) {
    let (p, q) = (rest[(k + 1) % 3], rest[(k + 2) % 3]);
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0].hypot(d[1]);
    (
        [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])],
        [d[0] / length, d[1] / length],
    )
}

/// Where the far corner of the neighbour across from corner `k` lies in the plane of the triangle.
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
