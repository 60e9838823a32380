//! The conclusions of a study: which run to take, and what to know when reading the numbers.

use super::plan::StudyScene;
use super::report::{Study, StudyRun};
use super::rest_shape::depends_on_path;
use crate::solver::Analysis;

/// The smallest error worth asking for \[m\].
const LEAST_ERROR: f64 = 1e-6;

/// The run to take.
#[derive(Debug)]
pub(super) struct Recommendation<'a> {
    /// Round error that it stays below \[m\].
    pub(super) error_m: f64,
    /// The fastest run that does.
    pub(super) best: &'a StudyRun,
    /// The fastest run of another method that does.
    pub(super) next: Option<&'a StudyRun>,
}

/// Something to know when reading the numbers of a study.
#[derive(Clone, Copy, Debug)]
pub(super) enum StudyNote {
    /// Rest shapes depend on the way there.
    FrictionOfDrapes,
    /// Forces are not smooth.
    FrictionOfMotions,
    /// Every method is of order 1 in the wind.
    WindOfMotions,
    /// There are several rest shapes, without friction.
    SeveralRestShapes,
    /// Mesh errors compare different rest shapes.
    MeshErrorsOfSeveralShapes,
    /// Some errors are upper bounds.
    UncertainErrors,
    /// The error of the finest mesh that has one.
    MeshError { edge_length_m: f64, error_m: f64 },
}

/// Chooses a run on the finest mesh that has errors; none if no run there reached its tolerance
/// with an error that is known.
pub(super) fn recommend(study: &Study) -> Option<Recommendation<'_>> {
    let is_usable = |r: &&StudyRun| r.converged && r.error_m.is_some();
    let usable: Vec<&StudyRun> = study.runs.iter().filter(is_usable).collect();
    let lengths = usable.iter().map(|r| r.edge_length_m);
    let finest = lengths.fold(f64::INFINITY, f64::min);
    let runs: Vec<&StudyRun> = usable
        .into_iter()
        .filter(|r| r.edge_length_m == finest)
        .collect();
    let error_m = common_error(&runs)?;
    let good = loosest_of_each_method(&runs, error_m);
    let best = *good.first()?;
    let next = good.iter().find(|r| r.method != best.method).copied();
    Some(Recommendation {
        error_m,
        best,
        next,
    })
}

/// Returns of each method the loosest run whose error is below `error_m`, the fastest one first:
/// times alone may differ by chance.
fn loosest_of_each_method<'a>(runs: &[&'a StudyRun], error_m: f64) -> Vec<&'a StudyRun> {
    let mut good: Vec<&StudyRun> = Vec::new();
    let is_good = |r: &&&StudyRun| r.error_m.is_some_and(|e| e <= error_m);
    for run in runs.iter().filter(is_good) {
        match good.iter_mut().find(|r| r.method == run.method) {
            Some(known) if looseness(run) > looseness(known) => *known = run,
            Some(_) => {}
            None => good.push(run),
        }
    }
    good.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    good
}

/// Returns the step or the tolerance: the larger it is, the less work.
fn looseness(run: &StudyRun) -> f64 {
    run.step_s.or(run.tolerance).unwrap_or(0.0)
}

/// Returns the smallest round error that two methods reach, or else one \[m\].
fn common_error(runs: &[&StudyRun]) -> Option<f64> {
    let mut methods = Vec::new();
    for run in runs {
        if !methods.contains(&run.method) {
            methods.push(run.method);
        }
    }
    let best_of = |method| {
        let of_method = runs.iter().filter(|r| r.method == method);
        let errors = of_method.filter_map(|r| r.error_m);
        errors.fold(f64::INFINITY, f64::min)
    };
    let mut best: Vec<f64> = methods.into_iter().map(best_of).collect();
    best.sort_by(f64::total_cmp);
    let error = best.get(1).or(best.first())?;
    Some(round_up(error.max(LEAST_ERROR)))
}

/// Returns the next of 1, 2, 5, 10, ... times a power of ten.
fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.max(1e-15).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|s| s * power);
    steps.into_iter().find(|s| *s >= value).unwrap_or(value)
}

/// Returns what to know when reading the numbers of `study`, which was made on `scenes`.
pub(super) fn notes(study: &Study, scenes: &[StudyScene]) -> Vec<StudyNote> {
    let is_drape = study.want == Analysis::Static;
    let has_friction = scenes.iter().any(|s| depends_on_path(&s.scene));
    let has_wind = scenes.iter().any(|s| s.scene.wind.is_some());
    let has_several = study.meshes.iter().any(|m| m.minima.len() > 1);
    let has_mesh_errors = study.meshes.iter().any(|m| m.mesh_error_m.is_some());
    let is_uncertain = |r: &StudyRun| r.error_m.is_some() && !r.error_certain;
    let notes = [
        (is_drape && has_friction, StudyNote::FrictionOfDrapes),
        (!is_drape && has_friction, StudyNote::FrictionOfMotions),
        (!is_drape && has_wind, StudyNote::WindOfMotions),
        (has_several && !has_friction, StudyNote::SeveralRestShapes),
        (
            has_mesh_errors && (has_several || has_friction),
            StudyNote::MeshErrorsOfSeveralShapes,
        ),
        (
            study.runs.iter().any(is_uncertain),
            StudyNote::UncertainErrors,
        ),
    ];
    let notes = notes.into_iter().filter(|(applies, _)| *applies);
    let notes = notes.map(|(_, note)| note);
    notes.chain(mesh_error_note(study)).collect()
}

fn mesh_error_note(study: &Study) -> Option<StudyNote> {
    let meshes = study.meshes.iter().filter(|m| m.mesh_error_m.is_some());
    let finest = meshes.min_by_key(|m| std::cmp::Reverse(m.vertices))?;
    Some(StudyNote::MeshError {
        edge_length_m: finest.edge_length_m,
        error_m: finest.mesh_error_m?,
    })
}

#[cfg(test)]
mod tests {
    use super::round_up;

    #[test]
    fn errors_are_rounded_up_to_one_two_or_five() {
        for (error, round) in [(0.7e-4, 1e-4), (2e-3, 2e-3), (3e-2, 5e-2)] {
            assert!((round_up(error) / round - 1.0).abs() < 1e-12, "{error}");
        }
    }
}
