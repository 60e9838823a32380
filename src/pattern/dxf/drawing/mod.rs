//! Entities to sheets in meters: blocks put in place, units, and the meaning of layers, labels and
//! sizes.

mod block_index;
pub(super) mod blocks;
pub(super) mod contents;
pub(super) mod dialect;
pub(super) mod labels;
pub(super) mod layers;
mod placed_sheet;
pub(super) mod quantity;
pub(super) mod sheet;
pub(super) mod size_names;
pub(super) mod sizes;
pub(super) mod units;
