//! A strip that is clamped at one end sags under its weight as the heavy elastica does: B θ'' = -w
//! (L - s) cos θ.
//!
//! `x` and `drop` of the tip over the length, by Γ = w L³ / B, are those of a numerical solution of
//! that equation (Peirce 1930, ASTM D1388; Plaut, Textile Res. J. 2015); within 2 % of L.

use nalgebra::Vector3;
use seamster::mesh::Stitch;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, fabric, mean, settled};

/// Γ, x/L and drop/L of the tip.
const ELASTICA: [[f64; 3]; 6] = [
    [1.0, 0.991246, 0.123471],
    [3.0, 0.931511, 0.339648],
    [5.0, 0.846657, 0.495905],
    [10.0, 0.656354, 0.7002],
    [20.0, 0.445232, 0.829881],
    [50.0, 0.245015, 0.907917],
];
const DENSITY: f64 = 0.15;
const LENGTH: f64 = 0.1;
const WIDTH: f64 = 0.04;

fn strip(gamma: f64, grid: SheetGrid, cells: usize) -> ClothSheet {
    let rigidity = DENSITY * 9.80665 * LENGTH.powi(3) / gamma;
    ClothSheet {
        // The clamp holds the first two columns, and is in the middle between them.
        size: [LENGTH * (1.0 + 0.5 / (cells as f64 - 0.5)), WIDTH],
        cells: [cells, cells * 2 / 5],
        grid,
        fabric: fabric(3e4, 3e3, rigidity, DENSITY),
        warp_angle: 0.0,
    }
}

/// Distance of the tip from the elastica's, over the length, and how much the tip is twisted.
fn error_of_clamped(row: [f64; 3], grid: SheetGrid, cells: usize) -> [f64; 2] {
    let sheet = strip(row[0], grid, cells);
    let clamp = sheet.size[0] - LENGTH;
    let mut scene = sheet.scene(|[u, v]| Vector3::new(u - clamp, 0.0, v));
    scene.pins = [sheet.column(0), sheet.column(1)].concat();
    let x = settled(&scene, 1e-7).positions;
    let end = sheet.column(cells);
    let tip = mean(&x, &end);
    let twist = (x[end[0]].y - x[end[end.len() - 1]].y).abs();
    let off = (tip.x / LENGTH - row[1]).hypot(tip.y / LENGTH + row[2]);
    [off, twist / WIDTH]
}

#[test]
fn a_clamped_strip_sags_as_the_heavy_elastica() {
    for row in ELASTICA {
        for grid in [SheetGrid::Rising, SheetGrid::Falling] {
            let [off, twist] = error_of_clamped(row, grid, 20);
            assert!(
                off < 0.02 && twist < 0.02,
                "{row:?} {grid:?}: {off}, {twist}"
            );
        }
    }
}

/// A cell of half the size is four times as near.
#[test]
fn its_error_is_of_second_order_in_the_cell() {
    let row = ELASTICA[4];
    let [coarse, fine] = [10, 20].map(|cells| error_of_clamped(row, SheetGrid::Rising, cells)[0]);
    let order = (coarse / fine).log2();
    assert!((1.7..2.4).contains(&order), "{order}: {coarse}, {fine}");
}

/// Two strips as the service meshes them, sewn end to end along a line that is held: each hangs as
/// if it were clamped there.
fn error_of_hung(row: [f64; 3], edge_length: f64, turned: bool) -> f64 {
    let strip = strip(row[0], SheetGrid::Rising, 20);
    let mut mesh = if turned {
        // The lattice is laid along the longest edge: a square and more, of which the strip is cut
        // across.
        seamster_fixtures::cut::rectangle_mesh([LENGTH, 1.2 * LENGTH], edge_length)
    } else {
        seamster_fixtures::cut::rectangle_mesh([LENGTH, WIDTH], edge_length)
    };
    let n = mesh.uv.len();
    let held: Vec<usize> = (0..n).filter(|&v| mesh.uv[v][0] == 0.0).collect();
    let end: Vec<usize> = (0..n).filter(|&v| mesh.uv[v][0] == LENGTH).collect();
    mesh.uv.extend_from_within(..);
    mesh.uv[n..].iter_mut().for_each(|p| p[0] = -p[0]);
    mesh.triangles.extend_from_within(..);
    let half = mesh.triangles.len() / 2;
    for t in &mut mesh.triangles[half..] {
        *t = [t[0] + n, t[2] + n, t[1] + n];
    }
    mesh.panels[0].vertices.end = 2 * n;
    mesh.panels[0].triangles.end = 2 * half;
    let stitch = |&v: &usize| Stitch {
        seam: 0,
        stage: 0,
        a: v,
        b: v + n,
    };
    mesh.stitches = held.iter().map(stitch).collect();
    let mut scene = strip.scene_of(mesh, |[u, v]| Vector3::new(u, 0.0, v));
    scene.pins = held;
    let x = settled(&scene, 1e-7).positions;
    let tip = mean(&x, &end);
    (tip.x / LENGTH - row[1]).hypot(tip.y / LENGTH + row[2])
}

#[test]
fn strips_meshed_as_garments_are_sag_as_the_heavy_elastica() {
    for row in [ELASTICA[0], ELASTICA[3], ELASTICA[5]] {
        for (edge_length, turned) in [(0.005, false), (0.005, true)] {
            let off = error_of_hung(row, edge_length, turned);
            assert!(
                off < 0.02,
                "{row:?}, {edge_length} m, turned {turned}: {off}"
            );
        }
    }
}
