//! From seam pairs as requested to checked [`Seam`]s: which point meets which, and which face of
//! each panel is out.

mod check;
mod chords;
mod coloring;
mod context;
mod correction;
mod cycle;
mod direction;
mod ease;
mod face_conflicts;
mod faces;
mod finding;
mod input;
mod marks;
mod matching;
mod outside;
mod overlap;
mod parity;
mod path;
mod place;
mod pleats;
mod reversal;
mod routed_seam;
mod run_resolver;
mod seam_set;
mod seam_sides;
mod stretch;
pub mod suggest;
mod track;
mod twist;
mod twist_fault;
mod welds;

pub use crate::pattern::Face;
pub use check::{check, check_placed};
pub use finding::{SeamCheck, SeamFinding};
pub use input::{FaceRequest, SeamCheckInput, StartPositions};
pub use marks::{MatchedMarks, SeamMark};
pub use seam_set::{Seam, SeamSet, division_count};
pub use stretch::Stretch;
pub use track::Track;

use routed_seam::RoutedSeam;
