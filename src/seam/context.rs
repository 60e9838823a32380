//! Everything that a check knows about the requested seams before it colors faces.

use super::faces::SeamRelations;
use super::{RoutedSeam, StartPositions};
use crate::pattern::{Pattern, SeamPair};

/// Requested pairs with their routed runs, the face relations they imply, and start positions.
pub(super) struct SeamCheckContext<'a> {
    pub pattern: &'a Pattern,
    pub pairs: &'a [SeamPair],
    pub seams: &'a [RoutedSeam],
    pub relations: &'a [SeamRelations<'a>],
    pub starts: StartPositions<'a>,
}
