//! Spring nets on grids, by the rules under which other simulators have run them: SI units, z up, cloth of 0.2 kg/m².
//!
//! A panel is a grid of vertices. Springs: structural ones along the grid lines, k = E h w / l with the width w that a line
//! carries (a cell, half a one at the border) and its rest length l; shear ones on both diagonals of every cell, a quarter of
//! E h; bend ones between every other vertex of a line. Where a grid line is moved, constants change as 1 / l.
//! Triangles: cells split along alternating diagonals, a third of their mass to each vertex.

use seamster::scene::{Analytic, NetSpring, RawScene};

/// Modulus times thickness of the soft net \[N/m\].
const STRETCH: f64 = 2000.0;
/// Share of it that a shear spring has.
const SHEAR_SHARE: f64 = 0.25;
/// Stiffness of a bend spring of any net \[N/m\].
const BEND: f64 = 40.0;
/// Mass per area \[kg/m²\].
const DENSITY: f64 = 0.2;
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// How near the moved line of S1T is to its neighbour \[m\].
const SLIVER: f64 = 5e-4;
/// Stiffness of the stitches of S3 in its own rules \[N/m\].
pub(crate) const SEAM_STIFFNESS: f64 = 500.0;

/// What is hung or dropped on what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// A square hung by two corners that are as far apart as the cloth is wide, held in its plane.
    PlanarHang,
    /// The same with its middle line moved next to its neighbour: triangles of 60 to 1.
    Slivers,
    /// A square dropped on a sphere.
    Sphere,
    /// Two panels sewn to a tube round an upright capsule.
    Capsule,
}

impl Family {
    /// The family that the data calls so.
    pub(crate) fn named(name: &str) -> Option<Self> {
        match name {
            "S1P" => Some(Self::PlanarHang),
            "S1T" => Some(Self::Slivers),
            "S2" => Some(Self::Sphere),
            "S3" => Some(Self::Capsule),
            _ => None,
        }
    }

    /// Rows of vertices of the size that others have run.
    pub(crate) fn rows(self) -> usize {
        match self {
            Self::Capsule => 41,
            _ => 33,
        }
    }
}

/// A net to make.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Net {
    pub(crate) family: Family,
    /// Rows of vertices of a panel.
    pub(crate) rows: usize,
    /// By how much stretch and shear are stiffer than those of the soft net.
    pub(crate) stiffer: f64,
}

/// The grid of one panel: rest coordinates of its columns and rows \[m\], and the cell of the even grid.
struct Grid {
    columns: Vec<f64>,
    rows: Vec<f64>,
    cell: [f64; 2],
}

impl Net {
    /// The scene.
    pub(crate) fn scene(&self) -> RawScene {
        let panel_count = if self.family == Family::Capsule { 2 } else { 1 };
        let grid = self.grid();
        let mut scene = RawScene {
            gravity_m_s2: GRAVITY,
            ..RawScene::default()
        };
        for panel in 0..panel_count {
            grid.add_to(&mut scene, STRETCH * self.stiffer);
            let start = |&[u, v]: &[f64; 2]| self.start(panel, u, v);
            let added = &scene.uv_m[scene.start_m.len()..];
            scene.start_m.extend(added.iter().map(start));
        }
        self.surround(&grid, &mut scene);
        scene
    }

    fn grid(&self) -> Grid {
        let even = |count: usize, length: f64| -> Vec<f64> {
            (0..count)
                .map(|i| length * i as f64 / (count - 1) as f64)
                .collect()
        };
        let (columns, [width, height]) = match self.family {
            Family::Capsule => ((self.rows - 1) * 28 / 40 + 1, [0.5, 0.7]),
            _ => (self.rows, [1.0, 1.0]),
        };
        let mut grid = Grid {
            columns: even(columns, width),
            rows: even(self.rows, height),
            cell: [
                width / (columns - 1) as f64,
                height / (self.rows - 1) as f64,
            ],
        };
        if self.family == Family::Slivers {
            let middle = columns / 2;
            grid.columns[middle] = grid.columns[middle - 1] + SLIVER;
        }
        grid
    }

    /// Where the point (u, v) of a panel starts.
    fn start(&self, panel: usize, u: f64, v: f64) -> [f64; 3] {
        match self.family {
            Family::PlanarHang | Family::Slivers => [u - 0.5, 0.0, -v],
            Family::Sphere => [u - 0.5, v - 0.5, 0.26],
            Family::Capsule => [u - 0.25, if panel == 0 { -0.15 } else { 0.15 }, 0.35 - v],
        }
    }

