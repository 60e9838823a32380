//! A tube of poplin over a horizontal cylinder, as a roller towel hangs: two rectangular panels in front of the cylinder
//! and behind it, sewn along their upper and lower edges, without friction. y is up, the cylinder lies along x.
//!
//! Without friction nothing but a pin keeps such a tube from rolling round and sliding along: the middle of the front panel's
//! line of contact is pinned where it hangs anyway.

use super::panels::{pattern, rectangle, run, seam};
use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::mesh::{ClothMesh, triangulate};
use seamster::progress::CancelToken;
use seamster::scene::{Analytic, Cut, Fabric, RawScene, Scene, library};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

/// Width along the cylinder and height of a panel \[m\].
const SIZE: [f64; 2] = [0.6, 0.8];
/// Radius of the cylinder \[m\].
const RADIUS: f64 = 0.15;
/// Room between the cylinder and the panels at the start \[m\]: about what contact keeps.
const ROOM: f64 = 2.5e-3;

/// A tube of about this many vertices, so many times stiffer than poplin in stretch and shear.
pub(crate) fn tube(vertex_count: usize, stiffer: f64) -> Scene {
    let mesh = mesh(vertex_count);
    let start_radius = RADIUS + ROOM;
    // the seam closes on top of the cylinder without a stretch
    let top = FRAC_PI_2 * start_radius;
    let mut start: Vec<Vector3<f64>> = Vec::new();
    for (panel, z) in mesh.panels.iter().zip([start_radius, -start_radius]) {
        let place = |[u, v]: [f64; 2]| Vector3::new(u - SIZE[0] / 2.0, top - SIZE[1] + v, z);
        start.extend(mesh.uv[panel.vertices.clone()].iter().copied().map(place));
    }
    let poplin = &library()["cotton-poplin"];
    let fabric = Fabric {
        stretch_warp_n_m: stiffer * poplin.stretch_warp_n_m,
        stretch_weft_n_m: stiffer * poplin.stretch_weft_n_m,
        shear_n_m: stiffer * poplin.shear_n_m,
        ..poplin.clone()
    };
    let cut = Cut {
        fabric: 0,
        warp_angle: FRAC_PI_2,
        face_down: false,
    };
    let from_middle = |v: &usize| start[*v].x.hypot(start[*v].y);
    let pin = mesh.panels[0]
        .vertices
        .clone()
        .min_by(|v, w| from_middle(v).total_cmp(&from_middle(w)))
        .expect("a panel has vertices");
    let raw = RawScene {
        start_m: start.into_iter().map(Into::into).collect(),
        mass_kg: masses(&mesh, fabric.density_kg_m2),
        pins: vec![pin],
        body: Some(Analytic::Cylinder {
            c: [0.0; 3],
            axis: [1.0, 0.0, 0.0],
            r: RADIUS,
        }),
        gravity_m_s2: [0.0, -9.80665, 0.0],
        ..RawScene::default()
    };
    Scene {
        mesh,
        fabrics: vec![fabric],
        cut: vec![
            cut,
            Cut {
                face_down: true,
                ..cut
            },
        ],
        net: None,
        ..raw.into_scene(&Limits::default()).expect("a tube is right")
    }
}

/// Two rectangles with their seams, unstructured as any garment's mesh.
fn mesh(vertex_count: usize) -> ClothMesh {
    let [width, height] = SIZE;
    let panels = vec![
        rectangle("front", width, height),
        rectangle("back", width, height),
    ];
    let pattern = pattern(panels);
    let side = |name, from, to| seam(name, run("front", from, to), run("back", from, to));
    let pairs = [side("top", 1, 2), side("bottom", 3, 0)];
    // an even triangle mesh of edge h has 2 / (sqrt(3) h²) vertices per area
    let edge_length = (2.0 / 3f64.sqrt() * 2.0 * width * height / vertex_count as f64).sqrt();
    let limits = Limits::default();
    let faces = BTreeMap::new();
    let (_, seams) = seamster::seam::check(&pattern, &pairs, &faces, edge_length, &limits);
    let seams = seams.expect("the two seams of a tube are right");
    triangulate(&pattern, &seams, edge_length, &limits, &CancelToken::new())
        .expect("a rectangle can be meshed")
}

fn masses(mesh: &ClothMesh, density: f64) -> Vec<f64> {
    let mut mass = vec![0.0; mesh.uv.len()];
    for triangle in &mesh.triangles {
        let [p, q, r] = triangle.map(|v| mesh.uv[v]);
        let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
        for &v in triangle {
            mass[v] += density * area / 3.0;
        }
    }
    mass
}
