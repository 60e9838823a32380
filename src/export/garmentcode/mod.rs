//! A pattern as a `GarmentCode` specification.
//!
//! Source of the format: as for its import. Loops run counter-clockwise where the drawn side of a
//! panel is out, clockwise where it is in. Edges that came from a specification are written as the
//! curves that they were; others as one curve near their lines, or in parts. The file says
//! nothing of what it leaves out: the format has no place for comments.

mod arc;
mod bezier;
mod curve;
mod fit;
mod left_out;
mod numbers;
mod panel;
mod placement;
mod stitch;

use self::fit::Fitter;
use self::left_out::LeftOut;
use self::numbers::neat;
use self::panel::DrawnPanel;
use super::pattern_file::PatternFile;
use crate::pattern::{Panel, Pattern, PatternFormat};
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;

/// Writes a pattern as a `GarmentCode` specification: all panels in their order, mirrored copies as
/// panels of their own, stitches and placements where the pattern has them.
pub fn pattern_specification(pattern: &Pattern) -> PatternFile {
    let scale = scale(pattern);
    let names = names(pattern);
    let edges = pattern.panels.iter().flat_map(|panel| &panel.edges);
    let mut fitter = Fitter::of(edges.map(|edge| edge.points.len()).sum());
    let draw = |panel| DrawnPanel::of(panel, &mut fitter);
    let drawn: Vec<DrawnPanel> = pattern.panels.iter().map(draw).collect();
    let mut left_out = LeftOut::of(pattern, &names, &drawn);
    left_out.is_sparing = fitter.is_sparing;
    let mut panels = Map::new();
    for ((panel, drawn), name) in pattern.panels.iter().zip(&drawn).zip(&names) {
        let mut written = Map::new();
        if let Some(placement) = pattern.placements.get(&panel.id) {
            match placement::written(panel, placement, scale) {
                Some(fields) => written.extend(fields),
                None => left_out.placements += 1,
            }
        }
        written.extend(drawn.written(panel, scale));
        panels.insert(name.clone(), Value::Object(written));
    }
    let mut stitches = Vec::new();
    for seam in &pattern.seams {
        match stitch::written(seam, pattern, (&drawn, &names)) {
            Some(stitch) => {
                left_out.add_stitch(seam, pattern, stitches.len());
                stitches.push(stitch);
            }
            None => left_out.seams += 1,
        }
    }
    let document = json!({
        "pattern": {"panels": panels, "stitches": stitches, "panel_order": names},
        "parameters": {},
        "parameter_order": [],
        "properties": {
            "curvature_coords": "relative",
            "normalize_panel_translation": false,
            "normalized_edge_loops": pattern.panels.iter().any(|panel| panel.face.is_some()),
            "units_in_meter": neat(1.0 / scale),
        },
    });
    PatternFile {
        text: format!("{document:#}\n"),
        left_out: left_out.sentences(),
    }
}

/// Returns the meters of a unit: that of a specification that the pattern came from, else one
/// centimeter.
fn scale(pattern: &Pattern) -> f64 {
    let source = &pattern.source;
    let is_usable = (1e-6..=1e3).contains(&source.scale_to_m);
    if source.format == PatternFormat::GarmentCode && is_usable {
        source.scale_to_m
    } else {
        0.01
    }
}

/// Returns the names of the panels in the file: their names, those of mirrored copies with
/// `_mirror`; their ids, if two of these are equal.
fn names(pattern: &Pattern) -> Vec<String> {
    let name = |panel: &Panel| {
        let suffix = if panel.copy_of.is_some() {
            "_mirror"
        } else {
            ""
        };
        format!("{}{suffix}", panel.name)
    };
    let names: Vec<String> = pattern.panels.iter().map(name).collect();
    let different: BTreeSet<&String> = names.iter().collect();
    let is_usable = different.len() == names.len() && names.iter().all(|name| !name.is_empty());
    if is_usable {
        return names;
    }
    pattern
        .panels
        .iter()
        .map(|panel| panel.id.clone())
        .collect()
}
