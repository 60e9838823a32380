//! Sewing (P9): the stitches pull the panels together, stage by stage, until no gap is left.

use crate::solver::drape::drag::{SETTLED, SEWING_DRAG, SEWING_SPEED_LIMIT};
use crate::solver::drape::level::Level;
use crate::solver::drape::monitor::{IterationRecord, SEWING_SHARE};
use crate::solver::drape::stage::{StageOutcome, run_stage};
use crate::solver::integrate::dynamic_relaxation::DynamicRelaxation;
use crate::solver::model::build::build;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::holds::SewingHold;
use crate::solver::model::seams::Seams;
use crate::solver::optimize::iterate::{Iterate, Termination};
use crate::solver::options::Method;
use crate::solver::outcome::{SewOutcome, Unfinished};
use crate::solver::report::measure::seam_gap;
use crate::solver::statistics::{Fallback, SolveStatistics, TermTimes};
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Number of times that the stitches are made ten times stiffer where the seams settle with a gap.
const STIFFENINGS: usize = 3;
/// Iterations without a smaller gap after which a coarser mesh is left as it is: on a finer one
/// there is more room to slide, and sewing goes on there.
const PATIENCE: usize = 150;
/// Share of the smallest gap so far that counts as smaller.
const SMALLER: f64 = 0.99;
/// Greatest pull of a seam, over its length \[N/m\], before it is made stiffer: stitches half a
/// meter long would draw straps off the shoulders and bands over the hip on their way.
const MAX_PULL: f64 = 200.0;
/// Motion of explicit steps while sewing.
const MOTION: DynamicRelaxation = DynamicRelaxation {
    method: Method::SymplecticEuler,
    drag: SEWING_DRAG,
    speed_limit: SEWING_SPEED_LIMIT,
    step: None,
    tolerance: SETTLED,
};

/// Pulls the seams shut, stage by stage.
pub(crate) fn sew(level: &mut Level<'_, '_, '_>, x: &mut [Vector3<f64>]) -> SewOutcome {
    let mut statistics = SolveStatistics::default();
    let stiffness = close_rounds(level, x, &mut statistics);
    SewOutcome {
        stiffness,
        statistics,
    }
}

/// Stitches that are pulled at once.
struct Round {
    /// The garment's stage that they belong to.
    stage: u32,
    stitches: Vec<(usize, usize)>,
    /// Panels that are held firmly meanwhile.
    held: Vec<usize>,
}

/// Returns the rounds in which seams close: stage by stage, and what carries the garment first.
fn rounds(level: &Level<'_, '_, '_>) -> Vec<Round> {
    let mesh = &level.scene.mesh;
    let mut stages: Vec<u32> = mesh.stitches.iter().map(|s| s.stage).collect();
    stages.sort_unstable();
    stages.dedup();
    let round = |stage: u32| Round {
        stage,
        stitches: level.stitches(stage),
        held: vec![],
    };
    let mut rounds: Vec<Round> = stages.into_iter().map(round).collect();
    let carriers = &level.scene.carriers;
    if carriers.is_empty() || !is_held(level) {
        return rounds;
    }
    if let Some(all) = rounds.first_mut() {
        let carries = |vertex: usize| {
            carriers
                .binary_search(&mesh.panel_of_vertex(vertex))
                .is_ok()
        };
        let between = all.stitches.iter().copied();
        let first = Round {
            stage: all.stage,
            stitches: between.filter(|&(a, b)| carries(a) && carries(b)).collect(),
            held: vec![],
        };
        all.held.clone_from(carriers);
        rounds.insert(0, first);
    }
    rounds
}

/// Returns true if panels are held while their seams close: on a body, and not in steps of motion,
/// which know pair forces alone.
fn is_held(level: &Level<'_, '_, '_>) -> bool {
    level.scene.body.is_some() && !level.options.method.is_time_stepping()
}

/// Closes all seams, later ones with the stiffness that closed the earlier; returns the last
/// stiffness \[N/m\].
fn close_rounds(
    level: &mut Level<'_, '_, '_>,
    x: &mut [Vector3<f64>],
    statistics: &mut SolveStatistics,
) -> Result<f64, Unfinished> {
    let mut stiffness = level.options.sewing_stiffness();
    for mut round in rounds(level) {
        let places = if round.held.is_empty() {
            vec![]
        } else {
            x.to_vec()
        };
        let mut stiffenings = 0;
        loop {
            let (pulled, of_pull) = pull(level, x, &round, &places, stiffness);
            statistics.merge(&of_pull);
            let gap = seam_gap(&round.stitches, x);
            if gap < level.options.seam_eps_m {
                break;
            }
            let is_settled = pulled.termination == Termination::Reached;
            let is_stuck = matches!(
                pulled.termination,
                Termination::Stalled | Termination::IterationLimit
            );
            // What is held too high or too low for the rest is let go first.
            if !round.held.is_empty() && (is_settled || is_stuck) {
                round.held.clear();
                continue;
            }
            if !is_settled || stiffenings == STIFFENINGS {
                return Err(Unfinished::SeamsOpen {
                    stage: round.stage,
                    gap_m: gap,
                    end: pulled.end(level.monitor.canceled),
                    residual: pulled.residual,
                });
            }
            stiffenings += 1;
            stiffness *= 10.0;
            statistics.fallbacks.insert(Fallback::StifferSeams);
        }
    }
    Ok(stiffness)
}