    /// Pins, stitches, the body and what damps.
    fn surround(&self, grid: &Grid, scene: &mut RawScene) {
        let (nx, ny) = (grid.columns.len(), grid.rows.len());
        match self.family {
            Family::PlanarHang | Family::Slivers => {
                scene.pins = vec![0, nx - 1];
                scene.held_axis = Some(1);
                scene.drag_1_s = Some(20.0);
            }
            Family::Sphere => {
                scene.body = Some(Analytic::Sphere {
                    c: [0.0; 3],
                    r: 0.25,
                });
            }
            Family::Capsule => {
                scene.pins = vec![nx / 2];
                let sides = [0, nx - 1];
                let row = |j: usize| sides.map(|i| [j * nx + i, (ny + j) * nx + i]);
                // one side from top to bottom, then the other
                for side in 0..2 {
                    scene.stitches.extend((0..ny).map(|j| row(j)[side]));
                }
                scene.body = Some(Analytic::Capsule {
                    a: [0.0, 0.0, -1.0],
                    b: [0.0, 0.0, 1.0],
                    r: 0.12,
                });
            }
        }
        if scene.body.is_some() {
            scene.friction = 0.3;
            scene.drag_1_s = Some(2.0);
        }
    }
}

impl Grid {
    /// Adds a panel to `scene`, all but its start.
    fn add_to(&self, scene: &mut RawScene, stretch: f64) {
        let (nx, ny) = (self.columns.len(), self.rows.len());
        let first = scene.uv_m.len();
        let at = |i: usize, j: usize| first + j * nx + i;
        for &v in &self.rows {
            scene.uv_m.extend(self.columns.iter().map(|&u| [u, v]));
        }
        for j in 0..ny {
            for i in 0..nx {
                self.springs_of([i, j], first, stretch, &mut scene.springs);
            }
        }
        let before = scene.triangles.len();
        for (j, i) in (0..ny - 1).flat_map(|j| (0..nx - 1).map(move |i| (j, i))) {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
            scene.triangles.extend(if (i + j) % 2 == 0 {
                [[a, b, d], [a, d, c]]
            } else {
                [[a, b, c], [b, d, c]]
            });
        }
        scene.mass_kg.resize(scene.uv_m.len(), 0.0);
        for triangle in &scene.triangles[before..] {
            let [p, q, r] = triangle.map(|v| scene.uv_m[v]);
            let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
            for &v in triangle {
                scene.mass_kg[v] += DENSITY * area / 3.0;
            }
        }
    }

    /// Springs from the vertex (i, j) to those right of it and below.
    fn springs_of(&self, [i, j]: [usize; 2], first: usize, stretch: f64, net: &mut Vec<NetSpring>) {
        let (nx, ny) = (self.columns.len(), self.rows.len());
        let [hx, hy] = self.cell;
        let border = |k: usize, count: usize| if k == 0 || k == count - 1 { 0.5 } else { 1.0 };
        // `to` with the constant and the length that the spring has in the even grid
        let mut add = |from: [usize; 2], to: [usize; 2], stiffness: f64, length: f64| {
            if from[0] < nx && to[0] < nx && to[1] < ny {
                let (du, dv) = (
                    self.columns[to[0]] - self.columns[from[0]],
                    self.rows[to[1]] - self.rows[from[1]],
                );
                let rest_length_m = du.hypot(dv);
                net.push(NetSpring {
                    a: first + from[1] * nx + from[0],
                    b: first + to[1] * nx + to[0],
                    rest_length_m,
                    stiffness_n_m: stiffness * length / rest_length_m,
                });
            }
        };
        let diagonal = hx.hypot(hy);
        add([i, j], [i + 1, j], stretch * border(j, ny) * hy / hx, hx);
        add([i, j], [i, j + 1], stretch * border(i, nx) * hx / hy, hy);
        add([i, j], [i + 1, j + 1], SHEAR_SHARE * stretch, diagonal);
        add([i + 1, j], [i, j + 1], SHEAR_SHARE * stretch, diagonal);
        add([i, j], [i + 2, j], BEND, 2.0 * hx);
        add([i, j], [i, j + 2], BEND, 2.0 * hy);
    }
}
