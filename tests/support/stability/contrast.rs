//! Very unlike things side by side: warp and weft, masses, the sides of a triangle, springs without length.

use super::cloth::{arc, hung, poplin, sheet};
use super::scenes::net::{Family, Net};
use super::{Case, Expect, Made, Work};
use seamster::config::Limits;
use seamster::scene::{Fabric, NetSpring, RawScene, Scene};
use seamster::solver::{Membrane, Method, Simulate};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for membrane in [Membrane::Continuum, Membrane::Springs] {
        let name = |what: &str| match membrane {
            Membrane::Continuum => format!("contrast: {what}, continuum"),
            Membrane::Springs => format!("contrast: {what}, springs"),
        };
        let newton = move |scene: Scene| {
            Made::drape(scene, Method::Newton).asking(|ask| ask.membrane = membrane)
        };
        cases.push(Case::new(name("warp to weft 1e4 to 1"), move || {
            newton(hung(unlike(), 12))
        }));
        let masses = Case::new(name("masses 1 to 1e4, in turns"), move || {
            newton(heavy(|i| i % 2 == 0))
        });
        // 65 kg hang on it: with springs, which stretch more, its middle sinks by so much that it is taken to fall.
        cases.push(match membrane {
            Membrane::Continuum => masses,
            Membrane::Springs => masses.expect(Expect::NotConverged("fell off")),
        });
        cases.push(Case::new(
            name("one vertex 1e4 times as heavy"),
            move || newton(heavy(|i| i == 12 * 13 / 2)),
        ));
        cases.push(Case::new(name("slivers 1e-4"), move || newton(slivers())));
    }
    cases.push(Case::new("contrast: springs of 1e-9 m", || net(1e-9)));
    cases.push(
        Case::new("contrast: springs of zero length", || net(0.0))
            .expect(Expect::Refused("a rest length of 0 m is not above 0")),
    );
    cases
}

/// Poplin a hundred times stiffer along the warp and a hundred times softer along the weft.
fn unlike() -> Fabric {
    let fabric = poplin();
    let mean = (fabric.stretch_warp_n_m * fabric.stretch_weft_n_m).sqrt();
    Fabric {
        stretch_warp_n_m: 100.0 * mean,
        stretch_weft_n_m: mean / 100.0,
        ..fabric
    }
}

/// Cloth of which the vertices that `is_heavy` names weigh 1e4 times as much.
fn heavy(is_heavy: impl Fn(usize) -> bool) -> Scene {
    let mut scene = hung(poplin(), 12);
    for (i, mass) in scene.mass.iter_mut().enumerate() {
        *mass *= if is_heavy(i) { 1e4 } else { 1.0 };
    }
    scene
}

/// Cloth with a line of its mesh moved to 1e-4 of a cell beside its neighbour.
fn slivers() -> Scene {
    let cells = 12;
    let sheet = sheet(poplin(), cells);
    let mut mesh = sheet.scene(arc).mesh;
    let cell = 0.5 / cells as f64;
    for j in 0..=cells {
        mesh.uv[sheet.vertex(6, j)][0] = 5.0 * cell + 1e-4 * cell;
    }
    Scene {
        pins: vec![sheet.vertex(0, 0), sheet.vertex(cells, 0)],
        ..sheet.scene_of(mesh, arc)
    }
}

/// A net that has springs of `length` \[m\] between its free corners and the middle besides its own.
fn net(length: f64) -> Made {
    let mut raw: RawScene = Net {
        family: Family::PlanarHang,
        rows: 9,
        stiffer: 1.0,
    }
    .scene();
    for corner in [72, 80] {
        raw.springs.push(NetSpring {
            a: 40,
            b: corner,
            rest_length_m: length,
            stiffness_n_m: 10.0,
        });
    }
    let ask = Simulate {
        method: Method::Newton,
        ..Simulate::default()
    };
    match raw.into_scene(&Limits::default()) {
        Ok(scene) => Made::drape(scene, Method::Newton),
        Err(faults) => Made {
            work: Work::NoScene(faults),
            ask,
            limits: Limits::default(),
        },
    }
}
