//! The solve of one level (P9, P10): pull the seams shut, close them for good, let the garment fall
//! and come to rest.

use crate::solver::drape::level::Level;
use crate::solver::drape::relax::relax;
use crate::solver::drape::sew::sew;
use crate::solver::outcome::{LevelOutcome, SewOutcome};
use crate::solver::report::measure::rms_distance;
use crate::solver::statistics::SolveStatistics;
use nalgebra::Vector3;

/// Finds the shape at rest of a level from `x` \[m; `#V`\], its seams closed first unless they are.
/// `x` becomes that shape, or the best one so far.
pub(crate) fn solve_level(
    level: &mut Level<'_, '_, '_>,
    x: &mut Vec<Vector3<f64>>,
) -> LevelOutcome {
    let began = level.monitor.cpu_s();
    let SewOutcome {
        stiffness,
        mut statistics,
    } = if level.is_sewn {
        SewOutcome {
            stiffness: Ok(level.options.sewing_stiffness()),
            statistics: SolveStatistics::default(),
        }
    } else {
        sew(level, x)
    };
    let closed = level.monitor.cpu_s();
    let start = x.clone();
    let relaxation = stiffness.map(|stiffness| {
        let (relaxed, of_relaxing) = relax(level, x, stiffness);
        statistics.merge(&of_relaxing);
        relaxed
    });
    let ended = level.monitor.cpu_s();
    LevelOutcome {
        vertices: x.len(),
        relaxation,
        moved_m: level.is_sewn.then(|| rms_distance(&start, x)),
        statistics,
        sew_s: closed - began,
        relax_s: ended - closed,
    }
}
