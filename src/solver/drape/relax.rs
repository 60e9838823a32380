//! The drape (P10): the seams are closed for good, and the garment falls until nothing moves any more.

use crate::solver::drape::level::{Level, Rest, SETTLED};
use crate::solver::drape::monitor::{Look, SEWING_SHARE, Trace};
use crate::solver::drape::sew::closed_stiffness;
use crate::solver::drape::stage::{Ended, How, note_fallbacks, run};
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::model::build::{Stage, assemble};
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Iterate, Termination};
use crate::solver::optimize::newton::Newton;
use crate::solver::optimize::pseudo_transient::NEAR_GAMMA;
use crate::solver::options::{Method, SeamClose};
use crate::solver::report::describe::{add_terms, energies, mean_height};
use crate::solver::report::measure;
use crate::solver::report::schema::DrapeReport;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// How far the middle of a garment sinks before it is plain that nothing will stop it \[m\].
const FREE_FALL: f64 = 0.5;
/// Residual up to which ‖H⁻¹ f‖ was measured to be the error.
pub(crate) const ESTIMATE_HOLDS: f64 = 1e-2;
/// Share of the tolerance at which a shape counts as at rest even if it is not in a minimum.
pub(crate) const SADDLE: f64 = 0.01;
/// Drag \[1/s\] and speed limit \[m/s\] of explicit steps. A garment sways at about 4 rad/s: twice that is critical.
pub(crate) const DRAG: f64 = 8.0;
pub(crate) const SPEED_LIMIT: f64 = 5.0;
const MOTION: DynamicRelaxation = DynamicRelaxation {
    method: Method::SymplecticEuler,
    drag: DRAG,
    speed_limit: SPEED_LIMIT,
    step: None,
    tolerance: SETTLED,
};

/// Closes the seams for good and lets the garment come to rest.
pub(crate) fn settle(
    level: &mut Level<'_, '_, '_>,
    x: &mut Vec<Vector3<f64>>,
    stiffness: f64,
    report: &mut DrapeReport,
) -> Rest {
    let stitches = level.stitches(u32::MAX);
    let weld = level.options.seam_close == SeamClose::Weld;
    let dof_map = if weld {
        DofMap::welded(x.len(), stitches.iter().copied())
    } else {
        DofMap::identity(x.len())
    };
    let springs = (!weld && !stitches.is_empty())
        .then(|| (stitches.clone(), closed_stiffness(level.options, stiffness)));
    let stage = Stage {
        dof_map: &dof_map,
        stitches: springs,
        gravity: true,
        friction: Some(&level.anchors),
        explicit: level.options.method.is_explicit(),
    };
    level.trace.begin_stage();
    let mut system = assemble(level.scene, level.options, &stage, level.clock);
    let mut shape = dof_map.average(x);
    let gravity = &level.scene.gravity;
    let first_height = mean_height(gravity, &shape);
    let floor = system.residual_floor(&shape);
    let tolerance = level.tolerance.max(level.floors * floor);
    let mut fall = Fall {
        how: level.how(DynamicRelaxation {
            drag: level.scene.drag.unwrap_or(MOTION.drag),
            tolerance,
            ..MOTION
        }),
        gravity: *gravity,
        dof_map: &dof_map,
        stitches: dof_map.pairs(&stitches),
        tolerance,
        trace: level.trace,
    };
    let (ended, newton) = fall.run(&mut system, &mut shape);
    *x = dof_map.scatter(&shape);
    note_fallbacks(&mut report.fallbacks, ended.fallbacks);
    report.newton_iterations += ended.iterations;
    report.residual = ended.residual;
    report.residual_floor = floor;
    report.converged = ended.stop == Termination::Reached;
    report.why = ended.reason(level.trace.canceled);
    if report.converged && tolerance > level.tolerance {
        report.why = format!(
            "at rest: stopped by the round-off floor of {floor:.1e}, at r = {:.1e}",
            ended.residual
        );
    }
    if level.finest {
        estimate(&mut system, &shape, (newton, &ended), report);
    }
    // Of every level: it may be the last that there is time for.
    report.energy_j = energies(&mut system, &shape);
    add_terms(&mut report.terms, &system);
    Rest {
        to_go: level.trace.to_go(ended.residual, x),
        at_rest: report.converged,
        sewn: true,
        fell: ended.fell,
        sunk: first_height - mean_height(gravity, &shape),
        anchors: system.contact.map(|c| c.anchors()).unwrap_or_default(),
    }
}

