//! A pattern as DXF after ANSI/AAMA-292: R12, a block a piece, millimeters.
//!
//! The layers are 1 (cut line), 14 (sew line), 2 and 3 (turn and curve points), 4 and 80 to 83
//! (notches by shape), 6 (fold), 7 (grain), 8 (lines on the cloth), 11 (cut-outs) and 13 (drill
//! holes). Coordinates are those of the panels, to 1e-10 m. The importer of this service reads the
//! same panels from it if it is within `config::Limits`: corners are the turn points, and the
//! number of mirrored copies is the second figure of `Quantity`. What the format has no place for
//! stands in comments (group 999) at the beginning. The same pattern gives the same bytes: there is
//! no date in it.
//!
//! The tags are written here and not by the `dxf` crate: that one writes the time of day into the
//! header, and into R12 the subclass markers that R12 does not have.

mod drawn_piece;
mod fold;
mod head;
mod left_out;
mod parts;
mod piece;
mod tags;

use self::drawn_piece::DrawnPiece;
use self::tags::TagWriter;
use super::pattern_file::PatternFile;
use crate::pattern::{Panel, Pattern};

/// Writes a pattern as AAMA DXF: all panels but mirrored copies, in their order.
///
/// Panels that were unfolded are drawn as halves on the fold, where they are their own mirror
/// images with all that is on them; else whole.
pub fn pattern_dxf(pattern: &Pattern) -> PatternFile {
    let panels: Vec<&Panel> = pattern
        .panels
        .iter()
        .filter(|panel| panel.copy_of.is_none())
        .collect();
    let pieces: Vec<DrawnPiece> = panels
        .iter()
        .map(|panel| DrawnPiece::of(panel, pattern.source.allowance))
        .collect();
    let mut left_out = left_out::sentences(pattern, &panels, &pieces);
    let names = head::block_names(&panels);
    let with_curve_points =
        pieces.iter().map(DrawnPiece::point_count).sum::<usize>() <= piece::MOST_CURVE_POINTS;
    let mut file = TagWriter::default();
    head::header(&mut file);
    head::tables(&mut file);
    file.section("BLOCKS", |file| {
        for ((panel, drawn), name) in panels.iter().zip(&pieces).zip(&names) {
            let labels = piece::labels(panel, pattern);
            piece::block(file, name, &labels, (drawn, with_curve_points));
        }
    });
    file.section("ENTITIES", |file| {
        head::style_labels(file, pattern);
        head::inserts(file, &names, &pieces);
    });
    file.text(0, "EOF");
    let text = file.into_text();
    left_out.extend(left_out::too_large(text.len()));
    let mut comments = TagWriter::default();
    for sentence in &left_out {
        comments.text(999, &format!("Not in this file: {sentence}"));
    }
    PatternFile {
        text: comments.into_text() + &text,
        left_out,
    }
}
