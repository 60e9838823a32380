//! The dialect of a drawing, from its labels and layers.

use super::contents::DxfDrawing;
use super::labels::DxfLabels;
use crate::pattern::PatternFormat;

/// Returns ASTM where a label says so or ASTM's layers (80 and above) are used, AAMA where a block
/// has an entity on layer 1, else general DXF.
pub(crate) fn detect(drawing: &DxfDrawing, labels: &DxfLabels) -> PatternFormat {
    let layers = || {
        drawing
            .blocks
            .iter()
            .flat_map(|block| &block.entities)
            .filter_map(|entity| entity.layer.trim().parse::<u32>().ok())
    };
    if labels.has_key_with("astm") || layers().any(|number| number >= 80) {
        PatternFormat::DxfAstm
    } else if layers().any(|number| number == 1) {
        PatternFormat::DxfAama
    } else {
        PatternFormat::Dxf
    }
}
