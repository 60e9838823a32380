//! Distance of a shape from the solution: by the Hessian where that tells it, else by the moves of
//! the shape.

use crate::solver::drape::stage::StageOutcome;
use crate::solver::model::system::System;
use crate::solver::optimize::iterate::Termination;
use crate::solver::optimize::newton::Newton;
use crate::solver::optimize::pseudo_transient::NEAR_GAMMA;
use crate::solver::outcome::{
    ESTIMATE_RESIDUAL_LIMIT, ErrorEstimate, LevelOutcome, RelaxOutcome, Validity,
};
use crate::solver::report::cost_model::remaining_moves;
use nalgebra::Vector3;

/// Estimates how far the shape of a stage is from the solution of its mesh, `‖H⁻¹ f‖`; none where
/// the Hessian does not tell.
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn estimate_by_hessian(
    system: &mut System<'_>,
    shape: &[Vector3<f64>],
    (newton, stage): (Option<Newton>, &StageOutcome),
) -> Option<ErrorEstimate> {
    let at_rest = stage.termination == Termination::Reached;
    let newton = newton.or_else(|| {
        let newton = at_rest.then(|| Newton::new(system, NEAR_GAMMA));
        newton?.ok()
    });
    // Far from rest the Hessian has no factor, and it would take time to find that out.
    let mut newton = newton.filter(|n| at_rest || n.is_convex())?;
    let distance_m = newton.error_estimate(system, shape);
    let is_near = stage.residual <= ESTIMATE_RESIDUAL_LIMIT;
    let validity = match (distance_m, newton.contact_settled, is_near) {
        (None, _, _) => Validity::NotInMinimum,
        (Some(_), true, true) => Validity::Valid,
        (Some(_), false, _) => Validity::ContactUnsettled,
        (Some(_), true, false) => Validity::FarFromRest,
    };
    Some(ErrorEstimate {
        distance_m,
        validity,
    })
}

/// Estimates how far a shape is from the solution where its Hessian does not tell, by the moves of
/// its last level and of those before; `finer` levels were not run. A valid estimate is returned as
/// it is.
pub(crate) fn estimate_by_moves(
    levels: &[LevelOutcome],
    last: &RelaxOutcome,
    finer: usize,
) -> ErrorEstimate {
    let by_hessian = last.estimate.unwrap_or(ErrorEstimate {
        distance_m: None,
        validity: Validity::Unknown,
    });
    if by_hessian.validity == Validity::Valid {
        return by_hessian;
    }
    let is_at_rest = last.end.is_ok();
    let known = by_hessian.distance_m.filter(|_| is_at_rest);
    let moves = moves_left(levels, last, finer);
    match moves.filter(|moves| known.is_none() && moves.is_finite()) {
        Some(moves) => ErrorEstimate {
            distance_m: Some(moves.max(by_hessian.distance_m.unwrap_or(0.0))),
            validity: Validity::ByMoves,
        },
        None => by_hessian,
    }
}

/// Distance that the shape would still move on its own level and on the `finer` ones \[m\].
fn moves_left(levels: &[LevelOutcome], last: &RelaxOutcome, finer: usize) -> Option<f64> {
    let earlier = &levels[..levels.len().saturating_sub(1)];
    let on_finer = remaining_moves(&moves(levels), finer).filter(|_| finer > 0);
    if last.end.is_ok() && finer > 0 {
        return on_finer;
    }
    // It will hardly move further than it did on the level before.
    let most = moves(earlier).last().copied().unwrap_or(f64::INFINITY);
    match last.remaining {
        // It was stopped before it moved: all of this level is still to come.
        None => remaining_moves(&moves(earlier), finer + 1),
        Some(remaining) => {
            let here = remaining.distance_m.min(most);
            Some(here.hypot(on_finer.unwrap_or(0.0)))
        }
    }
}

/// Distances that the shape moved on those levels that another one handed it to \[m\].
fn moves(levels: &[LevelOutcome]) -> Vec<f64> {
    levels.iter().filter_map(|level| level.moved_m).collect()
}
