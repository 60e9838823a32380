//! Friction between layers of cloth, against the law of Coulomb.

use nalgebra::{Rotation3, Vector3};
use seamster::scene::{FixedCloth, Scene};
use seamster::solver::{Drape, SolverOptions};
use seamster_fixtures::layers::together;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, drape, fabric, mean};
use std::sync::Arc;

const GRAVITY: f64 = 9.80665;
const FRICTION: f64 = 0.4;
const THICKNESS: f64 = 1e-3;
/// How far what sticks gives way at most: μ p over the stiffness of its ties \[m\].
const GIVE: f64 = 6e-7;

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

/// A sheet at rest in the plane y = 0.
fn table(friction: f64) -> Scene {
    let table = sheet([0.3, 0.12], [15, 6], friction);
    let mut scene = table.scene(|[u, v]| Vector3::new(u, 0.0, v));
    scene.pins = (0..scene.start.len()).collect();
    scene
}

/// A sheet on the table.
fn cloth(friction: f64) -> Scene {
    // Slightly turned, so that no edges of the two are parallel.
    let turn = Rotation3::new(Vector3::y() * 0.1);
    let place = |[u, v]: [f64; 2]| turn * Vector3::new(u + 0.023, 0.97 * THICKNESS, v + 0.031);
    sheet([0.08, 0.06], [5, 4], friction).scene(place)
}

/// Gravity that pulls down the plane with `slope` times the force that presses layers together.
fn inclined(slope: f64) -> Vector3<f64> {
    Vector3::new(slope, -1.0, 0.0).normalize() * GRAVITY
}

/// A sheet on a pinned one, both on an incline.
fn on_pinned_cloth(slope: f64, friction: [f64; 2]) -> Scene {
    let mut scene = together(vec![table(friction[0]), cloth(friction[1])]);
    scene.gravity = inclined(slope);
    scene
}

/// The same on cloth that is no part of the garment, of this friction at each place along it \[m\].
fn on_fixed_cloth(slope: f64, of_fixed: impl Fn(f64) -> f64, friction: f64) -> Scene {
    let table = table(0.0);
    let of_vertex = |p: &Vector3<f64>| of_fixed(p.x);
    let mut scene = cloth(friction);
    scene.self_contact = true;
    scene.gravity = inclined(slope);
    scene.fixed_cloth = Some(Arc::new(FixedCloth {
        thickness_m: vec![THICKNESS; table.start.len()],
        friction: table.start.iter().map(of_vertex).collect(),
        vertices: table.start,
        triangles: table.mesh.triangles,
        panels: vec![],
    }));
    scene
}

/// How it ends, and how far the sheet whose vertices begin at `first` slid \[m\].
fn slid(scene: &Scene, first: usize) -> (Drape, f64) {
    let options = SolverOptions {
        tolerance: 1e-4,
        ..SolverOptions::default()
    };
    let shape = drape(scene, &options);
    let upper: Vec<_> = (first..scene.start.len()).collect();
    let way = mean(&shape.positions, &upper) - mean(&scene.start, &upper);
    (shape, way.x)
}

fn assert_sticks(scene: &Scene, first: usize) {
    let (shape, way) = slid(scene, first);
    assert!(shape.report.converged, "{}", shape.report.why);
    assert!(way > 0.0 && way < GIVE, "{way}");
}

/// Asserts that there is no rest, and that the sheet went further than what sticks ever gives way.
fn assert_slides(scene: &Scene, first: usize) {
    let (shape, way) = slid(scene, first);
    let why = &shape.report.why;
    assert!(!shape.report.converged && way > 1e3 * GIVE, "{way}: {why}");
}

/// Two percent to either side of the threshold; the smaller of two coefficients counts.
#[test]
fn a_sheet_on_a_sheet_sticks_below_the_angle_of_friction_and_slides_above() {
    let first = table(0.0).start.len();
    for friction in [[FRICTION, 1.0], [1.0, FRICTION]] {
        assert_sticks(&on_pinned_cloth(0.98 * FRICTION, friction), first);
        assert_slides(&on_pinned_cloth(1.02 * FRICTION, friction), first);
    }
}

#[test]
fn a_garment_over_another_sticks_below_the_angle_of_the_smaller_friction_and_slides_above() {
    for [beneath, above] in [[FRICTION, 1.0], [1.0, FRICTION]] {
        let on = |slope: f64| on_fixed_cloth(slope, |_| beneath, above);
        assert_sticks(&on(0.98 * FRICTION), 0);
        assert_slides(&on(1.02 * FRICTION), 0);
    }
}

/// The sheet lies on the upper part of an inner garment of two fabrics: that one counts.
#[test]
fn of_an_inner_garment_the_fabric_counts_that_is_touched() {
    let upper = 0.13;
    let rough_above = |x: f64| if x < upper { 1.0 } else { FRICTION };
    assert_sticks(&on_fixed_cloth(1.02 * FRICTION, rough_above, 1.0), 0);
    let smooth_above = |x: f64| if x < upper { FRICTION } else { 1.0 };
    let (_, way) = slid(&on_fixed_cloth(1.02 * FRICTION, smooth_above, 1.0), 0);
    // Until so much of it lies on the rough part that it holds.
    assert!(way > 0.0 && way < 0.3, "{way}");
}
