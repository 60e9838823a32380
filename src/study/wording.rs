//! Every sentence of a study: its parts, reasons, references, notes and recommendation in words.

use super::finding::{ReferenceFinding, RestPair, StartShape};
use super::part::{PartKind, SkipReason, StudyPart};
use super::plan::RunSetting;
use super::recommendation::{Recommendation, StudyNote};
use super::report::{SkippedPart, StudyRun};

/// Returns the length of mesh edges in words.
pub(super) fn edges(edge_length_m: f64) -> String {
    format!("{} mm edges", (1e6 * edge_length_m).round() * 1e-3)
}

/// Returns the name of a part.
pub(super) fn part(part: &StudyPart) -> String {
    let edges = edges(part.edge_length_m);
    match part.kind {
        PartKind::Run(method, by) => format!("{} with {}, {edges}", method.name(), setting(by)),
        PartKind::ReferenceDrape(method, by) => {
            let run = self::part(&with_kind(part, PartKind::Run(method, by)));
            format!("for the reference: {run}")
        }
        PartKind::Continuation(method, by) => {
            let run = self::part(&with_kind(part, PartKind::Run(method, by)));
            format!("where {run} leads to")
        }
        PartKind::Start => format!("sewing the start, {edges}"),
        PartKind::Motions => format!("motions, {edges}"),
        PartKind::LongestStep(method) => format!("the longest step of {}", method.name()),
        PartKind::ReferenceMotion(method, step_s) => {
            let (name, by) = (method.name(), RunSetting::Step(step_s));
            format!("reference: {name} in {}, {edges}", setting(by))
        }
        PartKind::Errors => format!("errors, {edges}"),
        PartKind::RestShape => format!("a rest shape for the stability limits, {edges}"),
        PartKind::StabilityLimit(method) => {
            format!("stability limit of {}, {edges}", method.name())
        }
    }
}

fn with_kind(part: &StudyPart, kind: PartKind) -> StudyPart {
    StudyPart { kind, ..*part }
}

fn setting(setting: RunSetting) -> String {
    match setting {
        RunSetting::Step(step_s) => format!("steps of {step_s:.2e} s"),
        RunSetting::Tolerance(tolerance) => format!("tolerance {tolerance:.0e}"),
    }
}

/// Returns a part that was not done, as a study lists it.
pub(super) fn skipped(part: &StudyPart, reason: &SkipReason) -> SkippedPart {
    let because = match reason {
        SkipReason::Canceled => "canceled before it",
        SkipReason::TimeUp => "the time allowed was up",
        SkipReason::LargerToleranceTooSlow => {
            "a larger tolerance took all the time that one run may take"
        }
        SkipReason::NotAtRest => "its shape did not come to rest from there",
        SkipReason::SeamsOpen(why) => &format!("the seams could not be closed: {why}"),
        SkipReason::NoReference => NO_REFERENCE,
        SkipReason::NothingToDisturb => "there is no shape at rest to disturb",
    };
    SkippedPart {
        what: self::part(part),
        because: because.to_owned(),
    }
}

const NO_REFERENCE: &str = "no reference motion was finished in the time allowed";

/// Returns the shape that runs begin with in words.
pub(super) fn start(start: StartShape) -> &'static str {
    match start {
        StartShape::Placed => "the panels where they were put",
        StartShape::DrapedInStillAir => "the garment draped in still air; then the wind blows",
        StartShape::SewnWithoutWeight => "the garment sewn without weight; then it falls",
    }
}

/// Returns why a motion ended, and that some of its steps were too long to be stable.
pub(super) fn ended_with_unstable_steps(why: &str) -> String {
    format!("{why}; some steps were above the stability limit of that moment")
}

/// Returns how a reference was found and confirmed, or why not. Errors from `certain` times its
/// uncertainty on are certain.
pub(super) fn reference(finding: &ReferenceFinding, certain: f64) -> String {
    match finding {
        ReferenceFinding::NoneAtRest => "no method came to rest in the time allowed".to_owned(),
        ReferenceFinding::OneAtRest(method) => format!(
            "only {} came to rest in the time allowed: not confirmed",
            method.name()
        ),
        ReferenceFinding::TooManyRestShapes => {
            "there are too many rest shapes to compare them all".to_owned()
        }
        ReferenceFinding::SameRestShape(pair) => same_rest_shape(pair),
        ReferenceFinding::DifferentRestShapes {
            pair,
            apart_m,
            depends_on_path,
        } => different_rest_shapes(pair, *apart_m, *depends_on_path),
        ReferenceFinding::NoMotion => NO_REFERENCE.to_owned(),
        ReferenceFinding::OneMotion(method, step_s) => format!(
            "only {} was finished in the time allowed, down to steps of {step_s:.2e} s: not confirmed by a second method",
            method.name()
        ),
        ReferenceFinding::TwoMotions {
            methods: [first, second],
            apart_m,
        } => format!(
            "{} down to steps of {:.2e} s and {} down to {:.2e} s, each extrapolated, are {:.2e} mm apart; errors from {certain} times that on are certain",
            first.0.name(),
            first.1,
            second.0.name(),
            second.1,
            1e3 * apart_m
        ),
    }
}

