//! Sheets to pieces, and pieces to panels: lines joined and nested, each line and mark given to its
//! piece, corners and notches found, half pieces unfolded.

mod assign;
mod chain;
pub(super) mod classify;
pub(super) mod closed_gaps;
mod corners;
pub(super) mod dxf_piece;
mod end_pairs;
mod fold;
mod free_ends;
mod gap;
mod holes;
mod join;
mod lines;
mod marks;
mod measured;
mod nest;
mod notch;
pub(super) mod panel;
mod rings;
pub(super) mod select;
mod shallow_corners;
