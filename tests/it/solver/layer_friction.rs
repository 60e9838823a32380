//! Friction between layers of cloth, against the law of Coulomb.

use nalgebra::{Rotation3, Vector3};
use seamster::scene::Scene;
use seamster::solver::{Drape, SolverOptions};
use seamster_fixtures::layers::together;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, drape, fabric, mean};

const GRAVITY: f64 = 9.80665;
const FRICTION: f64 = 0.4;
const THICKNESS: f64 = 1e-3;

fn sheet(size: [f64; 2], cells: [usize; 2], friction: f64) -> ClothSheet {
    let mut fabric = fabric(1000.0, 300.0, 1e-5, 0.15);
    fabric.friction = friction;
    ClothSheet {
        size,
        cells,
        grid: SheetGrid::Alternate,
        fabric,
        warp_angle: 0.0,
    }
}

/// A sheet on a fixed one, both in a plane down which weight pulls with `slope` times the force
/// that presses them together.
fn on_an_incline(slope: f64, friction: [f64; 2]) -> Scene {
    let table = sheet([0.3, 0.12], [15, 6], friction[0]);
    let cloth = sheet([0.08, 0.06], [5, 4], friction[1]);
    let mut fixed = table.scene(|[u, v]| Vector3::new(u, 0.0, v));
    fixed.pins = (0..fixed.start.len()).collect();
    fixed.gravity = Vector3::new(slope, -1.0, 0.0).normalize() * GRAVITY;
    // Slightly turned, so that no edges of the two are parallel.
    let turn = Rotation3::new(Vector3::y() * 0.1);
    let place = |[u, v]: [f64; 2]| turn * Vector3::new(u + 0.023, 0.97 * THICKNESS, v + 0.031);
    together(vec![fixed, cloth.scene(place)])
}

/// How it ends, and how far the upper sheet slid \[m\].
fn slid(scene: &Scene) -> (Drape, f64) {
    let options = SolverOptions {
        tolerance: 1e-4,
        ..SolverOptions::default()
    };
    let shape = drape(scene, &options);
    let upper: Vec<_> = (16 * 7..scene.start.len()).collect();
    let way = mean(&shape.positions, &upper) - mean(&scene.start, &upper);
    (shape, way.x)
}

/// Two percent to either side of the threshold; the smaller of two coefficients counts. What sticks
/// gives way by μ p over the stiffness of its ties at most, 0.6 micrometers.
#[test]
fn a_sheet_on_a_sheet_sticks_below_the_angle_of_friction_and_slides_above() {
    for friction in [[FRICTION, 1.0], [1.0, FRICTION]] {
        let (shape, way) = slid(&on_an_incline(0.98 * FRICTION, friction));
        assert!(shape.report.converged, "{}", shape.report.why);
        assert!(way > 0.0 && way < 6e-7, "{way}");
        let (shape, way) = slid(&on_an_incline(1.02 * FRICTION, friction));
        assert!(!shape.report.converged && way > 0.3, "{way}");
    }
}
