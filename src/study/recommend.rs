//! What a study says in words.

use super::plot::{method_name, setting};
use super::report::{Study, StudyRun};
use super::rest::depends_on_path;
use super::run::{StudyScene, edges};
use crate::solver::Analysis;

/// Smaller errors are of no use to anyone \[m\].
const LEAST: f64 = 1e-6;

/// What to take, from the runs on the finest mesh that has errors.
pub(super) fn sentence(study: &Study) -> String {
    let usable = || {
        let such = |r: &&StudyRun| r.converged && r.error_m.is_some();
        study.runs.iter().filter(such)
    };
    let finest = usable()
        .map(|r| r.edge_length_m)
        .fold(f64::INFINITY, f64::min);
    let runs: Vec<&StudyRun> = usable().filter(|r| r.edge_length_m == finest).collect();
    let Some(target) = target(&runs) else {
        return "Nothing can be recommended: no run reached what was asked with an error that is known; allow more time."
            .to_owned();
    };
    // Of each method the loosest run that is good enough: times alone may differ by chance.
    let mut good: Vec<&StudyRun> = Vec::new();
    for run in runs
        .iter()
        .filter(|r| r.error_m.is_some_and(|e| e <= target))
    {
        match good.iter_mut().find(|r| r.method == run.method) {
            Some(known) if looseness(run) > looseness(known) => *known = run,
            Some(_) => {}
            None => good.push(run),
        }
    }
    good.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    let Some(best) = good.first() else {
        return "Nothing can be recommended.".to_owned();
    };
    let other = good.iter().find(|r| r.method != best.method);
    let taken = format!(
        "For errors below {} mm on {} take {} with {}: {:.2} s",
        plain(1e3 * target),
        edges(finest),
        method_name(best),
        setting(best),
        best.cpu_s
    );
    match other {
        Some(next) if best.cpu_s > 0.0 => format!(
            "{taken}; the next best, {} with {}, needs {} times as long.",
            method_name(next),
            setting(next),
            plain(rounded(next.cpu_s / best.cpu_s))
        ),
        _ => format!("{taken}; no other method came so near."),
    }
}

/// The longer a step or the larger a tolerance, the less work.
fn looseness(run: &StudyRun) -> f64 {
    run.step_s.or(run.tolerance).unwrap_or(0.0)
}

/// The smallest round error that two methods reach, or else one \[m\].
fn target(runs: &[&StudyRun]) -> Option<f64> {
    let mut best: Vec<f64> = Vec::new();
    let mut methods = Vec::new();
    for run in runs {
        if !methods.contains(&run.method) {
            methods.push(run.method);
        }
    }
    for method in methods {
        let of_method = runs.iter().filter(|r| r.method == method);
        best.push(
            of_method
                .filter_map(|r| r.error_m)
                .fold(f64::INFINITY, f64::min),
        );
    }
    best.sort_by(f64::total_cmp);
    let error = best.get(1).or(best.first())?;
    Some(round_up(error.max(LEAST)))
}

/// The next of 1, 2, 5, 10, ... times a power of ten.
fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.max(1e-15).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|s| s * power);
    steps.into_iter().find(|s| *s >= value).unwrap_or(value)
}

/// A ratio as one says it: two digits.
fn rounded(ratio: f64) -> f64 {
    if ratio < 10.0 {
        (10.0 * ratio).round() / 10.0
    } else {
        let power = 10f64.powf(ratio.log10().floor() - 1.0);
        (ratio / power).round() * power
    }
}

/// A number without a tail of rounding.
fn plain(value: f64) -> String {
    if (1e-4..1e6).contains(&value) {
        let digits = format!("{value:.6}");
        digits
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    } else {
        format!("{value:.0e}")
    }
}

/// What to know when reading the numbers.
pub(super) fn notes(study: &Study, scenes: &[StudyScene]) -> Vec<String> {
    let mut notes = Vec::new();
    let mut note = |such: bool, text: &str| {
        if such {
            notes.push(text.to_owned());
        }
    };
    let drape = study.want == Analysis::Static;
    let friction = scenes.iter().any(|s| depends_on_path(&s.scene));
    note(
        drape && friction,
        "There is friction against the body: rest shapes depend on the way there, so methods and meshes come to rest in different ones and none is the right one; an error is the distance to where friction lets the run itself go.",
    );
    note(
        !drape && friction,
        "There is friction against the body: forces are not smooth, and observed orders may fall short of theory.",
    );
    note(
        !drape && scenes.iter().any(|s| s.scene.wind.is_some()),
        "There is wind, which is taken from the velocity of the step before: every method is of order 1 in it.",
    );
    let several = study.meshes.iter().any(|m| m.minima.len() > 1);
    note(
        several && !friction,
        "Several rest shapes exist, as cloth wrinkles one way or another: an error is the distance to the rest shape that the run itself leads to, not between them; compare their energies.",
    );
    let compared = study.meshes.iter().any(|m| m.mesh_error_m.is_some());
    note(
        compared && (several || friction),
        "Mesh errors hold differences between rest shapes too.",
    );
    let uncertain = study
        .runs
        .iter()
        .any(|r| r.error_m.is_some() && !r.error_certain);
    note(
        uncertain,
        "Errors that are not certain are upper bounds: they are as small as what they are measured by.",
    );
    notes.extend(mesh_note(study));
    notes
}

/// Which error is the greater one.
fn mesh_note(study: &Study) -> Option<String> {
    let mesh = study.meshes.iter().filter(|m| m.mesh_error_m.is_some());
    let mesh = mesh.min_by_key(|m| std::cmp::Reverse(m.vertices))?;
    Some(format!(
        "Between {} and the finest mesh the reference moves by {:.2} mm: a solver error far below that is not worth its time.",
        edges(mesh.edge_length_m),
        1e3 * mesh.mesh_error_m?
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_said_round() {
        assert_eq!(plain(1e3 * round_up(0.7e-4)), "0.1");
        assert_eq!(plain(1e3 * round_up(2e-3)), "2");
        assert_eq!(plain(rounded(31.4159)), "31");
        assert_eq!(plain(rounded(1.27)), "1.3");
        assert_eq!(plain(2e-9), "2e-9");
    }
}
