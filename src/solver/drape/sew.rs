//! Sewing (P9): the stitches pull the panels together, stage by stage, until no gap is left.

use crate::solver::drape::level::{Level, SETTLED};
use crate::solver::drape::monitor::{Look, SEWING_SHARE};
use crate::solver::drape::stage::{Ended, note_fallbacks, push_once, run};
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::model::build::{Stage, assemble};
use crate::solver::model::dof_map::DofMap;
use crate::solver::optimize::iterate::{Iterate, Termination};
use crate::solver::options::Method;
use crate::solver::options::SolverOptions;
use crate::solver::report::describe::add_terms;
use crate::solver::report::measure;
use crate::solver::report::schema::DrapeReport;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Stiffness of a stitch if none is asked for \[N/m\]: about that of the cloth beside it.
pub(crate) const SEAM_STIFFNESS: f64 = 1e4;
/// How much stiffer than while sewing the spring of a closed seam is (P9).
const CLOSED_STIFFER: f64 = 10.0;
/// How often the stitches are made ten times stiffer when the seams settle with a gap.
const STIFFER_AT_MOST: usize = 3;
/// Drag \[1/s\] and speed limit \[m/s\] of explicit steps while sewing.
const MOTION: DynamicRelaxation = DynamicRelaxation {
    method: Method::SymplecticEuler,
    drag: 40.0,
    speed_limit: 2.0,
    step: None,
    tolerance: SETTLED,
};

/// Stiffness of a closed stitch, `sewing` being what closed it \[N/m\]: the one asked for, or much stiffer than that (P9).
pub(crate) fn closed_stiffness(options: &SolverOptions, sewing: f64) -> f64 {
    options
        .seam_stiffness_n_m
        .unwrap_or(sewing * CLOSED_STIFFER)
}

/// Pulls the seams shut, stage by stage; the stiffness that did it \[N/m\], or why it could not be done.
pub(crate) fn close(
    level: &mut Level<'_, '_, '_>,
    x: &mut [Vector3<f64>],
    report: &mut DrapeReport,
) -> Result<f64, String> {
    let mut stiffness = level.options.seam_stiffness_n_m.unwrap_or(SEAM_STIFFNESS);
    let stitches = level.scene.mesh.stitches.iter();
    let mut stages: Vec<u32> = stitches.map(|s| s.stage).collect();
    stages.sort_unstable();
    stages.dedup();
    for stage in stages {
        let stitches = level.stitches(stage);
        let mut tries = 0;
        loop {
            let ended = pull(level, x, (&stitches, stiffness), report);
            note_fallbacks(&mut report.fallbacks, ended.fallbacks);
            let gap = measure::seam_gap(&stitches, x);
            if gap < level.options.seam_eps_m {
                break;
            }
            if ended.stop != Termination::Reached || tries == STIFFER_AT_MOST {
                return Err(format!(
                    "the seams of stage {stage} are still {:.2} mm apart: {}",
                    gap * 1e3,
                    ended.reason(level.trace.canceled)
                ));
            }
            tries += 1;
            stiffness *= 10.0;
            push_once(&mut report.fallbacks, "stiffer_seams");
        }
    }
    Ok(stiffness)
}

/// Pulls once, with stitches of a stiffness \[N/m\].
fn pull(
    level: &mut Level<'_, '_, '_>,
    x: &mut [Vector3<f64>],
    (stitches, stiffness): (&[(usize, usize)], f64),
    report: &mut DrapeReport,
) -> Ended {
    let dof_map = DofMap::identity(x.len());
    let stage = Stage {
        dof_map: &dof_map,
        stitches: Some((stitches.to_vec(), stiffness)),
        gravity: false,
        friction: None,
        explicit: level.options.method.is_explicit(),
    };
    let mut system = assemble(level.scene, level.options, &stage, level.clock);
    let first_gap = measure::seam_gap(stitches, x).max(1e-9);
    let eps = level.options.seam_eps_m;
    let how = level.how(MOTION);
    level.trace.begin_stage();
    let trace = &mut level.trace;
    let mut last = f64::NAN;
    let mut callback = |i: Iterate<'_>| {
        last = i.residual;
        let gap = measure::seam_gap(stitches, i.positions);
        let closed = (gap / first_gap).ln() / (eps / first_gap).min(0.9).ln();
        let flow = trace.look(&Look {
            stage: "sew",
            fraction: SEWING_SHARE * closed,
            residual: i.residual,
            seam_gap: gap,
            estimate_before: None,
            shape: &|| i.positions.to_vec(),
        });
        let settled = gap < eps || (i.number > 0 && i.residual < SETTLED);
        if flow.is_continue() && settled {
            ControlFlow::Break(Termination::Reached)
        } else {
            flow
        }
    };
    let mut ended = run(&mut system, x, how, &mut callback).0;
    ended.residual = last;
    add_terms(&mut report.terms, &system);
    report.newton_iterations += ended.iterations;
    ended
}
