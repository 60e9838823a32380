//! Everything that a check knows about the requested seams before it colors faces.

use super::faces::{self, FaceColoring, SeamRelations};
use super::parity::ParityUnionFind;
use super::{Face, RoutedSeam, StartPositions};
use crate::pattern::{Pattern, SeamPair};

/// Requested pairs with their routed runs, the face relations they imply, and start positions.
pub(super) struct SeamCheckContext<'a> {
    pub pattern: &'a Pattern,
    pub pairs: &'a [SeamPair],
    pub seams: &'a [RoutedSeam],
    pub relations: &'a [SeamRelations<'a>],
    pub starts: StartPositions<'a>,
}

impl SeamCheckContext<'_> {
    /// Returns the union-find of stated faces and of all seams in the order of a coloring, but for
    /// the one at position `but` of the request.
    pub(super) fn parity(
        &self,
        stated: &[Option<Face>],
        coloring: &FaceColoring,
        but: Option<usize>,
    ) -> ParityUnionFind {
        let mut parity = ParityUnionFind::new(stated.len() + 1);
        for relation in faces::stated_relations(stated) {
            parity.join(relation);
        }
        for implied in self.relations.iter().filter(|s| Some(s.seam) != but) {
            parity.join_all(implied.relations(coloring));
        }
        parity
    }
}
