//! Tests of `seam`: seams checked and suggested.

mod check;
mod drafts;
mod likely_reversed;
mod notches;
mod suggest;
mod suggest_kinds;
mod tracks;
mod truth;
