//! What a run is expected to take, whether there is time for another level, and what would halve its error.

use crate::solver::drape::monitor::Pace;
use crate::solver::report::schema::{Advice, DrapeReport, LevelReport};

/// The CPU time of a level grows with this power of its vertices, that of one iteration with the next: medians of 18 levels of
/// 13 garments of up to 3900 vertices (finer meshes also take more iterations, as more folds form).
const GROWTH: f64 = 1.9;
const ITERATION_GROWTH: f64 = 1.5;
/// The same of setting one up.
const SET_UP_GROWTH: f64 = 1.2;
/// Iterations that a level must have time for to be begun.
const WORTH: f64 = 3.0;
/// How far a shape moves on a level against the one before it, if there is none to tell: levels have a third of the next one's
/// vertices, and folds moved 0.4 to 1.1 times as far from one to the next on the five garments with three levels.
const SHORTER: f64 = 0.8;
/// Order in the length of mesh edges of the error of smooth shapes.
const ORDER: f64 = 2.0;

/// CPU time that all levels take together \[s\] if the first of them took `first`; their vertices, coarsest first.
pub(crate) fn expected_cpu_s(vertices: &[usize], first: f64) -> f64 {
    let of_first = vertices.first().map_or(1.0, |&v| v as f64);
    let share = |&v: &usize| (v as f64 / of_first).powf(GROWTH);
    first * vertices.iter().map(share).sum::<f64>()
}

/// Whether `left_s` \[CPU s\] is enough to begin on a level `times` as large as the one that ran at `pace`.
pub(crate) fn has_time(left_s: f64, pace: Pace, times: f64) -> bool {
    left_s
        > pace.set_up * times.powf(SET_UP_GROWTH)
            + WORTH * pace.iteration * times.powf(ITERATION_GROWTH)
}

/// How far the shape would still move on `left` finer levels \[m\], from how far it moved on those that ran.
pub(crate) fn moves_left(levels: &[LevelReport], left: usize) -> Option<f64> {
    let moved: Vec<f64> = levels.iter().filter_map(|level| level.moved_m).collect();
    let last = *moved.last()?;
    let ratio = match moved.as_slice() {
        [.., before, last] if *before > 0.0 => (last / before).clamp(1.0 / 3.0, 1.0),
        _ => SHORTER,
    };
    Some((1..=left).fold(0.0, |sum, level| {
        sum + last * ratio.powi(i32::try_from(level).unwrap_or(i32::MAX))
    }))
}

/// What to change to halve the error of a shape at rest, and what it would cost.
pub(crate) fn advice(report: &DrapeReport) -> Option<Advice> {
    if !report.converged {
        return None;
    }
    let total = report.cpu_s.total;
    let solver = report.error_estimate_m.unwrap_or(0.0);
    let iteration = report.levels.last().map_or(0.0, |level| {
        level.cpu_s / level.newton_iterations.max(1) as f64
    });
    Some(match report.mesh_error_m {
        Some(mesh) if solver > mesh => Advice {
            field: "tolerance".to_owned(),
            factor: 0.5,
            cpu_s: total + iteration,
            because: "most of the error is the solver's, and goes down with the residual".to_owned(),
        },
        mesh => Advice {
            field: "edge_length_m".to_owned(),
            factor: 0.5_f64.powf(1.0 / ORDER),
            cpu_s: total * 2.0_f64.powf(2.0 * GROWTH / ORDER),
            because: match mesh {
                Some(_) => "most of the error is the mesh's, and goes down with the square of its edges where the cloth is smooth; folds that fall another way move further",
                None => "the mesh has no coarser ones to tell its error, which goes down with the square of its edges where the cloth is smooth",
            }
            .to_owned(),
        },
    })
}

/// What to change to halve the error of a shape whose time was up: what it takes to halve \[CPU s\], or to come to rest.
pub(crate) fn more_time(total: f64, halving_s: f64) -> Advice {
    Advice {
        field: "time_limit_s".to_owned(),
        factor: 1.0 + halving_s / total,
        cpu_s: total + halving_s,
        because: "the time was up, and the shape still moved".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(moved_m: Option<f64>) -> LevelReport {
        LevelReport {
            vertices: 100,
            newton_iterations: 10,
            cpu_s: 1.0,
            residual: 1e-3,
            moved_m,
        }
    }

    #[test]
    fn moves_go_on_as_a_geometric_series() {
        assert_eq!(moves_left(&[level(None)], 2), None);
        let two = [level(None), level(Some(0.04)), level(Some(0.02))];
        let told = moves_left(&two, 2).expect("two moves are known");
        assert!((told - 0.015).abs() < 1e-15);
    }

    #[test]
    fn time_grows_with_the_power_of_vertices() {
        let told = expected_cpu_s(&[100, 1000], 1.0);
        assert!((told - 1.0 - 10.0_f64.powf(GROWTH)).abs() < 1e-12);
        let mut pace = Pace::default();
        (pace.set_up, pace.iteration) = (1.0, 1.0);
        let needed = 10.0_f64.powf(SET_UP_GROWTH) + WORTH * 10.0_f64.powf(ITERATION_GROWTH);
        assert!(has_time(needed * 1.01, pace, 10.0) && !has_time(needed * 0.99, pace, 10.0));
    }
}
