//! Rectangles of cloth as scenes built by hand, meshed in several ways, and the shapes that they come to.
//!
//! Pattern coordinates (u, v) run along length and width \[m\]; the warp lies along u unless it is turned.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::mesh::{ClothMesh, PanelRange};
use seamster::progress::{CancelToken, Progress};
use seamster::scene::{Cut, Fabric, Scene};
use seamster::solver::{self, Context, Drape, Simulate};

/// How the cells of a sheet are cut into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// From the lower left to the upper right corner.
    Rising,
    /// From the upper left to the lower right corner.
    Falling,
    /// Rising and falling in turns.
    Alternate,
    /// As alternate, with all inner vertices moved by up to a quarter of a cell, the same every time.
    Jittered,
}

pub const GRIDS: [Grid; 4] = [Grid::Rising, Grid::Falling, Grid::Alternate, Grid::Jittered];

/// A rectangle of cloth.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Length and width \[m\].
    pub size: [f64; 2],
    /// Cells along both.
    pub cells: [usize; 2],
    pub grid: Grid,
    pub fabric: Fabric,
    /// Direction of the warp, counter-clockwise from u \[rad\].
    pub warp_angle: f64,
}

/// A fabric of the same moduli along warp and weft: stretch and shear \[N/m\], bending \[N m\], mass per area \[kg/m²\].
pub fn fabric(stretch: f64, shear: f64, bending: f64, density: f64) -> Fabric {
    Fabric {
        name: "test".to_owned(),
        density_kg_m2: density,
        thickness_m: 1e-3,
        stretch_warp_n_m: stretch,
        stretch_weft_n_m: stretch,
        shear_n_m: shear,
        bending_warp_n_m: bending,
        bending_weft_n_m: bending,
        friction: 0.0,
        damping_ratio: 0.0,
        source: "made for a test".to_owned(),
    }
}

impl Sheet {
    /// The vertex in column `i` along the length and row `j` across it.
    pub fn vertex(&self, i: usize, j: usize) -> usize {
        i * (self.cells[1] + 1) + j
    }

    /// The vertices of column `i`.
    pub fn column(&self, i: usize) -> Vec<usize> {
        (0..=self.cells[1]).map(|j| self.vertex(i, j)).collect()
    }

    /// All vertices on its border.
    pub fn border(&self) -> Vec<usize> {
        let [m, n] = self.cells;
        let inside = |i: usize, j: usize| i > 0 && i < m && j > 0 && j < n;
        let all = (0..=m).flat_map(|i| (0..=n).map(move |j| (i, j)));
        all.filter(|&(i, j)| !inside(i, j))
            .map(|(i, j)| self.vertex(i, j))
            .collect()
    }

    fn uv(&self) -> Vec<[f64; 2]> {
        let mut random = random();
        let [m, n] = self.cells;
        let cell = [self.size[0] / m as f64, self.size[1] / n as f64];
        let mut uv = Vec::new();
        for i in 0..=m {
            for j in 0..=n {
                let inner = i > 0 && i < m && j > 0 && j < n;
                let jitter = if self.grid == Grid::Jittered && inner {
                    [random() * 0.5, random() * 0.5]
                } else {
                    [0.0; 2]
                };
                uv.push([
                    (i as f64 + jitter[0]) * cell[0],
                    (j as f64 + jitter[1]) * cell[1],
                ]);
            }
        }
        uv
    }

    fn triangles(&self) -> Vec<[usize; 3]> {
        let mut triangles = Vec::new();
        for i in 0..self.cells[0] {
            for j in 0..self.cells[1] {
                let [a, b] = [self.vertex(i, j), self.vertex(i + 1, j)];
                let [c, d] = [self.vertex(i + 1, j + 1), self.vertex(i, j + 1)];
                let rising = match self.grid {
                    Grid::Rising => true,
                    Grid::Falling => false,
                    Grid::Alternate | Grid::Jittered => (i + j) % 2 == 0,
                };
                triangles.extend(if rising {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                });
            }
        }
        triangles
    }

    /// The scene with every vertex where `place` puts its (u, v), under standard gravity along -y, no body, nothing pinned.
    pub fn scene(&self, place: impl Fn([f64; 2]) -> Vector3<f64>) -> Scene {
        let (uv, triangles) = (self.uv(), self.triangles());
        let panel = PanelRange {
            vertices: 0..uv.len(),
            triangles: 0..triangles.len(),
            corners: vec![],
        };
        let mesh = ClothMesh {
            uv,
            triangles,
            panels: vec![panel],
            stitches: vec![],
        };
        self.scene_of(mesh, place)
    }

    /// The same with another mesh of one panel.
    pub fn scene_of(&self, mesh: ClothMesh, place: impl Fn([f64; 2]) -> Vector3<f64>) -> Scene {
        let (uv, triangles) = (&mesh.uv, &mesh.triangles);
        let mut mass = vec![0.0; uv.len()];
        for t in triangles {
            let [p, q, r] = t.map(|v| uv[v]);
            let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
            assert!(area > 0.0, "a triangle is turned over");
            for v in t {
                mass[*v] += self.fabric.density_kg_m2 * area / 3.0;
            }
        }
        Scene {
            start: uv.iter().map(|p| place(*p)).collect(),
            mesh,
            mass,
            friction: self.fabric.friction,
            fabrics: vec![self.fabric.clone()],
            cut: vec![Cut {
                fabric: 0,
                warp_angle: self.warp_angle,
                face_down: false,
            }],
            net: None,
            body: None,
            gravity: Vector3::new(0.0, -9.80665, 0.0),
            pins: vec![],
            held_axis: None,
            fibres: None,
            least_bending_n_m: 0.0,
            drag: None,
            wind: None,
        }
    }
}

/// Numbers from -0.5 to 0.5, the same every time.
pub fn random() -> impl FnMut() -> f64 {
    let mut seed = 7_u32;
    move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24) - 0.5
    }
}

/// Drapes without a clock.
pub fn drape(scene: &Scene, ask: &Simulate) -> Drape {
    let mut quiet = |_: Progress| {};
    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &CancelToken::new(),
        progress: &mut quiet,
        limits: &Limits::default(),
    };
    solver::drape(scene, ask, &mut context)
}

/// The shape at rest; fails where there is none.
pub fn settled(scene: &Scene, tolerance: f64) -> Drape {
    let ask = Simulate {
        tolerance,
        ..Simulate::default()
    };
    let drape = drape(scene, &ask);
    assert!(drape.report.converged, "{}", drape.report.why);
    drape
}

/// The energies of `scene` as it starts: with everything pinned it is at rest there.
pub fn energy_of_start(scene: &Scene, ask: &Simulate) -> solver::Energy {
    let pinned = Scene {
        pins: (0..scene.start.len()).collect(),
        ..scene.clone()
    };
    drape(&pinned, ask).report.energy_j
}

/// Mean position of some vertices \[m\].
pub fn mean(x: &[Vector3<f64>], vertices: &[usize]) -> Vector3<f64> {
    vertices.iter().map(|&v| x[v]).sum::<Vector3<f64>>() / vertices.len() as f64
}