/// Pulls once, with stitches of a stiffness \[N/m\]; what is held firmly stays at `places` \[m\].
fn pull(
    level: &mut Level<'_, '_, '_>,
    x: &mut [Vector3<f64>],
    round: &Round,
    places: &[Vector3<f64>],
    stiffness: f64,
) -> (StageOutcome, SolveStatistics) {
    let Round { stitches, held, .. } = round;
    let is_held = is_held(level);
    let edge = level.scene.mesh.mean_edge();
    let build_options = BuildOptions {
        seams: Seams::Open {
            stitches: stitches.clone(),
            stiffness,
            // Scenes of springs alone have no triangles, and no edge.
            max_force: if is_held && edge > 0.0 {
                MAX_PULL * edge * stiffness / level.options.sewing_stiffness()
            } else {
                f64::INFINITY
            },
        },
        hold: is_held.then_some(SewingHold {
            panels: held,
            places,
        }),
        gravity: false,
        friction: None,
        explicit: level.options.method.is_explicit(),
        least_thickness: level.least_thickness(),
        finest: level.is_finest,
    };
    let mut system = build(level.scene, level.options, &build_options, level.clock).system;
    let was_tangled = system.untangle(x);
    let first_gap = seam_gap(stitches, x).max(1e-9);
    let eps = level.options.seam_eps_m;
    let method = level.stage_method(MOTION);
    level.monitor.begin_stage();
    let monitor = &mut level.monitor;
    let mut last_residual = f64::NAN;
    let may_stall = !level.is_finest || !held.is_empty();
    let mut smallest = SmallestGap::default();
    let mut callback = |iterate: Iterate<'_>| {
        last_residual = iterate.residual;
        let gap = seam_gap(stitches, iterate.positions);
        let closed = (gap / first_gap).ln() / (eps / first_gap).min(0.9).ln();
        let flow = monitor.record(&IterationRecord {
            stage: "sew",
            fraction: SEWING_SHARE * closed,
            residual: iterate.residual,
            seam_gap: gap,
            estimate_before: None,
            shape: &|| iterate.positions.to_vec(),
        });
        let stalled = may_stall && smallest.has_stalled(iterate.number, gap);
        let settled = gap < eps || (iterate.number > 0 && iterate.residual < SETTLED);
        if flow.is_continue() && settled {
            ControlFlow::Break(Termination::Reached)
        } else if flow.is_continue() && stalled {
            ControlFlow::Break(Termination::Stalled)
        } else {
            flow
        }
    };
    let (mut outcome, _) = run_stage(&mut system, x, method, &mut callback);
    outcome.residual = last_residual;
    let mut statistics = outcome.statistics(TermTimes::of_system(&system));
    if was_tangled {
        statistics.fallbacks.insert(Fallback::UntangledCloth);
    }
    (outcome, statistics)
}

/// The smallest gap of a pull so far.
struct SmallestGap {
    /// \[m\]
    gap: f64,
    /// Iteration that it is of.
    iteration: usize,
}

impl Default for SmallestGap {
    fn default() -> Self {
        Self {
            gap: f64::INFINITY,
            iteration: 0,
        }
    }
}

impl SmallestGap {
    /// Takes the gap of an iteration \[m\]; returns true if it has been no smaller for long.
    fn has_stalled(&mut self, iteration: usize, gap: f64) -> bool {
        if gap < SMALLER * self.gap {
            *self = Self { gap, iteration };
        }
        iteration - self.iteration > PATIENCE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[test]
    fn seams_that_close_slowly_go_on() {
        let mut smallest = SmallestGap::default();
        // One percent in half the patience.
        let gap = |i: usize| 0.1 * 0.989_f64.powf(2.0 * i as f64 / PATIENCE as f64);
        assert!((0..10 * PATIENCE).all(|i| !smallest.has_stalled(i, gap(i))));
    }

    #[test]
    fn gaps_that_come_and_go_stall() {
        let mut smallest = SmallestGap::default();
        let gap = |i: usize| [3e-3, 2e-3, 4e-3][i % 3];
        let stalled = (0..).find(|&i| smallest.has_stalled(i, gap(i)));
        // The smallest gap is that of the second iteration.
        assert_eq!(stalled, Some(1 + PATIENCE + 1));
    }
}
