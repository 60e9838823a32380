//! Sheets to pieces, and pieces to panels: lines joined and nested, each line and mark given to its
//! piece, corners and notches found, half pieces unfolded.

mod allowance_width;
mod assign;
mod chain;
pub(super) mod classify;
mod corners;
pub(super) mod drawn_darts;
pub(super) mod drawn_notches;
pub(super) mod dxf_piece;
mod end_pairs;
mod fold;
mod folds;
mod frame;
mod free_ends;
mod gap;
pub(super) mod grade;
mod holes;
mod inner_outlines;
mod join;
mod lines;
mod loops;
mod marks;
mod measured;
mod nest;
mod nest_gather;
mod nest_split;
mod notch;
mod open_sew_lines;
pub(super) mod panel;
mod rings;
pub(super) mod select;
mod shallow_corners;
mod shared_edges;
mod simplify;
mod size_nest;
pub(super) mod size_plan;
