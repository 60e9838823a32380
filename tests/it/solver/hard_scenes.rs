//! Scenes in which cloth is bound to meet cloth: at rest, or not and with a cause, and in either
//! case free of crossings, which the judge counts that knows nothing of contact.

use super::self_contact::crossings;
use nalgebra::{Rotation3, Vector3};
use seamster::mesh::Stitch;
use seamster::scene::{Analytic, Body, Scene};
use seamster::solver::{Drape, SolverOptions};
use seamster_fixtures::layers::together;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, drape, fabric, mean};
use std::f64::consts::TAU;

const FRICTION: f64 = 0.3;

fn sheet(size: [f64; 2], cells: [usize; 2]) -> ClothSheet {
    let mut fabric = fabric(1000.0, 300.0, 1e-5, 0.15);
    fabric.friction = FRICTION;
    ClothSheet {
        size,
        cells,
        grid: SheetGrid::Alternate,
        fabric,
        warp_angle: 0.0,
    }
}

fn stitch(a: usize, b: usize) -> Stitch {
    Stitch {
        seam: 0,
        stage: 0,
        a,
        b,
    }
}

/// Drapes a scene that starts without crossings; fails if it ends with one, or neither at rest nor
/// with a cause.
fn draped(scene: &mut Scene) -> Drape {
    scene.self_contact = true;
    assert_eq!(crossings(scene, &scene.start), 0, "at the start");
    let options = SolverOptions {
        tolerance: 1e-3,
        ..SolverOptions::default()
    };
    let shape = drape(scene, &options);
    let report = &shape.report;
    assert_eq!(crossings(scene, &shape.positions), 0, "{}", report.why);
    assert!(report.converged || !report.why.is_empty());
    shape
}

/// A third of the sheet lies folded under the rest of it when it comes to lie on the sphere.
#[test]
fn a_sheet_folded_under_itself_falls_onto_a_sphere() {
    let (radius, half, fold) = (0.07, 0.1, 0.2);
    let sheet = sheet([0.3, 0.2], [20, 13]);
    let mut scene = sheet.scene(|[u, v]| {
        let above = Vector3::new(u - half, 0.083, v - 0.103);
        let under = Vector3::new(2.0 * fold - u - half, 0.078, v - 0.103);
        if u <= fold + 1e-9 { above } else { under }
    });
    scene.body = Some(Body::Analytic(Analytic::Sphere {
        c: [0.0; 3],
        r: radius,
    }));
    let shape = draped(&mut scene);
    // It lies on the sphere and hangs down beside it.
    let height = |u: usize, v: usize| shape.positions[sheet.vertex(u, v)].y;
    assert!(
        height(0, 6) < 0.06 && height(7, 6) > radius,
        "{}",
        height(0, 6)
    );
}

/// Ribbons across each other on a floor.
#[test]
fn five_ribbons_fall_onto_a_pile() {
    let sheet = sheet([0.2, 0.03], [14, 2]);
    let ribbon = |number: usize| {
        let turn = Rotation3::new(Vector3::y() * (0.2 + 1.1 * number as f64));
        let aside = Vector3::new(0.002, 0.0, 0.001) * number as f64;
        let height = 0.01 + 0.008 * number as f64;
        sheet.scene(|[u, v]| turn * Vector3::new(u - 0.1, height, v - 0.015) + aside)
    };
    let mut scene = together((0..5).map(ribbon).collect());
    scene.body = Some(Body::Analytic(Analytic::HalfSpace {
        c: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
    }));
    let shape = draped(&mut scene);
    let each = scene.start.len() / 5;
    // All meet in the middle: the top one lies on four, which their weight presses by a tenth of
    // their thickness at most.
    let middle = |number: usize| {
        let of = |row: usize| number * each + sheet.vertex(7, row);
        mean(&shape.positions, &[of(0), of(1), of(2)]).y
    };
    let height = middle(4) - middle(0);
    assert!(height > 3.6e-3, "{height}");
}

/// A tube of `columns` x `rows` cells about the y axis, closed by a seam; `place` puts (angle, v).
fn tube((sheet, rows): (&ClothSheet, usize), place: impl Fn(f64, f64) -> Vector3<f64>) -> Scene {
    let [length, _] = sheet.size;
    let mut scene = sheet.scene(|[u, v]| {
        // Ends a little apart, since stitches are to be closed.
        let angle = (TAU - 0.01) * u / length;
        place(angle, v)
    });
    let ends = (0..=rows).map(|j| stitch(sheet.vertex(0, j), sheet.vertex(sheet.cells[0], j)));
    scene.mesh.stitches = ends.collect();
    scene
}

/// Both ends of a sleeve are held so near each other on the arm that it must lie in rings.
#[test]
fn a_sleeve_is_pushed_up_an_arm() {
    let (arm, radius, length) = (0.04, 0.05, 0.2);
    let sheet = sheet([TAU * radius, length], [22, 14]);
    let mut scene = tube((&sheet, 14), |angle, v| {
        let r = radius + 0.006 * (TAU * v / 0.0571).cos();
        Vector3::new(r * angle.cos(), 0.5 * v, -r * angle.sin())
    });
    scene.pins = (0..=22)
        .flat_map(|i| [sheet.vertex(i, 0), sheet.vertex(i, 14)])
        .collect();
    scene.body = Some(Body::Analytic(Analytic::Capsule {
        a: [0.0, -0.2, 0.0],
        b: [0.0, 0.4, 0.0],
        r: arm,
    }));
    draped(&mut scene);
}
