//! Everything that a check knows about the requested seams before it colors faces.

use super::faces::SeamRelations;
use super::{RoutedSeam, StartPositions};
use crate::pattern::{Pattern, SeamPair};

/// Pairs as asked with the runs found for them, what they say, and where panels start.
pub(super) struct SeamCheckContext<'a> {
    pub pattern: &'a Pattern,
    pub pairs: &'a [SeamPair],
    pub seams: &'a [RoutedSeam],
    pub relations: &'a [SeamRelations<'a>],
    pub starts: StartPositions<'a>,
}
