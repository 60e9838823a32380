//! Tests of `seam`: seams checked and suggested.

mod check;
mod drafts;
mod likely_reversed;
mod notches;
mod suggest;
mod tracks;
mod truth;
