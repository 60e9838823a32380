//! The blocks of a drawing by their names, and the wrappers among them: blocks that only put others
//! together, as a style its pieces.

use super::contents::DxfBlock;
use super::layers::{LayerRole, role};
use crate::pattern::dxf::entity::geometry::EntityShape;
use std::collections::BTreeMap;

/// How much a line is an outline by its layer: the strongest of a drawing's are its pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum OutlineRank {
    /// A layer without a meaning of its own.
    General,
    /// A layer of sew lines.
    Sew,
    /// The layer of outlines.
    Boundary,
}

/// The blocks of a drawing, found by name.
pub(super) struct BlockIndex<'a> {
    blocks: &'a [DxfBlock],
    /// Indices of the blocks with a name (lower case), in the order of the file.
    by_name: BTreeMap<String, Vec<usize>>,
    /// Block by block, the strongest line in it or in those that it inserts.
    ranks: Vec<Option<OutlineRank>>,
    /// Block by block, the rank of the pieces that it puts together.
    wrapped: Vec<Option<OutlineRank>>,
}

/// A block that another inserts.
struct InnerBlock {
    index: usize,
    /// Number of copies.
    count: usize,
}

impl<'a> BlockIndex<'a> {
    /// Indexes blocks. Lines are looked for `depth` blocks deep.
    pub(super) fn new(blocks: &'a [DxfBlock], depth: usize) -> Self {
        let mut by_name: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (i, block) in blocks.iter().enumerate() {
            let name = block.name.to_lowercase();
            by_name.entry(name).or_default().push(i);
        }
        let mut index = Self {
            blocks,
            by_name,
            ranks: blocks.iter().map(own_rank).collect(),
            wrapped: Vec::new(),
        };
        let inner: Vec<_> = blocks.iter().map(|b| index.inner_blocks(b)).collect();
        index.pass_ranks_up(&inner, depth);
        let blocks = blocks.iter().zip(&inner);
        index.wrapped = blocks
            .map(|(b, inner)| index.wrapped_by(b, inner))
            .collect();
        index
    }

    /// Returns the blocks that a block inserts.
    fn inner_blocks(&self, block: &DxfBlock) -> Vec<InnerBlock> {
        let inserts = block.entities.iter().filter_map(|e| match &e.shape {
            EntityShape::Insert(insert) => Some(insert),
            _ => None,
        });
        let inner = inserts.filter_map(|insert| {
            Some(InnerBlock {
                index: self.find(&insert.name, 0)?,
                count: insert.cell_count(),
            })
        });
        inner.collect()
    }

    /// Raises the rank of each block to those of the blocks that it inserts, `depth` times.
    fn pass_ranks_up(&mut self, inner: &[Vec<InnerBlock>], depth: usize) {
        for _ in 0..depth {
            let highest =
                |inner: &Vec<InnerBlock>| inner.iter().filter_map(|i| self.ranks[i.index]).max();
            let raised = self.ranks.iter().zip(inner);
            let raised: Vec<_> = raised
                .map(|(own, inner)| (*own).max(highest(inner)))
                .collect();
            if raised == self.ranks {
                return;
            }
            self.ranks = raised;
        }
    }

    /// Returns the rank of the pieces that a block puts together, if it is a wrapper.
    fn wrapped_by(&self, block: &DxfBlock, inner: &[InnerBlock]) -> Option<OutlineRank> {
        let rank = inner.iter().filter_map(|i| self.ranks[i.index]).max()?;
        if own_rank(block) >= Some(rank) {
            return None;
        }
        let pieces = inner.iter().filter(|i| self.ranks[i.index] == Some(rank));
        let count = pieces.fold(0, |sum: usize, i| sum.saturating_add(i.count));
        let is_other = |shape: &EntityShape| !matches!(shape, EntityShape::Text(..));
        let others = block.entities.iter().filter(|e| is_other(&e.shape)).count();
        (count > 1 || others == 1).then_some(rank)
    }

    /// Returns the `nth` block of a name, or the last.
    pub(super) fn find(&self, name: &str, nth: usize) -> Option<usize> {
        let same = self.by_name.get(&name.to_lowercase())?;
        same.get(nth).or(same.last()).copied()
    }

    /// Returns the strongest line in a block or in those that it inserts.
    pub(super) fn rank(&self, index: usize) -> Option<OutlineRank> {
        self.ranks[index]
    }

    /// Returns the rank of the pieces that a wrapper puts together; `None` for another block.
    ///
    /// A wrapper inserts blocks with stronger lines than its own: several, or only one and no line,
    /// mark or other block besides. A block of one piece, its lines and marks is that piece.
    pub(super) fn wrapped_rank(&self, index: usize) -> Option<OutlineRank> {
        self.wrapped[index]
    }

    /// Returns the wrappers, in the order of the file.
    pub(super) fn wrappers(&self) -> impl Iterator<Item = &'a DxfBlock> {
        let blocks = self.blocks.iter().zip(&self.wrapped);
        blocks
            .filter(|(_, wrapped)| wrapped.is_some())
            .map(|(block, _)| block)
    }
}

/// Returns the strongest of a block's own lines.
fn own_rank(block: &DxfBlock) -> Option<OutlineRank> {
    let lines = block.entities.iter().filter(|e| e.shape.path().is_some());
    lines.filter_map(|e| rank_of(role(&e.layer))).max()
}

fn rank_of(role: LayerRole) -> Option<OutlineRank> {
    match role {
        LayerRole::Boundary => Some(OutlineRank::Boundary),
        LayerRole::Sew => Some(OutlineRank::Sew),
        LayerRole::General => Some(OutlineRank::General),
        _ => None,
    }
}
