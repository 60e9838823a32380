//! Seam suggestion: rules of each class of garment, applied to the panels of a pattern (P13).
//!
//! 1. `classify` labels every panel: `names` takes hints from its name by the `lexicon`,
//!    `outline_features` measures its outline, `align` divides that into the edge roles of the
//!    `edge_templates` (hem, side, armhole), `penalties` count what speaks against a labeling, and
//!    `assignment` chooses the labelings of all panels together; `orientation` tells front from
//!    back and left from right.
//! 2. `rules` join the edge roles that each class of garment joins, a file a class; `join` splits a
//!    seam where corners of both sides meet.
//! 3. `select` keeps the seams that can be sewn together, `placement` puts the panels round the
//!    body, `completeness` tells what the set leaves out, `cohesion` what would fall off it, and
//!    `trust` lowers the confidence by both.
//!
//! `reading` is one pass through these steps; `hypotheses` tries others where panels that no name
//! tells of are left over. `lexicon.json` and `figures.json` hold the words and the numbers.

mod align;
mod assignment;
mod bands;
mod classify;
mod cohesion;
mod completeness;
mod cut_edges;
mod cut_twice;
mod darts;
mod edge_chain;
mod edge_features;
mod edge_templates;
mod evidence;
mod figures;
mod garment_model;
mod grown_codes;
mod hole_dart;
mod hypotheses;
mod join;
mod labeled_panel;
mod labels;
mod lexicon;
mod loose;
mod missing_corners;
mod names;
mod orientation;
mod outline_features;
mod penalties;
mod placement;
mod reading;
mod ring_panel;
mod rules;
mod seam_pairs;
mod select;
mod side_panels;
mod strays;
mod suggestion;
mod trust;
mod vents;
mod vocabulary;
mod words;

pub use suggestion::{MIN_SEWN_CONFIDENCE, SuggestedPanel, SuggestedSeam, Suggestion};

use crate::config::Limits;
use crate::fault::{SeamCode, Warning};
use crate::pattern::Pattern;
use reading::Reading;
use seam_pairs::SeamPairWriter;
use std::collections::BTreeSet;

/// Proposes seams and placements for `pattern` from the names, outlines and notches of its panels.
///
/// What the pattern itself states (`seams`, `placements`) is not used. Seams are by corner numbers,
/// one for each stretch between corners that meet. Every seam passes [`check`](crate::seam::check)
/// together with all others.
///
/// # Assumptions
/// Panels are those of one garment; of parts that are drawn in several styles (short and long
/// sleeve) the first is taken. Lengths are those of the sew line. Sleeves, cuffs and bindings that
/// are drawn once are worn on both sides.
pub fn suggest(pattern: &Pattern, limits: &Limits) -> Suggestion {
    if pattern.panels.len() > limits.suggested_panels {
        return too_many(pattern.panels.len(), limits.suggested_panels);
    }
    let Reading {
        garment,
        seams,
        completeness,
        ..
    } = hypotheses::best_reading(pattern, limits);
    let writer = SeamPairWriter(pattern);
    let sewn: BTreeSet<&str> = seams.iter().flat_map(SuggestedSeam::panels).collect();
    let stands = placement::placements(&garment)
        .into_iter()
        .map(|(panel, placement)| (writer.panel_id(panel), SuggestedPanel { placement }));
    let is_worn = |id: &str| sewn.contains(id) || completeness.is_worn_alone();
    let panels = stands.filter(|(id, _)| is_worn(id)).collect();
    let warnings = completeness.warnings(pattern);
    Suggestion {
        seams,
        panels,
        warnings,
    }
}

fn too_many(count: usize, most: usize) -> Suggestion {
    let detail = format!(
        "the pattern has {count} panels; seams are suggested for one garment of at most {most}"
    );
    Suggestion {
        warnings: vec![Warning::new(SeamCode::NotSuggested, "/seams", detail)],
        ..Suggestion::default()
    }
}
