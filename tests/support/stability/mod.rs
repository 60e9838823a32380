//! Stiff and extreme cases: what is simulated, what is expected of it, and how that is judged.
//!
//! A case is made by a function, so that listing them costs nothing. `tests/stability.rs` runs those that are `small`, the program
//! `examples/stability` all of them. What a case must come to is stated beside it; a case that is expected not to converge is
//! a limit of the solver that the table names.
#![allow(
    dead_code,
    reason = "the test and the program each use some of what is here"
)]

mod check;
mod cloth;
mod contrast;
pub(crate) mod line;
mod motion;
mod run;
mod seams;
#[path = "../sheet.rs"]
mod sheet;
mod sizes;
mod starts;
mod stiffness;
mod surroundings;

#[path = "../samples.rs"]
mod samples;
#[path = "../scenes/mod.rs"]
mod scenes;

pub(crate) use run::line;

use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::fit::Prepared;
use seamster::scene::Scene;
use seamster::solver::{Method, Simulate, Start};

/// What is run.
pub(crate) enum Work {
    /// A drape of a scene.
    Drape(Scene),
    /// A motion of a scene.
    Motion(Scene, Start),
    /// A garment, from its pattern on.
    Fit(Box<Prepared>),
    /// What did not become a scene.
    NoScene(Faults),
}

/// What is run, with what is asked of it.
pub(crate) struct Made {
    pub(crate) work: Work,
    pub(crate) ask: Simulate,
    pub(crate) limits: Limits,
}

/// What a case must come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Expect {
    /// A drape at rest, or a motion that was completed.
    Converged,
    /// Not that, for a reason that has these words.
    NotConverged(&'static str),
    /// Refused at once, for a reason that has these words.
    Refused(&'static str),
}

/// One case.
pub(crate) struct Case {
    /// Group, what is special, method; no two have the same.
    pub(crate) name: String,
    /// Makes it.
    pub(crate) make: Box<dyn Fn() -> Made>,
    pub(crate) expect: Expect,
    /// Words of a fault that is known, and told in the table.
    pub(crate) known: Option<&'static str>,
    /// CPU time within which it ends in a release build on one core of a usual machine \[s\].
    pub(crate) within_s: f64,
    /// Whether continuous integration runs it.
    pub(crate) small: bool,
}

impl Case {
    /// A case that is at rest or completed within 5 s, run by continuous integration.
    fn new(name: impl Into<String>, make: impl Fn() -> Made + 'static) -> Self {
        Self {
            name: name.into(),
            make: Box::new(make),
            expect: Expect::Converged,
            known: None,
            within_s: 5.0,
            small: true,
        }
    }

    fn expect(self, expect: Expect) -> Self {
        Self { expect, ..self }
    }

    /// Too long for continuous integration unless `small`.
    fn small_if(self, small: bool) -> Self {
        Self { small, ..self }
    }

    fn known(self, fault: &'static str) -> Self {
        Self {
            known: Some(fault),
            ..self
        }
    }

    fn within(self, within_s: f64) -> Self {
        Self { within_s, ..self }
    }

    /// Too long for continuous integration.
    fn whole_only(self) -> Self {
        Self {
            small: false,
            ..self
        }
    }
}

impl Made {
    /// A drape by `method`.
    fn drape(scene: Scene, method: Method) -> Self {
        Self {
            work: Work::Drape(scene),
            ask: Simulate {
                method,
                ..Simulate::default()
            },
            limits: Limits::default(),
        }
    }

    fn asking(self, change: impl FnOnce(&mut Simulate)) -> Self {
        let mut made = self;
        change(&mut made.ask);
        made
    }
}

/// All cases, group by group.
pub(crate) fn cases() -> Vec<Case> {
    let groups = [
        stiffness::cases(),
        contrast::cases(),
        starts::cases(),
        seams::cases(),
        motion::cases(),
        surroundings::cases(),
        sizes::cases(),
    ];
    groups.into_iter().flatten().collect()
}
