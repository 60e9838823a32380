//! Cost model: CPU time that levels take, the time for another level, and what halving the error
//! takes.

use crate::solver::drape::monitor::IterationPace;
use crate::solver::outcome::DrapeOutcome;

/// Exponent with which the CPU time of a level grows with its vertices: median of 18 levels of 13
/// garments of up to 3900 vertices (finer meshes also take more iterations, as more folds form).
const LEVEL_TIME_EXPONENT: f64 = 1.9;
/// Exponent of the CPU time of one iteration, of the same levels.
const ITERATION_TIME_EXPONENT: f64 = 1.5;
/// Exponent of the CPU time of setting a level up.
const SETUP_TIME_EXPONENT: f64 = 1.2;
/// Iterations that a level must have time for to be begun.
const LEAST_ITERATIONS: f64 = 3.0;
/// Ratio of the moves on a level to those on the one before it, if there is none to tell: levels
/// have a third of the next one's vertices, and folds moved 0.4 to 1.1 times as far from one to the
/// next on the five garments with three levels.
const MOVE_RATIO: f64 = 0.8;
/// Order in the length of mesh edges of the error of smooth shapes.
const MESH_ERROR_ORDER: f64 = 2.0;

/// Returns the CPU time that all levels take together \[s\] if the first of them took `first`;
/// their vertices, coarsest first.
pub(crate) fn expected_cpu_s(vertices: &[usize], first: f64) -> f64 {
    let of_first = vertices.first().map_or(1.0, |&v| v as f64);
    let share = |&v: &usize| (v as f64 / of_first).powf(LEVEL_TIME_EXPONENT);
    first * vertices.iter().map(share).sum::<f64>()
}

/// Returns true if `left_s` \[CPU s\] is enough to begin on a level `times` as large as the one
/// that ran at `pace`.
pub(crate) fn has_time(left_s: f64, pace: IterationPace, times: f64) -> bool {
    left_s
        > pace.set_up * times.powf(SETUP_TIME_EXPONENT)
            + LEAST_ITERATIONS * pace.iteration * times.powf(ITERATION_TIME_EXPONENT)
}

/// Returns how far the shape would still move on `left` finer levels \[m\], from how far it `moved`
/// on those that ran.
pub(crate) fn remaining_moves(moved: &[f64], left: usize) -> Option<f64> {
    let last = *moved.last()?;
    let ratio = match moved {
        [.., before, last] if *before > 0.0 => (last / before).clamp(1.0 / 3.0, 1.0),
        _ => MOVE_RATIO,
    };
    Some((1..=left).fold(0.0, |sum, level| {
        sum + last * ratio.powi(i32::try_from(level).unwrap_or(i32::MAX))
    }))
}

/// Option whose change would halve the error, and the CPU time that the whole run is then expected
/// to take \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ErrorHalving {
    /// The tolerance: most of the error is the solver's.
    Tolerance { cpu_s: f64 },
    /// The length of mesh edges: most of the error is the mesh's, so far as that is known.
    EdgeLength { is_error_known: bool, cpu_s: f64 },
    /// The time limit: it was up.
    TimeLimit { factor: f64, cpu_s: f64 },
}

impl ErrorHalving {
    /// Returns the factor by which the option is to be multiplied.
    pub(crate) fn factor(self) -> f64 {
        match self {
            Self::Tolerance { .. } => 0.5,
            Self::EdgeLength { .. } => 0.5_f64.powf(1.0 / MESH_ERROR_ORDER),
            Self::TimeLimit { factor, .. } => factor,
        }
    }

    /// Returns the CPU time that the whole run is then expected to take \[s\].
    pub(crate) fn cpu_s(self) -> f64 {
        match self {
            Self::Tolerance { cpu_s }
            | Self::EdgeLength { cpu_s, .. }
            | Self::TimeLimit { cpu_s, .. } => cpu_s,
        }
    }
}

/// Returns what would halve the error of a drape: more time where that was up, less error of the
/// solver or the mesh where the shape is at rest.
pub(crate) fn error_halving(outcome: &DrapeOutcome) -> Option<ErrorHalving> {
    match outcome.time_limit_reached() {
        Some(_) => by_time(outcome),
        None => outcome.end.is_ok().then(|| by_accuracy(outcome)),
    }
}

/// Returns more time: as long as halving takes, or else as all levels were expected to take.
fn by_time(outcome: &DrapeOutcome) -> Option<ErrorHalving> {
    let total = outcome.cpu_s;
    let all = outcome.plan.expected_cpu_s.map(|all| all - total);
    let more = outcome.halving_s.or(all).filter(|more_s| *more_s > 0.0);
    more.map(|more_s| ErrorHalving::TimeLimit {
        factor: 1.0 + more_s / total,
        cpu_s: total + more_s,
    })
}

/// Returns a lower tolerance or shorter mesh edges, whichever error is larger.
fn by_accuracy(outcome: &DrapeOutcome) -> ErrorHalving {
    let total = outcome.cpu_s;
    let of_solver = outcome.estimate.and_then(|estimate| estimate.distance_m);
    match outcome.mesh_error_m {
        Some(of_mesh) if of_solver.unwrap_or(0.0) > of_mesh => {
            let iteration = outcome.levels.last().map_or(0.0, |level| {
                level.cpu_s() / level.statistics.iterations.max(1) as f64
            });
            ErrorHalving::Tolerance {
                cpu_s: total + iteration,
            }
        }
        of_mesh => ErrorHalving::EdgeLength {
            is_error_known: of_mesh.is_some(),
            cpu_s: total * 2.0_f64.powf(2.0 * LEVEL_TIME_EXPONENT / MESH_ERROR_ORDER),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_go_on_as_a_geometric_series() {
        assert_eq!(remaining_moves(&[], 2), None);
        let told = remaining_moves(&[0.04, 0.02], 2).expect("two moves are known");
        assert!((told - 0.015).abs() < 1e-15);
    }

    #[test]
    fn time_grows_with_the_power_of_vertices() {
        let told = expected_cpu_s(&[100, 1000], 1.0);
        assert!((told - 1.0 - 10.0_f64.powf(LEVEL_TIME_EXPONENT)).abs() < 1e-12);
        let mut pace = IterationPace::default();
        (pace.set_up, pace.iteration) = (1.0, 1.0);
        let needed = 10.0_f64.powf(SETUP_TIME_EXPONENT)
            + LEAST_ITERATIONS * 10.0_f64.powf(ITERATION_TIME_EXPONENT);
        assert!(has_time(needed * 1.01, pace, 10.0) && !has_time(needed * 0.99, pace, 10.0));
    }
}
