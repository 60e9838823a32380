//! Cloth up to a million times stiffer than poplin, which is stiffer than sheet steel of its thickness.

use super::cloth::{hung, sewn, stiffer};
use super::{Case, Expect, Made, word};
use seamster::solver::{Membrane, Method};

pub(super) const FACTORS: [f64; 4] = [1.0, 1e2, 1e4, 1e6];

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for by in FACTORS {
        for membrane in [Membrane::Continuum, Membrane::Springs] {
            cases.push(Case::new(
                format!("stiffness: hung x{by:.0e}, {}", membrane_word(membrane)),
                move || {
                    let scene = hung(stiffer(by), 12);
                    Made::drape(scene, Method::Newton).asking(|ask| ask.membrane = membrane)
                },
            ));
        }
        cases.push(Case::new(
            format!("stiffness: sewn over a cylinder x{by:.0e}"),
            move || Made::drape(sewn(stiffer(by), 500), Method::Newton),
        ));
        for method in [Method::SymplecticEuler, Method::Verlet] {
            let case = Case::new(
                format!("stiffness: hung x{by:.0e}, {}", word(method)),
                move || {
                    Made::drape(hung(stiffer(by), 8), method).asking(|ask| ask.tolerance = 1e-3)
                },
            );
            cases.push(match by {
                1e6 => case.expect(Expect::Refused("needs ")),
                1e4 => case.within(200.0).whole_only(),
                1e2 => case.within(30.0).whole_only(),
                _ => case.within(5.0),
            });
        }
        for method in [Method::ImplicitEuler, Method::Bdf2] {
            cases.push(Case::new(
                format!("stiffness: hung x{by:.0e}, {}", word(method)),
                move || {
                    Made::drape(hung(stiffer(by), 8), method).asking(|ask| ask.tolerance = 1e-3)
                },
            ));
        }
    }
    cases
}

fn membrane_word(membrane: Membrane) -> &'static str {
    match membrane {
        Membrane::Continuum => "continuum",
        Membrane::Springs => "springs",
    }
}
