//! The parts that a study is done in, and the reasons to skip one.

use super::plan::RunSetting;
use crate::solver::Method;

/// A part of a study on one mesh: what is timed, shown as progress and listed if it is skipped.
#[derive(Clone, Copy, Debug)]
pub(super) struct StudyPart {
    pub(super) kind: PartKind,
    /// Length of mesh edges \[m\].
    pub(super) edge_length_m: f64,
}

/// The kinds of parts.
#[derive(Clone, Copy, Debug)]
pub(super) enum PartKind {
    /// A run of the work-precision table.
    Run(Method, RunSetting),
    /// A drape that was not asked for, to have something to compare with.
    ReferenceDrape(Method, RunSetting),
    /// Going on from a drape to the rest shape that it leads to.
    Continuation(Method, RunSetting),
    /// The shape that motions begin with.
    Start,
    /// All motions.
    Motions,
    /// The longest step that an explicit method is allowed.
    LongestStep(Method),
    /// A motion of the reference in steps of a length \[s\].
    ReferenceMotion(Method, f64),
    /// The errors of all motions.
    Errors,
    /// A rest shape for the stability limits.
    RestShape,
    /// The stability limit of a method.
    StabilityLimit(Method),
}

/// The reason why a part of a study was not done.
#[derive(Clone, Debug)]
pub(super) enum SkipReason {
    /// The study was canceled before it.
    Canceled,
    /// The time of the study was up.
    TimeUp,
    /// A larger tolerance took all the time that one run may take.
    LargerToleranceTooSlow,
    /// Its shape did not come to rest.
    NotAtRest,
    /// The seams could not be closed, and why.
    SeamsOpen(String),
    /// No motion of the reference was finished in time.
    NoReference,
    /// No shape at rest was found that could be disturbed.
    NothingToDisturb,
}
