//! Parts of the whole file: header, tables, the labels of the style, the inserted blocks.

use super::drawn_piece::DrawnPiece;
use super::piece::layer;
use super::tags::TagWriter;
use crate::pattern::point::Point2;
use crate::pattern::polyline::bounds;
use crate::pattern::{Panel, Pattern};
use std::collections::BTreeSet;

/// Distance between pieces in the model space \[m\].
const GAP: f64 = 0.05;

/// Characters of the name of a block: R12 reads 31, a number may follow.
const BLOCK_NAME: usize = 26;

/// Writes the header: the version.
pub(super) fn header(file: &mut TagWriter) {
    file.section("HEADER", |file| {
        file.text(9, "$ACADVER").text(1, "AC1009");
    });
}

/// Writes the tables: one line type, the layers, one text style.
pub(super) fn tables(file: &mut TagWriter) {
    file.section("TABLES", |file| {
        table(file, "LTYPE", 1);
        file.text(0, "LTYPE").text(2, "CONTINUOUS").number(70, 0.0);
        file.text(3, "Solid line").number(72, 65.0);
        file.number(73, 0.0).number(40, 0.0).text(0, "ENDTAB");
        table(file, "LAYER", layer::ALL.len());
        for number in layer::ALL {
            file.text(0, "LAYER").text(2, &number.to_string());
            file.number(70, 0.0).number(62, 7.0).text(6, "CONTINUOUS");
        }
        file.text(0, "ENDTAB");
        table(file, "STYLE", 1);
        file.text(0, "STYLE").text(2, "STANDARD").number(70, 0.0);
        file.number(40, 0.0).number(41, 1.0).number(50, 0.0);
        file.number(71, 0.0).number(42, 2.5).text(3, "txt");
        file.text(4, "").text(0, "ENDTAB");
    });
}

fn table(file: &mut TagWriter, name: &str, count: usize) {
    file.text(0, "TABLE").text(2, name).number(70, count as f64);
}

/// Writes the labels of the style.
pub(super) fn style_labels(file: &mut TagWriter, pattern: &Pattern) {
    let mut lines = vec![
        format!("Style Name: {}", pattern.name),
        "Author: SEAMSTER".to_owned(),
    ];
    if let Some(size) = &pattern.source.sample_size {
        lines.push(format!("Sample Size: {size}"));
    }
    lines.push("Grading Rule Table: NONE".to_owned());
    lines.push("Units: METRIC".to_owned());
    file.lines_of_text(&lines, [0.0, -GAP]);
}

/// Puts the blocks into the model space, side by side.
pub(super) fn inserts(file: &mut TagWriter, names: &[String], pieces: &[DrawnPiece]) {
    let mut x = 0.0;
    for (name, piece) in names.iter().zip(pieces) {
        let [low, high]: [Point2; 2] = bounds(&piece.boundary);
        let at = [x - low[0], -low[1]];
        x += high[0] - low[0] + GAP;
        file.entity("INSERT", layer::BOUNDARY).text(2, name);
        file.place(10, at);
    }
}

/// Returns a name for the block of each panel: capitals, digits, `_` and `-` of its name, as R12
/// allows them, with a number where two would be equal.
pub(super) fn block_names(panels: &[&Panel]) -> Vec<String> {
    let mut taken = BTreeSet::new();
    panels
        .iter()
        .map(|panel| {
            let base = block_name(&panel.name);
            let mut name = base.clone();
            let mut number = 2_usize;
            while !taken.insert(name.clone()) {
                name = format!("{base}_{number}");
                number += 1;
            }
            name
        })
        .collect()
}

fn block_name(name: &str) -> String {
    let allowed = |c: char| {
        if c.is_ascii_alphanumeric() || c == '-' {
            c
        } else {
            '_'
        }
    };
    let name: String = name.chars().take(BLOCK_NAME).map(allowed).collect();
    if name.contains(|c: char| c.is_ascii_alphanumeric()) {
        name.to_ascii_uppercase()
    } else {
        "PIECE".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_have_names_that_r12_allows_and_no_two_the_same() {
        let named = |name: &str| Panel {
            name: name.to_owned(),
            ..Panel::default()
        };
        let panels = [
            named("Front (left)"),
            named("front left "),
            named("前片"),
            named("后片"),
        ];
        let panels: Vec<&Panel> = panels.iter().collect();
        assert_eq!(
            block_names(&panels),
            ["FRONT__LEFT_", "FRONT_LEFT_", "PIECE", "PIECE_2"]
        );
    }
}
