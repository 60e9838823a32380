//! Relaxation (P10): the seams are closed for good, and the garment falls until nothing moves any
//! more.

use crate::solver::drape::drag::{RELAXATION_DRAG, RELAXATION_SPEED_LIMIT, SETTLED};
use crate::solver::drape::error_estimate::estimate_by_hessian;
use crate::solver::drape::level::Level;
use crate::solver::drape::monitor::{IterationRecord, Monitor, SEWING_SHARE};
use crate::solver::drape::stage::{StageMethod, StageOutcome, run_stage};
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::model::build::{Model, build};
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::seams::Seams;
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::{Iterate, Termination};
use crate::solver::optimize::newton::Newton;
use crate::solver::options::Method;
use crate::solver::outcome::{
    AtRest, ESTIMATE_RESIDUAL_LIMIT, ForceBalance, RelaxOutcome, Unfinished,
};
use crate::solver::report::measure::{energies, mean_height, seam_gap};
use crate::solver::statistics::{Fallback, SolveStatistics, TermTimes};
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Distance that the middle of a garment sinks before it is plain that nothing will stop it \[m\].
const FREE_FALL: f64 = 0.5;
/// Share of the tolerance at which a shape counts as at rest even if it is not in a minimum.
pub(crate) const SADDLE: f64 = 0.01;
/// Motion of explicit steps.
const MOTION: DynamicRelaxation = DynamicRelaxation {
    method: Method::SymplecticEuler,
    drag: RELAXATION_DRAG,
    speed_limit: RELAXATION_SPEED_LIMIT,
    step: None,
    tolerance: SETTLED,
};

/// Closes the seams for good, as welds or as springs stiffer than `stiffness` \[N/m\], and lets the
/// garment come to rest.
pub(crate) fn relax(
    level: &mut Level<'_, '_, '_>,
    x: &mut Vec<Vector3<f64>>,
    stiffness: f64,
) -> (RelaxOutcome, SolveStatistics) {
    let stitches = level.stitches(u32::MAX);
    let build_options = BuildOptions {
        seams: Seams::closed(level.options, stiffness),
        hold: None,
        gravity: true,
        friction: Some(&level.anchors),
        explicit: level.options.method.is_explicit(),
        least_thickness: level.least_thickness(),
        finest: level.is_finest,
    };
    level.monitor.begin_stage();
    let Model {
        dof_map,
        mut system,
    } = build(level.scene, level.options, &build_options, level.clock);
    let mut shape = dof_map.average(x);
    let was_tangled = system.untangle(&mut shape);
    let gravity = level.scene.gravity;
    let first_height = mean_height(&gravity, &shape);
    let floor = system.residual_floor(&shape);
    let tolerance = level.tolerance.max(level.floor_multiple * floor);
    let mut relaxation = Relaxation {
        method: level.stage_method(DynamicRelaxation {
            drag: level.scene.drag.unwrap_or(MOTION.drag),
            tolerance,
            ..MOTION
        }),
        gravity,
        dof_map: &dof_map,
        stitches: dof_map.pairs(&stitches),
        tolerance,
        tolerance_m: level.tolerance_m,
        is_near: false,
        monitor: level.monitor,
    };
    let (stage, newton) = relaxation.run(&mut system, &mut shape);
    let is_near = relaxation.is_near;
    *x = dof_map.scatter(&shape);
    let canceled = level.monitor.canceled;
    let estimate = level
        .is_finest
        .then(|| estimate_by_hessian(&mut system, &shape, (newton, &stage)));
    let balance = ForceBalance {
        residual: stage.residual,
        residual_floor: floor,
        // Of every level: it may be the last that there is time for.
        energy: energies(&mut system, &shape),
    };
    let reached = if is_near {
        AtRest::WithinDistance
    } else if tolerance > level.tolerance {
        AtRest::AtRoundOffFloor
    } else {
        AtRest::WithinTolerance
    };
    let mut statistics = stage.statistics(TermTimes::of_system(&system));
    if was_tangled {
        statistics.fallbacks.insert(Fallback::UntangledCloth);
    }
    let outcome = RelaxOutcome {
        end: end(&stage, canceled, reached),
        balance,
        estimate: estimate.flatten(),
        remaining: level.monitor.remaining_error(stage.residual, x),
        fell: stage.fell,
        sunk_m: first_height - mean_height(&gravity, &shape),
        anchors: system.anchors(),
    };
    (outcome, statistics)
}

