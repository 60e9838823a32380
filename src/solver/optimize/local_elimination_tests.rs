//! Local elimination on a string of springs.

use crate::solver::forces::{Gravity, Potential, Spring, SpringForce, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use crate::solver::model::system::System;
use crate::solver::model::system::TimedTerm;
use crate::solver::optimize::local_elimination::{GlobalStep, LocalElimination, ROUNDS};
use crate::solver::optimize::newton_workspace::NewtonWorkspace;
use nalgebra::Vector3;

const COUNT: usize = 61;
const MIDDLE: usize = 30;
const CEILING: f64 = 0.001;

/// A stiff ceiling above one particle, and contact of one.
struct Ceiling {
    touching: Option<usize>,
    diagonal: usize,
}

impl Ceiling {
    const STIFFNESS: f64 = 1e6;

    fn depth(x: &[Vector3<f64>]) -> f64 {
        (x[MIDDLE].y - CEILING).max(0.0)
    }
}

impl Potential for Ceiling {
    fn kind(&self) -> TermKind {
        TermKind::Contact
    }

    fn add_coupled_pairs(&self, _pairs: &mut Vec<(usize, usize)>) {}

    fn bind(&mut self, sparsity: &Sparsity) {
        self.diagonal = sparsity.diagonal(MIDDLE);
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        0.5 * Self::STIFFNESS * Self::depth(x).powi(2)
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        force[MIDDLE].y -= Self::STIFFNESS * Self::depth(x);
    }

    fn add_hessian(&mut self, x: &[Vector3<f64>], _: f64, hessian: &mut BlockMatrix) {
        if Self::depth(x) > 0.0 {
            hessian.blocks[self.diagonal][(1, 1)] += Self::STIFFNESS;
        }
    }

    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {}

    fn mark_touching(&mut self, _x: &[Vector3<f64>], touching: &mut [bool]) {
        if let Some(i) = self.touching {
            touching[i] = true;
        }
    }
}

/// A string of springs that is pulled up below a ceiling.
fn string(touching: Option<usize>) -> System<'static> {
    let springs = (1..COUNT).map(|b| Spring {
        a: b - 1,
        b,
        rest_length: 0.0,
        stiffness: 1.0,
    });
    let potentials: [Box<dyn Potential>; 3] = [
        Box::new(SpringForce::new(springs.collect())),
        Box::new(Gravity {
            weight: vec![Vector3::y() * 4e-4; COUNT],
            start: vec![Vector3::zeros(); COUNT],
        }),
        Box::new(Ceiling {
            touching,
            diagonal: 0,
        }),
    ];
    let terms = potentials.map(|potential| TimedTerm {
        potential,
        cpu_s: 0.0,
    });
    System {
        mass: vec![1e-3; COUNT],
        is_fixed: (0..COUNT).map(|i| i == 0 || i == COUNT - 1).collect(),
        fixed_axis: None,
        terms: terms.into_iter().collect(),
        clock: &|| 0.0,
    }
}

/// Takes the Newton step from the straight string, whose model knows no ceiling, and
/// eliminates; returns the step's end, that of the elimination, and the decrease.
fn eliminate(touching: Option<usize>) -> (Vec<Vector3<f64>>, Vec<Vector3<f64>>, f64) {
    let mut system = string(touching);
    let x: Vec<_> = (0..COUNT).map(|i| Vector3::x() * i as f64).collect();
    let mut work = NewtonWorkspace::new(&mut system).expect("small");
    system.net_force(&x, &mut work.force);
    system.hessian(&x, 0.0, &mut work.hessian);
    system.constrain(&work.sparsity, &mut work.hessian);
    work.cholesky.factorize(&work.hessian.blocks).expect("taut");
    work.solve();
    let step: Vec<_> = x.iter().zip(&work.step).map(|(x, d)| x + d).collect();
    let global = GlobalStep {
        sparsity: &work.sparsity,
        cholesky: &work.cholesky,
        force: &work.force,
        touching: &[false; COUNT],
        share: 1.0,
        modification: 0.0,
        gamma: 1e4,
    };
    let mut trial = step.clone();
    let before = system.energy(&trial);
    let mut elimination = LocalElimination::new(&work.sparsity);
    let decrease = elimination.run(&mut system, &global, &mut trial, 0.0);
    let lost = before - system.energy(&trial);
    assert!((lost - decrease).abs() < 1e-9 * before, "{lost} {decrease}");
    (step, trial, decrease)
}

#[test]
fn what_a_step_got_wrong_moves_alone_and_lowers_the_energy() {
    let (step, trial, decrease) = eliminate(None);
    assert!(step[MIDDLE].y > 10.0 * CEILING);
    assert!(decrease > 0.0);
    // The springs of 1 N/m against the ceiling's 1e6 N/m: it gives way by parts in a million.
    assert!(trial[MIDDLE].y < 1.001 * CEILING, "{}", trial[MIDDLE].y);
    let moved: Vec<usize> = (0..COUNT).filter(|&i| trial[i] != step[i]).collect();
    // A round changes the forces one particle beyond those that move, and lets those move in
    // the next that are one further.
    let most = 2 * ROUNDS - 1;
    let reach = MIDDLE - most..=MIDDLE + most;
    assert!(moved.contains(&MIDDLE) && moved.iter().all(|i| reach.contains(i)));
}

#[test]
fn what_came_into_contact_within_the_step_is_held() {
    let held = MIDDLE + 1;
    let (step, trial, _) = eliminate(Some(held));
    assert_eq!(trial[held], step[held]);
    assert_ne!(trial[MIDDLE], step[MIDDLE]);
}
