//! Starts that nothing worn ever has: scrambled, collapsed, turned inside out, through each other, inside the body, far away.

use super::cloth::{hung, poplin, sewn};
use super::scenes;
use super::scenes::net::{Family, Net};
use super::sheet::random;
use super::{Case, Expect, Made};
use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::scene::Scene;
use seamster::solver::{Membrane, Method};

/// A start that is nothing like the cloth.
type Start = (&'static str, fn(&mut Scene));

const STARTS: [Start; 6] = [
    ("scrambled", scrambled),
    ("collapsed to a point", collapsed),
    ("collapsed to a point, pins too", collapsed_with_pins),
    ("collapsed to a line", to_a_line),
    ("inverted", inverted),
    ("10 times as large", |scene| {
        scene.start.iter_mut().for_each(|p| *p *= 10.0);
    }),
];

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for (name, change) in STARTS {
        for membrane in [Membrane::Continuum, Membrane::Springs] {
            let model = if membrane == Membrane::Springs {
                "springs"
            } else {
                "continuum"
            };
            cases.push(
                Case::new(format!("start: {name}, {model}"), move || {
                    let mut scene = hung(poplin(), 10);
                    change(&mut scene);
                    Made::drape(scene, Method::Newton).asking(|ask| ask.membrane = membrane)
                })
                .small_if(membrane == Membrane::Continuum && name != "10 times as large"),
            );
        }
        cases.push(Case::new(format!("start: {name}, in a plane"), move || {
            Made::drape(planar(change), Method::Newton)
        }));
        for method in [Method::ImplicitEuler, Method::SymplecticEuler] {
            let case = Case::new(format!("start: {name}, {}", method.name()), move || {
                let mut scene = hung(poplin(), 8);
                change(&mut scene);
                Made::drape(scene, method).asking(|ask| {
                    ask.tolerance = 1e-3;
                    ask.time_limit_s = Some(8.0);
                })
            });
            let case = case.small_if(name == "scrambled");
            cases.push(
                match (name, method) {
                    // Crumpled cloth is stiff to one side everywhere: even short steps drive it for long.
                    ("collapsed to a line", Method::SymplecticEuler) => case
                        .expect(Expect::NotConverged("the time allowed was up"))
                        .whole_only(),
                    ("10 times as large", Method::SymplecticEuler) => case.whole_only(),
                    _ => case,
                }
                .within(10.0),
            );
        }
    }
    cases.extend(tubes().map(|(name, change, expect)| {
        let case = Case::new(format!("start: {name}"), move || {
            let mut scene = sewn(poplin(), 500);
            scene.start.iter_mut().for_each(change);
            Made::drape(scene, Method::Newton)
        });
        let case = case.expect(expect).within(20.0);
        if expect == Expect::Converged {
            case
        } else {
            case.whole_only()
        }
    }));
    for (name, height) in [
        ("through the middle of a ball", 0.0),
        ("a third into a ball", 0.1),
    ] {
        cases.push(Case::new(format!("start: {name}"), move || {
            let mut scene = scenes::scene("S2_17").expect("a scene of the benchmark");
            scene.start.iter_mut().for_each(|p| p.z = height);
            Made::drape(scene, Method::Newton)
        }));
    }
    cases
}

/// A change of where a point of the tube starts, and what comes of it.
type Moved = (&'static str, fn(&mut Vector3<f64>), Expect);

/// The tube's panels, 0.15 m before and behind the middle of the cylinder.
fn tubes() -> [Moved; 6] {
    [
        (
            "panels on the wrong side of each other",
            |p| p.z = -p.z,
            Expect::Converged,
        ),
        (
            "panels through each other below the body",
            crossed,
            Expect::Converged,
        ),
        (
            "panels 3 cm inside the body",
            |p| p.z *= 0.8,
            Expect::Converged,
        ),
        // Nothing tells the solver which way is out of the middle of a body: cloth that lies across it is pressed to both sides.
        (
            "panels through the middle of the body",
            |p| p.z *= 0.1,
            Expect::NotConverged("limit of iterations"),
        ),
        (
            "panels 1 m apart",
            |p| p.z += 0.35 * p.z.signum(),
            Expect::Converged,
        ),
        (
            "panels 5 m apart",
            |p| p.z += 2.35 * p.z.signum(),
            Expect::Converged,
        ),
    ]
}

/// Below the body the panel in front goes to the back and the other to the front.
fn crossed(p: &mut Vector3<f64>) {
    let down = ((-0.2 - p.y) / 0.3).clamp(0.0, 1.0);
    p.z *= 1.0 - 2.0 * down;
}

fn pinned(scene: &Scene, vertex: usize) -> bool {
    scene.pins.contains(&vertex)
}

/// Every free vertex anywhere in a cube as large as the cloth.
fn scrambled(scene: &mut Scene) {
    let mut random = random();
    for i in 0..scene.start.len() {
        let p = Vector3::new(random(), random(), random()) * 0.5;
        if !pinned(scene, i) {
            scene.start[i] = p;
        }
    }
}

fn collapsed(scene: &mut Scene) {
    for i in 0..scene.start.len() {
        if !pinned(scene, i) {
            scene.start[i] = Vector3::new(0.0, -0.2, 0.1);
        }
    }
}

fn collapsed_with_pins(scene: &mut Scene) {
    scene.start.fill(Vector3::new(0.0, -0.2, 0.1));
}

fn to_a_line(scene: &mut Scene) {
    scene.start.iter_mut().for_each(|p| (p.y, p.z) = (0.0, 0.0));
}

/// Mirrored but for the pins: in a plane that turns every triangle over.
fn inverted(scene: &mut Scene) {
    for i in 0..scene.start.len() {
        if !pinned(scene, i) {
            scene.start[i].x *= -1.0;
        }
    }
}

/// A net held in its plane, with its start changed within that.
fn planar(change: fn(&mut Scene)) -> Scene {
    let net = Net {
        family: Family::PlanarHang,
        rows: 11,
        stiffer: 1.0,
    };
    let raw = net.scene();
    let mut scene = raw.into_scene(&Limits::default()).expect("a net is right");
    change(&mut scene);
    scene.start.iter_mut().for_each(|p| p.y = 0.0);
    scene
}