fn same_rest_shape(pair: &RestPair) -> String {
    let ([first, second], [a, b]) = (pair.methods, pair.energies_j.map(|e| 1e3 * e));
    format!(
        "{} and {}, each taken on to the round-off floor, came to rest in the same shape, at {a:.6} and {b:.6} mJ",
        first.name(),
        second.name()
    )
}

fn different_rest_shapes(pair: &RestPair, apart_m: f64, depends_on_path: bool) -> String {
    let ([first, second], [a, b]) = (pair.methods, pair.energies_j.map(|e| 1e3 * e));
    let why = if depends_on_path {
        "with friction against the body, rest shapes depend on the way there"
    } else {
        "several rest shapes exist"
    };
    format!(
        "{why}: {} came to rest at {a:.6} mJ, {} {:.2} mm away at {b:.6} mJ",
        first.name(),
        second.name(),
        1e3 * apart_m
    )
}

/// Returns the name of the requested method, and which one `auto` chose.
pub(super) fn method_name(run: &StudyRun) -> String {
    let requested = run.method.name().to_owned();
    if requested == run.used || run.used.is_empty() {
        requested
    } else {
        format!("{requested}: {}", run.used)
    }
}

/// Returns the setting that was varied in a run.
pub(super) fn run_setting(run: &StudyRun) -> String {
    match (run.step_s, run.tolerance) {
        (Some(step_s), _) => setting(RunSetting::Step(step_s)),
        (None, Some(tolerance)) => setting(RunSetting::Tolerance(tolerance)),
        (None, None) => "its own setting".to_owned(),
    }
}

/// Returns a run in a line.
pub(super) fn run_summary(run: &StudyRun) -> String {
    let error = run.error_m.map_or_else(
        || "no error known".to_owned(),
        |error| format!("error {:.2e} mm", 1e3 * error),
    );
    let ended = if run.converged {
        String::new()
    } else {
        format!("; {}", run.why)
    };
    format!(
        "{}, {}, {}: {:.3} s, {error}{ended}",
        method_name(run),
        run_setting(run),
        edges(run.edge_length_m),
        run.cpu_s,
    )
}

/// Returns the recommendation in a sentence.
pub(super) fn recommendation(found: Option<&Recommendation<'_>>) -> String {
    let Some(Recommendation {
        error_m,
        best,
        next,
    }) = found
    else {
        return "Nothing can be recommended: no run reached what was asked with an error that is known; allow more time."
            .to_owned();
    };
    let advice = format!(
        "For errors below {} mm on {} take {} with {}: {:.2} s",
        plain(1e3 * error_m),
        edges(best.edge_length_m),
        method_name(best),
        run_setting(best),
        best.cpu_s
    );
    match next {
        Some(next) if best.cpu_s > 0.0 => format!(
            "{advice}; the next best, {} with {}, needs {} times as long.",
            method_name(next),
            run_setting(next),
            plain(two_digits(next.cpu_s / best.cpu_s))
        ),
        _ => format!("{advice}; no other method came so near."),
    }
}

/// Returns a note in a sentence.
pub(super) fn note(note: &StudyNote) -> String {
    let text = match note {
        StudyNote::FrictionOfDrapes => {
            "There is friction against the body: rest shapes depend on the way there, so methods and meshes come to rest in different ones and none is the right one; an error is the distance to where friction lets the run itself go."
        }
        StudyNote::FrictionOfMotions => {
            "There is friction against the body: forces are not smooth, and observed orders may fall short of theory."
        }
        StudyNote::WindOfMotions => {
            "There is wind, which is taken from the velocity of the step before: every method is of order 1 in it."
        }
        StudyNote::SeveralRestShapes => {
            "Several rest shapes exist, as cloth wrinkles one way or another: an error is the distance to the rest shape that the run itself leads to, not between them; compare their energies."
        }
        StudyNote::MeshErrorsOfSeveralShapes => {
            "Mesh errors hold differences between rest shapes too."
        }
        StudyNote::UncertainErrors => {
            "Errors that are not certain are upper bounds: they are as small as what they are measured by."
        }
        StudyNote::MeshError {
            edge_length_m,
            error_m,
        } => {
            return format!(
                "Between {} and the finest mesh the reference moves by {:.2} mm: a solver error far below that is not worth its time.",
                edges(*edge_length_m),
                1e3 * error_m
            );
        }
    };
    text.to_owned()
}

/// Rounds a ratio to two digits.
fn two_digits(ratio: f64) -> f64 {
    if ratio < 10.0 {
        (10.0 * ratio).round() / 10.0
    } else {
        let power = 10f64.powf(ratio.log10().floor() - 1.0);
        (ratio / power).round() * power
    }
}

/// Returns a number without trailing zeros, or with an exponent if it is very small or large.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_round() {
        assert_eq!(plain(1e3 * 1e-4), "0.1");
        assert_eq!(plain(1e3 * 2e-3), "2");
        assert_eq!(plain(two_digits(31.4159)), "31");
        assert_eq!(plain(two_digits(1.27)), "1.3");
        assert_eq!(plain(2e-9), "2e-9");
    }
}
