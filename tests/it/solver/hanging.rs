//! Hanging cloth: the catenary, stretch under its own weight and a load, order under refinement.

use nalgebra::Vector3;
use seamster::solver::{MembraneModel, SolverOptions};
use seamster_fixtures::sheet::{ClothSheet, GRIDS, SheetGrid, drape, fabric, mean, settled};

const G: f64 = 9.80665;

/// Textbook catenary: length, sag and greatest tension (over w d) of a cloth hung between points d
/// apart, over d.
const CATENARY: [[f64; 3]; 3] = [
    [1.05, 0.139304, 1.058944],
    [1.2, 0.292344, 0.761885],
    [2.0, 0.796388, 1.026029],
];

/// A strip hung by both its ends, 0.3 m apart: sag over d, and tension over w d at the middle of
/// the outermost cell with what the catenary has there.
fn hung(row: [f64; 3], cells: usize) -> (f64, [f64; 2]) {
    let (d, stretch, density) = (0.3, 1e4, 0.15);
    let length = row[0] * d;
    let sheet = ClothSheet {
        size: [length, 0.03],
        cells: [cells, 2],
        grid: SheetGrid::Rising,
        // With bending of 1e-3 of w d³ the ends would be stiff for a thirtieth of d; this is a
        // millionth.
        fabric: fabric(stretch, 100.0, 4e-8, density),
        warp_angle: 0.0,
    };
    // A parabola of about the right sag.
    let mut scene = sheet.scene(|[u, v]| {
        let s = u / length;
        Vector3::new(d * s, -4.0 * row[1] * d * s * (1.0 - s), v)
    });
    scene.pins = [sheet.column(0), sheet.column(cells)].concat();
    let x = settled(&scene, 1e-8).positions;
    let sag = -mean(&x, &sheet.column(cells / 2)).y / d;
    // Nominal tension of the first cell, between its columns: stretch times Green strain times K.
    let cell = length / cells as f64;
    let along = (mean(&x, &sheet.column(1)) - mean(&x, &sheet.column(0))).norm() / cell;
    let tension = along * stretch * 0.5 * (along * along - 1.0);
    let weight = density * G;
    let there = (0.5 * length - 0.5 * cell) * weight;
    let horizontal = ((row[2] * weight * d).powi(2) - (0.5 * length * weight).powi(2)).sqrt();
    (
        sag,
        [tension / weight / d, horizontal.hypot(there) / weight / d],
    )
}

#[test]
fn a_hung_strip_is_a_catenary() {
    for row in CATENARY {
        let (sag, [tension, expected]) = hung(row, 48);
        assert!((sag / row[1] - 1.0).abs() < 5e-3, "{row:?}: {sag}");
        assert!(
            (tension / expected - 1.0).abs() < 0.01,
            "{row:?}: {tension} {expected}"
        );
    }
}

/// The limit of a finer mesh is the catenary of an extensible cloth: 1e-4 of stretch lengthens the
/// sag by about twice that.
#[test]
fn the_sag_of_a_hung_strip_is_of_second_order_in_the_cell() {
    let row = CATENARY[1];
    let [a, b, c] = [6, 12, 24].map(|cells| hung(row, cells).0);
    let order = ((b - a) / (c - b)).log2();
    let limit = c + (c - b) / 3.0;
    assert!((1.7..2.3).contains(&order), "{order}");
    assert!((limit / row[1] - 1.0).abs() < 1e-3, "{limit}");
}

/// Strains of 1e-4 and less: what is not linear in them is below 2e-4.
#[test]
fn a_hanging_strip_stretches_by_its_weight_and_load_over_the_modulus() {
    let (length, width, stretch, density, load) = (1.0, 0.2, 1e4, 0.2, 0.5);
    for membrane in [MembraneModel::Continuum, MembraneModel::Springs] {
        for grid in GRIDS {
            let sheet = ClothSheet {
                size: [length, width],
                cells: [20, 4],
                grid,
                // Springs along diagonals stand for shear; what they add along the warp is of the
                // order of shear over stretch.
                fabric: fabric(stretch, 10.0, 1e-6, density),
                warp_angle: 0.0,
            };
            let mut scene = sheet.scene(|[u, v]| Vector3::new(v, -u, 0.0));
            scene.pins = sheet.column(0);
            let end = sheet.column(20);
            for (j, &v) in end.iter().enumerate() {
                let share = if j == 0 || j == 4 { 0.125 } else { 0.25 };
                scene.mass[v] += load / G * width * share;
            }
            let options = SolverOptions {
                membrane,
                tolerance: 1e-8,
                ..SolverOptions::default()
            };
            let shape = drape(&scene, &options);
            assert!(shape.report.converged, "{}", shape.report.why);
            let longer = -mean(&shape.positions, &end).y - length;
            let exact = density * G * length * length / (2.0 * stretch) + load * length / stretch;
            // Springs have the fabric's moduli only where they lie along its threads.
            if membrane == MembraneModel::Continuum || grid != SheetGrid::Jittered {
                assert!(
                    (longer / exact - 1.0).abs() < 5e-3,
                    "{membrane:?} {grid:?}: {longer}"
                );
            }
        }
    }
}