/// Fills in how far the shape is from the solution of its mesh, if its second derivative tells.
#[inline(never)] // so that a profile tells what it takes
fn estimate(
    system: &mut System<'_>,
    shape: &[Vector3<f64>],
    (newton, ended): (Option<Newton>, &Ended),
    report: &mut DrapeReport,
) {
    let at_rest = ended.stop == Termination::Reached;
    let newton = newton.or_else(|| {
        let newton = at_rest.then(|| Newton::new(system, NEAR_GAMMA));
        newton?.ok()
    });
    // Far from rest the second derivative has no factor, and it would take time to find that out.
    let Some(mut newton) = newton.filter(|n| at_rest || n.is_convex()) else {
        return;
    };
    report.error_estimate_m = newton.error_estimate(system, shape);
    let Some(_) = report.error_estimate_m else {
        "none: the shape is at rest, but not in a minimum of the energy"
            .clone_into(&mut report.error_estimate_because);
        return;
    };
    let (contact, near) = (newton.contact_settled, ended.residual <= ESTIMATE_HOLDS);
    report.error_estimate_valid = contact && near;
    report.error_estimate_because = match (contact, near) {
        (true, true) => "valid: the forces left over, divided by the stiffness, of a shape in a minimum of the energy near to rest".to_owned(),
        (false, _) => "not valid: cloth slips on the body, or comes and goes there".to_owned(),
        (_, false) => format!("not valid: r is above {ESTIMATE_HOLDS:.0e}, too far from rest"),
    };
}

/// A fall to rest.
struct Fall<'a, 'c, 'w> {
    how: How,
    gravity: Vector3<f64>,
    dof_map: &'a DofMap,
    /// Pairs of particles that are sewn together and still two.
    stitches: Vec<(usize, usize)>,
    tolerance: f64,
    trace: &'a mut Trace<'c, 'w>,
}

impl Fall<'_, '_, '_> {
    fn run(
        &mut self,
        system: &mut System<'_>,
        shape: &mut [Vector3<f64>],
    ) -> (Ended, Option<Newton>) {
        let first_height = mean_height(&self.gravity, shape);
        let (mut last, mut fell) = (f64::NAN, false);
        let how = self.how;
        let mut callback = |i: Iterate<'_>| {
            last = i.residual;
            fell = first_height - mean_height(&self.gravity, i.positions) > FREE_FALL;
            self.callback(i, fell)
        };
        let (mut ended, newton) = run(system, shape, how, &mut callback);
        ended.residual = last;
        ended.fell = fell;
        (ended, newton)
    }

    fn callback(&mut self, i: Iterate<'_>, fell: bool) -> ControlFlow<Termination> {
        let tolerance = self.tolerance;
        let done = (1.0 - (i.residual / tolerance).ln() / (10.0 / tolerance).ln()).clamp(0.0, 1.0);
        let spread = || self.dof_map.scatter(i.positions);
        let look = Look {
            stage: "drape",
            fraction: SEWING_SHARE + (1.0 - SEWING_SHARE) * done,
            residual: i.residual,
            seam_gap: measure::seam_gap(&self.stitches, i.positions),
            estimate_before: i.estimate_before,
            shape: &spread,
        };
        let flow = self.trace.look(&look);
        if fell {
            ControlFlow::Break(Termination::Interrupted)
        } else if flow.is_continue()
            && i.residual
                <= if i.convex {
                    tolerance
                } else {
                    SADDLE * tolerance
                }
        {
            ControlFlow::Break(Termination::Reached)
        } else {
            flow
        }
    }
}
