//! Cloth up to a million times stiffer than poplin, which is stiffer than sheet steel of its thickness.

use super::cloth::{hung, sewn, stiffer};
use super::{Case, Expect, Made};
use seamster::solver::{Membrane, Method};

pub(super) const FACTORS: [f64; 4] = [1.0, 1e2, 1e4, 1e6];

const METHODS: [Method; 4] = [
    Method::SymplecticEuler,
    Method::Verlet,
    Method::ImplicitEuler,
    Method::Bdf2,
];

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
        cases.push(
            Case::new(
                format!("stiffness: sewn over a cylinder x{by:.0e}"),
                move || Made::drape(sewn(stiffer(by), 500), Method::Newton),
            )
            .small_if(by < 1e6),
        );
        cases.extend(METHODS.map(|method| by_motion(by, method)));
    }
    cases
}

/// The drape by a method that steps; a million steps are allowed to the stiffest.
fn by_motion(by: f64, method: Method) -> Case {
    let name = format!("stiffness: hung x{by:.0e}, {}", method.name());
    let case = Case::new(name, move || {
        let mut made = Made::drape(hung(stiffer(by), 8), method);
        if by >= 1e4 {
            made.limits.steps = 1_000_000;
        }
        made.asking(|ask| {
            ask.tolerance = 1e-3;
            ask.time_limit_s = (by == 1e6).then_some(3.0);
        })
    });
    let explicit = matches!(method, Method::SymplecticEuler | Method::Verlet);
    let case = case.small_if(by == 1.0);
    match (explicit, by) {
        (true, 1e4 | 1e6) => case.expect(Expect::Refused("needs ")).small_if(true),
        (true, 1e2) => case.within(30.0).whole_only(),
        (false, 1e4) => case.within(30.0).whole_only(),
        // Steps follow folds that snap over, which are the shorter the stiffer the cloth.
        (false, 1e6) => case
            .expect(Expect::NotConverged("the time allowed was up"))
            .whole_only(),
        _ => case,
    }
}

fn membrane_word(membrane: Membrane) -> &'static str {
    match membrane {
        Membrane::Continuum => "continuum",
        Membrane::Springs => "springs",
    }
}
