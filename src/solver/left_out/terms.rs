//! Every combination of what a scene may have or lack gives the terms that it needs, and the report
//! names the others.

use crate::config::Limits;
use crate::progress::CancelToken;
use crate::solver::drape;
use crate::solver::left_out::scenes::{Has, scene};
use crate::solver::model::build::build;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::{Context, DrapeReport, FrictionAnchors, SeamClose, SolverOptions};

/// Cells along a sheet: few, since what is assembled counts, not what comes of it.
const CELLS: usize = 2;

/// The terms of a scene that has these things, in the order of their names, and the others.
fn needed(has: Has) -> (Vec<&'static str>, Vec<&'static str>) {
    let terms = [
        ("bend", has.bending),
        ("contact", has.body),
        ("friction", has.body && has.friction),
        ("gravity", has.gravity),
        ("seam", has.seams),
        ("self_contact", has.self_contact),
        ("stretch", true),
        ("wind", has.wind),
    ];
    let named = |needed| move |(name, is): &(&'static str, bool)| (*is == needed).then_some(*name);
    (
        terms.iter().filter_map(named(true)).collect(),
        terms.iter().filter_map(named(false)).collect(),
    )
}

fn sorted<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names: Vec<_> = names.collect();
    names.sort_unstable();
    names
}

#[test]
fn a_system_has_the_terms_that_its_scene_needs_and_no_others() {
    for has in Has::combinations() {
        let scene = scene(has, CELLS);
        let build_options = BuildOptions {
            seams: Seams::Stiff { stiffness: 1e4 },
            hold: None,
            gravity: true,
            friction: Some(&FrictionAnchors::default()),
            explicit: false,
            least_thickness: has.self_contact.then_some(1e-4),
            finest: false,
        };
        let system = build(&scene, &SolverOptions::default(), &build_options, &|| 0.0).system;
        let holds = system.anchors() != FrictionAnchors::default();
        let friction = holds.then_some("friction");
        let terms = system.terms.iter().map(|term| term.potential.kind().name());
        assert_eq!(sorted(terms.chain(friction)), needed(has).0, "{has:?}");
    }
}

/// A few iterations: seams that stay springs are a term to the end.
fn report(has: Has) -> DrapeReport {
    let options = SolverOptions {
        seam_close: SeamClose::Spring,
        ..SolverOptions::default()
    };
    let limits = Limits {
        iterations: 2,
        ..Limits::default()
    };
    let (cancel, scene) = (CancelToken::new(), scene(has, CELLS));
    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    drape(&scene, &options, &mut context).report
}

#[test]
fn a_report_names_what_was_left_out_and_says_why() {
    for has in Has::combinations() {
        let report = report(has);
        let (mut ran, left_out) = needed(has);
        // friction runs as a part of contact
        ran.retain(|name| *name != "friction");
        let terms = report.terms.iter().map(|term| term.name.as_str());
        assert_eq!(sorted(terms), ran, "{has:?}");
        let named = report.skipped_terms.iter().map(|left| left.name.as_str());
        assert_eq!(sorted(named), left_out, "{has:?}");
        let mut reasons = report.skipped_terms.iter().map(|left| &left.because);
        assert!(reasons.all(|because| !because.is_empty()), "{has:?}");
    }
}
