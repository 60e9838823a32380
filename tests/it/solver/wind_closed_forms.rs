//! Cloth at rest in wind: a hung strip takes the angle at which wind and weight balance, a sail
//! held at both ends is a catenary.

use nalgebra::Vector3;
use seamster::scene::{Scene, Wind};
use seamster::solver::{MembraneModel, SolverOptions};
use seamster_fixtures::sheet::{ClothSheet, GRIDS, SheetGrid, drape, fabric, mean, settled};

/// Pressure of wind of `speed` \[m/s\] on cloth across it \[Pa\]: 1.17 (Hoerner, square plate)
/// times half the density of air at 20 °C times the square.
fn pressure(speed: f64) -> f64 {
    0.5 * 1.204 * 1.17 * speed * speed
}

fn steady(velocity: Vector3<f64>) -> Option<Wind> {
    Some(Wind {
        velocity,
        gust: 0.0,
    })
}

/// Across a strip that hangs straight at angle a from the vertical, its weight pulls by w sin a and
/// the wind, of which cos a goes through it, pushes by q cos² a: a straight strip balances at every
/// point where sin a / cos² a = q / w. (Friction goes along it.)
#[test]
fn a_strip_hung_in_a_cross_wind_takes_the_angle_of_balance() {
    let (density, length) = (0.15, 0.4);
    for membrane in [MembraneModel::Continuum, MembraneModel::Springs] {
        for (speed, grid) in [
            (1.0, SheetGrid::Rising),
            (2.0, SheetGrid::Alternate),
            (4.0, SheetGrid::Jittered),
            (10.0, SheetGrid::Falling),
            (20.0, SheetGrid::Alternate),
        ] {
            let sheet = ClothSheet {
                size: [length, 0.1],
                cells: [16, 4],
                grid,
                fabric: fabric(1e5, 1e3, 1e-5, density),
                warp_angle: 0.0,
            };
            let mut scene = sheet.scene(|[u, v]| Vector3::new(v, -u, 1e-3 * u));
            scene.pins = sheet.column(0);
            scene.wind = steady(Vector3::new(0.0, 0.0, speed));
            let options = SolverOptions {
                membrane,
                ..SolverOptions::default()
            };
            let shape = drape(&scene, &options);
            assert!(shape.report.converged, "{speed}: {}", shape.report.why);
            let q = pressure(speed) / (density * 9.80665);
            // q s² + s - q = 0 for the sine: q (1 - s²) = s.
            let exact = (((1.0 + 4.0 * q * q).sqrt() - 1.0) / (2.0 * q)).asin();
            let tip = mean(&shape.positions, &sheet.column(16));
            let angle = tip.z.atan2(-tip.y);
            // r = 1e-5 leaves an angle of that order; stretch of 1e-4 widens the cloth by as much.
            assert!((angle - exact).abs() < 1e-3, "{speed} m/s: {angle} {exact}");
        }
    }
}

/// Bernoulli's velaria: q cos² across the cloth makes d(tan θ)/ds = q / T, which is the catenary's
/// equation, with q for its weight. Length 1.2 d: sag as a hung cloth has it, over d, and
/// everywhere the tension that such a cloth has at its lowest point, over q d. Friction adds a
/// hundredth of sin², here below half a per cent.
#[test]
fn a_sail_held_at_both_ends_is_a_catenary() {
    let (d, speed, stretch, cells) = (0.3, 8.0, 1e5, 48);
    let (sag, tension) = (0.292344, 0.469542);
    let length = 1.2 * d;
    let sheet = ClothSheet {
        size: [length, 0.03],
        cells: [cells, 2],
        grid: SheetGrid::Rising,
        fabric: fabric(stretch, 100.0, 4e-8, 0.15),
        warp_angle: 0.0,
    };
    let mut scene = sheet.scene(|[u, v]| {
        let s = u / length;
        Vector3::new(d * s, v, -4.0 * sag * d * s * (1.0 - s))
    });
    scene.gravity = Vector3::zeros();
    scene.pins = [sheet.column(0), sheet.column(cells)].concat();
    scene.wind = steady(Vector3::new(0.0, 0.0, -speed));
    let shape = settled(&scene, 1e-6);
    let x = &shape.positions;
    let measured = -mean(x, &sheet.column(cells / 2)).z / d;
    assert!((measured / sag - 1.0).abs() < 5e-3, "{measured}");
    let cell = length / cells as f64;
    let along = (mean(x, &sheet.column(1)) - mean(x, &sheet.column(0))).norm() / cell;
    let pull = along * stretch * 0.5 * (along * along - 1.0) / (pressure(speed) * d);
    // Across the wind the tension is the same everywhere, but for friction.
    assert!((pull / tension - 1.0).abs() < 0.01, "{pull}");
}

#[test]
fn without_wind_nothing_of_it_is_there() {
    let sheet = ClothSheet {
        size: [0.2, 0.2],
        cells: [4, 4],
        grid: GRIDS[0],
        fabric: fabric(1e3, 50.0, 1e-5, 0.2),
        warp_angle: 0.0,
    };
    let mut scene = sheet.scene(|[u, v]| Vector3::new(v, -u, 0.0));
    scene.pins = sheet.column(0);
    let names = |scene: &Scene| {
        let report = settled(scene, 1e-5).report;
        let ran = report.terms.iter().any(|t| t.name == "wind");
        (ran, report.skipped_terms.iter().any(|t| t.name == "wind"))
    };
    assert_eq!(names(&scene), (false, true));
    scene.wind = steady(Vector3::new(0.0, 0.0, 2.0));
    assert_eq!(names(&scene), (true, false));
}
