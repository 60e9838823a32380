//! Three vertices and three hundred thousand.

use super::cloth::{hung, poplin};
use super::{Case, Expect, Made};
use nalgebra::Vector3;
use seamster::mesh::{ClothMesh, PanelRange};
use seamster::scene::{Cut, Scene};
use seamster::solver::Method;

/// CPU time allowed to the largest mesh \[s\].
const TIME_LIMIT: f64 = 60.0;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for method in [
        Method::Newton,
        Method::SymplecticEuler,
        Method::Verlet,
        Method::ImplicitEuler,
        Method::Bdf2,
    ] {
        let case = Case::new(format!("size: 3 vertices, {}", method.name()), move || {
            Made::drape(triangle(), method).asking(|ask| ask.tolerance = 1e-4)
        });
        // It may turn about the vertical through its pin: along that the second derivative is rounding.
        cases.push(match method {
            Method::ImplicitEuler => case.known("is called valid"),
            _ => case,
        });
    }
    cases.push(
        Case::new("size: 300 000 vertices", || {
            Made::drape(hung(poplin(), 546), Method::Newton)
                .asking(|ask| ask.time_limit_s = Some(TIME_LIMIT))
        })
        .expect(Expect::NotConverged("the time allowed was up"))
        .within(1.5 * TIME_LIMIT)
        .whole_only(),
    );
    cases
}

/// One triangle that hangs by a corner.
fn triangle() -> Scene {
    let uv = vec![[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]];
    let mesh = ClothMesh {
        triangles: vec![[0, 1, 2]],
        panels: vec![PanelRange {
            vertices: 0..3,
            triangles: 0..1,
            corners: vec![],
        }],
        stitches: vec![],
        uv,
    };
    let fabric = poplin();
    let mass = fabric.density_kg_m2 * 0.005 / 3.0;
    Scene {
        start: mesh
            .uv
            .iter()
            .map(|p| Vector3::new(p[0], 0.0, p[1]))
            .collect(),
        mesh,
        mass: vec![mass; 3],
        friction: 0.0,
        fabrics: vec![fabric],
        cut: vec![Cut {
            fabric: 0,
            warp_angle: 0.0,
            face_down: false,
        }],
        net: None,
        body: None,
        gravity: Vector3::new(0.0, -9.80665, 0.0),
        pins: vec![0],
        held_axis: None,
        fibres: None,
        least_bending_n_m: 0.0,
        drag: None,
        wind: None,
    }
}
