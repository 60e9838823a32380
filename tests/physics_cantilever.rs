//! A strip clamped at one end sags under its weight as the heavy elastica does.
#[path = "support/sheet.rs"]
mod sheet;

use nalgebra::Vector3;
use sheet::{Grid, Sheet, fabric, mean, settled};

const DENSITY: f64 = 0.15;
const LENGTH: f64 = 0.1;

/// The tip of a strip of overhang 0.1 m: how far out and how far down, over the length.
fn tip(gamma: f64, cells: usize, grid: Grid) -> [f64; 2] {
    let h = LENGTH / (cells as f64 + 0.5);
    let rigidity = DENSITY * 9.80665 * LENGTH.powi(3) / gamma;
    let sheet = Sheet {
        size: [LENGTH + 0.5 * h, 0.04],
        cells: [cells + 1, 8],
        grid,
        fabric: fabric(3e4, 3e3, rigidity, DENSITY),
        warp_angle: 0.0,
    };
    // not used yet
    let _ = Vector3::<f64>::zeros();
    let mut scene = sheet.scene(|[u, v]| Vector3::new(u - 0.5 * h, 0.0, v));
    scene.pins = [sheet.column(0), sheet.column(1)].concat();
    let drape = settled(&scene, 1e-7);
    let tip = mean(&drape.positions, &sheet.column(cells + 1));
    let ends: Vec<f64> = sheet
        .column(cells + 1)
        .iter()
        .map(|&v| drape.positions[v].y)
        .collect();
    println!(
        "{gamma} {cells} {grid:?} twist {:.4} iterations {}",
        (ends[0] - ends[8]) / LENGTH,
        drape.report.error_against_run_time.len()
    );
    [tip.x / LENGTH, -tip.y / LENGTH]
}

#[test]
fn explore() {
    for (gamma, x, y) in [
        (1.0, 0.991246, 0.123471),
        (5.0, 0.846657, 0.495905),
        (10.0, 0.656354, 0.7002),
        (20.0, 0.445232, 0.829881),
        (50.0, 0.245015, 0.907917),
    ] {
        for grid in [Grid::Rising, Grid::Falling, Grid::Alternate, Grid::Jittered] {
            for cells in [20, 40] {
                let [tx, ty] = tip(gamma, cells, grid);
                println!("   {:.4} {:.4}", tx - x, ty - y);
            }
        }
    }
}
