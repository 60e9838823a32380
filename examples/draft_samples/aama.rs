//! A style as DXF after ANSI/AAMA-292: R12, a block a piece, its outline in open runs, millimetres.

use super::curve::Point;
use super::piece::{Piece, Style};
use std::fmt::Write;

const SIZE: &str = "M";
/// Height of texts \[mm\].
const TEXT_HEIGHT: f64 = 6.0;
/// Depth of notches \[mm\].
const NOTCH_DEPTH: f64 = 4.0;

/// Layers of ANSI/AAMA-292.
mod layer {
    pub(super) const BOUNDARY: u32 = 1;
    pub(super) const TURN_POINTS: u32 = 2;
    pub(super) const CURVE_POINTS: u32 = 3;
    pub(super) const NOTCHES: u32 = 4;
    pub(super) const GRAIN: u32 = 7;
}

/// Bytes of the file, lines ending in CR LF.
pub(crate) fn write(style: &Style) -> String {
    let mut file = Tags::default();
    file.section("HEADER", |file| {
        file.text(9, "$ACADVER").text(1, "AC1009");
    });
    file.section("BLOCKS", |file| {
        for piece in &style.pieces {
            block(file, piece);
        }
    });
    file.section("ENTITIES", |file| entities(file, style));
    file.text(0, "EOF");
    file.0
}

fn block(file: &mut Tags, piece: &Piece) {
    file.text(0, "BLOCK")
        .text(8, "0")
        .text(2, &block_name(piece));
    file.text(70, "64").number(10, 0.0).number(20, 0.0);
    let [x, y] = piece.grain[0];
    let lines = [
        format!("Piece Name: {}", piece.name),
        format!("Size: {SIZE}"),
        "Quantity: 1".to_owned(),
        "Annotation: SEW LINE, NO SEAM ALLOWANCE".to_owned(),
    ];
    let mut at = [piece.origin[0] + x + TEXT_HEIGHT, piece.origin[1] + y];
    for line in lines {
        file.label(&line, at);
        at[1] += 1.5 * TEXT_HEIGHT;
    }
    for run in &piece.runs {
        outline_run(file, run, piece.origin);
    }
    for notch in &piece.notches {
        file.point(layer::NOTCHES, *notch, piece.origin);
        file.number(30, NOTCH_DEPTH).number(39, 0.0);
    }
    let [from, to] = piece.grain;
    file.text(0, "LINE").layer(layer::GRAIN);
    file.place(10, from, piece.origin)
        .place(11, to, piece.origin);
    file.text(0, "ENDBLK").text(8, "0");
}

fn block_name(piece: &Piece) -> String {
    format!("{}_{SIZE}", piece.name)
}

fn outline_run(file: &mut Tags, run: &[Point], origin: Point) {
    file.text(0, "POLYLINE").layer(layer::BOUNDARY);
    file.text(66, "1").text(70, "0");
    for point in run {
        file.text(0, "VERTEX").layer(layer::BOUNDARY);
        file.place(10, *point, origin);
    }
    file.text(0, "SEQEND").layer(layer::BOUNDARY);
    for (i, point) in run.iter().enumerate() {
        let end = i == 0 || i + 1 == run.len();
        let layer = if end {
            layer::TURN_POINTS
        } else {
            layer::CURVE_POINTS
        };
        file.point(layer, *point, origin);
    }
}

fn entities(file: &mut Tags, style: &Style) {
    let lines = [
        format!("Style Name: {}", style.name),
        "Author: SEAMSTER DRAFT_SAMPLES".to_owned(),
        format!("Sample Size: {SIZE}"),
        "Grading Rule Table: NONE".to_owned(),
        "Units: METRIC".to_owned(),
    ];
    let mut at = [0.0, 0.0];
    for line in lines {
        file.label(&line, at);
        at[1] += 1.5 * TEXT_HEIGHT;
    }
    for piece in &style.pieces {
        file.text(0, "INSERT").layer(layer::BOUNDARY);
        file.text(2, &block_name(piece))
            .number(10, 0.0)
            .number(20, 0.0);
    }
}

/// A DXF file as it grows.
#[derive(Default)]
struct Tags(String);

impl Tags {
    fn text(&mut self, code: u32, value: &str) -> &mut Self {
        write!(self.0, "{code:>3}\r\n{value}\r\n").expect("a String takes all");
        self
    }

    fn number(&mut self, code: u32, value: f64) -> &mut Self {
        // Adding 0 makes -0 plain.
        let value = (value * 1e4).round() / 1e4 + 0.0;
        self.text(code, &format!("{value:.4}"))
    }

    fn layer(&mut self, layer: u32) -> &mut Self {
        self.text(8, &layer.to_string())
    }

    /// Coordinates, x under `code` and y under `code + 10`.
    fn place(&mut self, code: u32, point: Point, origin: Point) -> &mut Self {
        self.number(code, origin[0] + point[0]);
        self.number(code + 10, origin[1] + point[1])
    }

    fn point(&mut self, layer: u32, point: Point, origin: Point) {
        self.text(0, "POINT").layer(layer).place(10, point, origin);
    }

    fn label(&mut self, line: &str, at: Point) {
        self.text(0, "TEXT")
            .layer(layer::BOUNDARY)
            .place(10, at, [0.0, 0.0]);
        self.number(40, TEXT_HEIGHT).number(50, 0.0);
        self.text(1, line).text(7, "STANDARD");
    }

    fn section(&mut self, name: &str, body: impl FnOnce(&mut Self)) {
        self.text(0, "SECTION").text(2, name);
        body(self);
        self.text(0, "ENDSEC");
    }
}