/// Returns success or failure of a relaxation; success is what was `reached`.
fn end(stage: &StageOutcome, canceled: bool, reached: AtRest) -> Result<AtRest, Unfinished> {
    match stage.termination {
        Termination::Reached => Ok(reached),
        _ => Err(Unfinished::NotRelaxed {
            end: stage.end(canceled),
            residual: stage.residual,
        }),
    }
}

/// A run toward the shape at rest.
struct Relaxation<'a, 'c, 'w> {
    method: StageMethod,
    gravity: Vector3<f64>,
    dof_map: &'a DofMap,
    /// Pairs of particles that are sewn together and still two.
    stitches: Vec<(usize, usize)>,
    tolerance: f64,
    /// Distance to the rest shape that will do \[m\].
    tolerance_m: Option<f64>,
    /// True once that was reached.
    is_near: bool,
    monitor: &'a mut Monitor<'c, 'w>,
}

impl Relaxation<'_, '_, '_> {
    /// Runs to rest, or until the garment falls.
    fn run(
        &mut self,
        system: &mut System<'_>,
        shape: &mut [Vector3<f64>],
    ) -> (StageOutcome, Option<Newton>) {
        let first_height = mean_height(&self.gravity, shape);
        let (mut last_residual, mut fell) = (f64::NAN, false);
        let method = self.method;
        let mut callback = |iterate: Iterate<'_>| {
            last_residual = iterate.residual;
            fell = first_height - mean_height(&self.gravity, iterate.positions) > FREE_FALL;
            self.test(iterate, fell)
        };
        let (mut outcome, newton) = run_stage(system, shape, method, &mut callback);
        outcome.residual = last_residual;
        outcome.fell = fell;
        (outcome, newton)
    }

    /// Records an iterate and tests it for rest.
    fn test(&mut self, iterate: Iterate<'_>, fell: bool) -> ControlFlow<Termination> {
        let (tolerance, residual) = (self.tolerance, iterate.residual);
        let done = (1.0 - (residual / tolerance).ln() / (10.0 / tolerance).ln()).clamp(0.0, 1.0);
        let flow = self.monitor.record(&IterationRecord {
            stage: "drape",
            fraction: SEWING_SHARE + (1.0 - SEWING_SHARE) * done,
            residual,
            seam_gap: seam_gap(&self.stitches, iterate.positions),
            estimate_before: iterate.estimate_before,
            shape: &|| self.dof_map.scatter(iterate.positions),
        });
        self.is_near = self
            .tolerance_m
            .is_some_and(|most| is_within(&iterate, most));
        let share = if iterate.convex { 1.0 } else { SADDLE };
        if fell {
            ControlFlow::Break(Termination::Interrupted)
        } else if flow.is_continue() && (self.is_near || residual <= share * tolerance) {
            ControlFlow::Break(Termination::Reached)
        } else {
            flow
        }
    }
}

/// Returns true if an iterate is within `most` \[m, RMS\] of the rest shape: the one before was, in
/// a minimum of the energy, in contact that does not change and so near to rest that the Hessian
/// tells, and this one is nearer.
fn is_within(iterate: &Iterate<'_>, most: f64) -> bool {
    let is_told = iterate.convex && iterate.contact_settled;
    let before = iterate.estimate_before.filter(|_| is_told);
    before.is_some_and(|distance| distance <= most) && iterate.residual <= ESTIMATE_RESIDUAL_LIMIT
}
