//! Tests of `seam`: seams checked and suggested.

mod check;
mod drafts;
mod drawn;
mod likely_reversed;
mod notches;
mod outside;
mod pleats;
mod suggest;
mod suggest_details;
mod suggest_kinds;
mod suggest_legs;
mod suggest_rings;
mod suggest_unnamed;
mod suggest_unseen;
mod tracks;
mod truth;
