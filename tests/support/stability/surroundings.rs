//! Weight, wind and fabrics far from a shop's.

use super::cloth::{hung, poplin, sewn};
use super::motion::moving;
use super::samples::sample;
use super::{Case, Expect, Made, Work, scenes};
use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::scene::{Fabric, Scene, Wind};
use seamster::solver::{Method, Simulate};
use serde_json::{Value, json};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for (name, by) in [("x100", 100.0), ("0", 0.0)] {
        cases.push(Case::new(format!("gravity {name}: hung"), move || {
            Made::drape(weighing(hung(poplin(), 12), by), Method::Newton)
        }));
        cases.push(
            Case::new(format!("gravity {name}: sewn over a cylinder"), move || {
                Made::drape(weighing(sewn(poplin(), 500), by), Method::Newton)
            })
            .small_if(by > 0.0),
        );
        cases.push(Case::new(
            format!("gravity {name}: on a ball, with friction"),
            move || {
                let scene = scenes::scene("S2_17").expect("a scene of the benchmark");
                Made::drape(weighing(scene, by), Method::Newton)
            },
        ));
        for method in [Method::ImplicitEuler, Method::Verlet] {
            cases.push(
                Case::new(
                    format!("gravity {name}: motion, {}", method.name()),
                    move || {
                        let scene = Scene {
                            drag: Some(0.0),
                            ..hung(poplin(), 8)
                        };
                        moving(weighing(scene, by), method, Some(1e-5), 0.02)
                    },
                )
                .small_if(method == Method::Verlet),
            );
        }
    }
    for (name, density) in [("5 g/m²", 0.005), ("5 kg/m²", 5.0)] {
        let fabric = move || Fabric {
            density_kg_m2: density,
            ..poplin()
        };
        cases.push(Case::new(format!("fabric of {name}: hung"), move || {
            Made::drape(hung(fabric(), 12), Method::Newton)
        }));
        cases.push(Case::new(
            format!("fabric of {name}: sewn over a cylinder"),
            move || Made::drape(sewn(fabric(), 500), Method::Newton),
        ));
    }
    for (speed, expect) in [
        (40.0, Expect::Converged),
        // Ten kilograms a square metre: cloth flutters, there is no shape at rest.
        (100.0, Expect::NotConverged("limit of iterations")),
    ] {
        let drape = Case::new(format!("wind of {speed} m/s: hung"), move || {
            Made::drape(blown(speed), Method::Newton)
        });
        cases.push(if expect == Expect::Converged {
            drape
        } else {
            drape.expect(expect).within(20.0).whole_only()
        });
        // In a gale cloth flaps within microseconds' reach of its stiffness: equations of longer steps are not solved.
        for method in [Method::ImplicitEuler, Method::Bdf2] {
            let case = Case::new(
                format!("wind of {speed} m/s: motion, {}", method.name()),
                move || {
                    moving(blown(speed), method, Some(1e-3), 0.2)
                        .asking(|ask| ask.time_limit_s = Some(2.0))
                },
            );
            cases.push(
                case.expect(Expect::NotConverged("the time allowed was up"))
                    .whole_only(),
            );
        }
        cases.push(Case::new(
            format!("wind of {speed} m/s: motion, verlet"),
            move || moving(blown(speed), Method::Verlet, None, 0.2),
        ));
    }
    cases.extend(garments());
    cases
}

fn weighing(scene: Scene, by: f64) -> Scene {
    Scene {
        gravity: scene.gravity * by,
        ..scene
    }
}

fn blown(speed: f64) -> Scene {
    Scene {
        wind: Some(Wind {
            velocity: Vector3::new(0.3, 0.1, 1.0).normalize() * speed,
            gust: 0.0,
        }),
        ..hung(poplin(), 8)
    }
}

/// The real way: a drawing, its seams, an avatar.
fn garments() -> Vec<Case> {
    let ease = [
        ("as it is", json!({})),
        ("inside the body", inside()),
        ("of steel", fabric(1e7, 1e6, 0.1, 5.0)),
        ("of veil", fabric(0.5, 0.05, 1e-9, 0.002)),
        (
            "under a gale",
            json!({"wind": {"velocity_m_s": [0.0, 0.0, -40.0]}}),
        ),
    ];
    ease.into_iter()
        .map(|(name, changes)| {
            Case::new(format!("garment: top {name}"), move || {
                let mut changes = changes.clone();
                changes["simulate"] = json!({"edge_length_m": 0.04});
                let prepared = sample("top", changes);
                Made {
                    work: Work::Fit(Box::new(prepared)),
                    ask: Simulate {
                        edge_length_m: 0.04,
                        ..Simulate::default()
                    },
                    limits: Limits::default(),
                }
            })
            .expect(if name == "of veil" {
                Expect::NotConverged("limit of iterations")
            } else {
                Expect::Converged
            })
            .within(20.0)
            .small_if(matches!(name, "inside the body" | "of steel"))
        })
        .collect()
}

/// Both panels through the middle of the body.
fn inside() -> Value {
    let at = |at: &str, z: f64| json!({"placement": {"at": at, "offset_m": [0.0, 0.0, z]}});
    json!({"panels": {"front": at("torso_front", -0.15), "back": at("torso_back", -0.15)}})
}

/// A fabric at the end of what is allowed.
fn fabric(stretch: f64, shear: f64, bending: f64, density: f64) -> Value {
    let mut own = serde_json::to_value(poplin()).expect("plain data");
    let figures = json!({
        "density_kg_m2": density, "stretch_warp_n_m": stretch, "stretch_weft_n_m": stretch,
        "shear_n_m": shear, "bending_warp_n_m": bending, "bending_weft_n_m": bending,
    });
    for (field, value) in figures.as_object().expect("written so above") {
        own[field] = value.clone();
    }
    json!({"fabrics": {"own": own}, "default_fabric": "own"})
}
