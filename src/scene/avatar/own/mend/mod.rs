//! From the triangles of a file to a closed surface that faces outward, with what was mended.

mod edges;
mod holes;
mod orient;
mod pieces;
mod slivers;
mod weld;

pub(super) use holes::close;
pub(super) use pieces::{largest_piece, main_pieces};
pub(super) use slivers::lift_slivers;
pub(super) use weld::weld;
