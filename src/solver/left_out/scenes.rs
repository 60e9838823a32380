//! Small scenes that have some things and lack others.

use crate::mesh::{ClothMesh, PanelRange, Stitch};
use crate::scene::{Analytic, Body, Cut, Fabric, Membrane, Scene, Wind, library};
use nalgebra::Vector3;

/// Side of a sheet \[m\].
const SIDE: f64 = 0.4;

/// Parts that a scene has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Has {
    pub(crate) body: bool,
    pub(crate) friction: bool,
    pub(crate) wind: bool,
    pub(crate) bending: bool,
    pub(crate) seams: bool,
    pub(crate) gravity: bool,
    pub(crate) self_contact: bool,
}

impl Has {
    /// Only weight.
    pub(crate) const WEIGHT: Self = Self {
        body: false,
        friction: false,
        wind: false,
        bending: false,
        seams: false,
        gravity: true,
        self_contact: false,
    };
    /// Everything.
    pub(crate) const ALL: Self = Self {
        body: true,
        friction: true,
        wind: true,
        bending: true,
        seams: true,
        gravity: true,
        self_contact: true,
    };

    /// Every combination.
    pub(crate) fn combinations() -> impl Iterator<Item = Self> {
        (0_u8..128).map(|bits| Self {
            body: bits & 1 != 0,
            friction: bits & 2 != 0,
            wind: bits & 4 != 0,
            bending: bits & 8 != 0,
            seams: bits & 16 != 0,
            gravity: bits & 32 != 0,
            self_contact: bits & 64 != 0,
        })
    }
}

/// Two sheets side by side of `cells` x `cells` squares each, hung by their upper edges, a ball
/// behind them.
pub(crate) fn scene(has: Has, cells: usize) -> Scene {
    let mut fabric: Fabric = library()["cotton-poplin"].clone();
    if !has.bending {
        fabric.bending_warp_n_m = 0.0;
        fabric.bending_weft_n_m = 0.0;
    }
    let (mesh, start) = sheets(cells, has.seams);
    let cell = (SIDE / cells as f64).powi(2);
    let mut mass = vec![0.0; start.len()];
    for v in mesh.triangles.iter().flatten() {
        mass[*v] += fabric.density_kg_m2 * cell / 6.0;
    }
    let top = |v: &usize| v % (cells + 1) == cells;
    let ball = Analytic::Sphere {
        c: [SIDE, 0.5 * SIDE, -0.1],
        r: 0.1,
    };
    Scene {
        pins: (0..start.len()).filter(top).collect(),
        mesh,
        start,
        mass,
        fabrics: vec![fabric],
        cut: vec![CUT; 2],
        membrane: Membrane::Fabric,
        least_bending_n_m: 0.0,
        body: has.body.then_some(Body::Analytic(ball)),
        body_hardness: 1.0,
        fixed_cloth: None,
        friction: if has.friction { 0.3 } else { 0.0 },
        gravity: Vector3::y() * if has.gravity { -9.80665 } else { 0.0 },
        drag: None,
        fixed_axis: None,
        wind: has.wind.then_some(Wind {
            velocity: Vector3::z(),
            gust: 0.0,
        }),
        layers: vec![],
        carriers: vec![],
        self_contact: has.self_contact,
    }
}

const CUT: Cut = Cut {
    fabric: 0,
    warp_angle: 0.0,
    face_down: false,
};

/// Both sheets, column by column, the second one beside the first; and where they start: a little
/// bent.
fn sheets(cells: usize, sewn: bool) -> (ClothMesh, Vec<Vector3<f64>>) {
    let (mut mesh, mut start) = (ClothMesh::default(), vec![]);
    let rows = cells + 1;
    for panel in 0..2 {
        let (first, first_triangle) = (mesh.uv.len(), mesh.triangles.len());
        for (column, row) in grid(rows) {
            let [u, v] = [column, row].map(|i| SIDE * i as f64 / cells as f64);
            mesh.uv.push([u, v]);
            let bent = 0.01 * (std::f64::consts::PI * v / SIDE).sin();
            start.push(Vector3::new(SIDE * f64::from(panel) + u, v, bent));
        }
        for (column, row) in grid(cells) {
            let a = first + column * rows + row;
            let (b, c, d) = (a + rows, a + rows + 1, a + 1);
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
        mesh.panels.push(PanelRange {
            vertices: first..mesh.uv.len(),
            triangles: first_triangle..mesh.triangles.len(),
            corners: vec![],
        });
    }
    let stitch = |row| Stitch {
        seam: 0,
        stage: 0,
        a: cells * rows + row,
        b: rows * rows + row,
    };
    if sewn {
        mesh.stitches = (0..rows).map(stitch).collect();
    }
    (mesh, start)
}

fn grid(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count * count).map(move |i| (i / count, i % count))
}
