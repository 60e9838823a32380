//! Motions: steps from 1e-5 s to a tenth of a second, stiffness up to a million times poplin's.

use super::cloth::{hung, stiffer};
use super::stiffness::FACTORS;
use super::{Case, Expect, Made, Work};
use seamster::config::Limits;
use seamster::scene::Scene;
use seamster::solver::{Method, Simulate, Start, Want};

const METHODS: [Method; 4] = [
    Method::SymplecticEuler,
    Method::Verlet,
    Method::ImplicitEuler,
    Method::Bdf2,
];

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for method in METHODS {
        let explicit = matches!(method, Method::SymplecticEuler | Method::Verlet);
        for (step, duration) in [
            (1e-5, 0.01),
            (1e-4, 0.05),
            (1e-3, 0.2),
            (1e-2, 0.5),
            (1e-1, 1.0),
        ] {
            let case = Case::new(
                format!("motion: steps of {step:.0e} s, {}", method.name()),
                move || motion(1.0, method, Some(step), duration),
            );
            cases.push(if explicit && step > 1e-4 {
                case.expect(Expect::Refused("stability limit"))
            } else {
                case.small_if(explicit || step > 1e-3).within(10.0)
            });
        }
        for by in FACTORS {
            let case = Case::new(
                format!("motion: x{by:.0e}, steps chosen, {}", method.name()),
                move || motion(by, method, None, 0.2),
            );
            cases.push(match by {
                1.0 | 1e2 if explicit => case,
                _ if explicit => case.within(100.0).whole_only(),
                _ => case.within(60.0).whole_only(),
            });
        }
        if explicit {
            cases.push(
                Case::new(
                    format!("motion: a minute at x1e6, {}", method.name()),
                    move || motion(1e6, method, None, 60.0),
                )
                .expect(Expect::Refused("needs ")),
            );
        }
    }
    cases
}

/// The fall of a sheet that is hung by two corners, without drag.
pub(super) fn motion(by: f64, method: Method, step: Option<f64>, duration: f64) -> Made {
    let scene = Scene {
        drag: Some(0.0),
        ..hung(stiffer(by), 8)
    };
    moving(scene, method, step, duration)
}

pub(super) fn moving(scene: Scene, method: Method, step: Option<f64>, duration: f64) -> Made {
    Made {
        work: Work::Motion(scene, Start::default()),
        ask: Simulate {
            want: Want::Motion,
            method,
            step_s: step,
            tolerance: 1e-3,
            duration_s: Some(duration),
            frame_rate_hz: Some((20.0 / duration).max(10.0)),
            ..Simulate::default()
        },
        limits: Limits::default(),
    }
}
