//! The style of lines and figures. Dark on a sheet of their own color, so that they can be read on
//! any page.

use super::markup::{number, path};
use crate::export::xml::escape;
use crate::pattern::point::Point2;

/// Color of the sheet.
pub(super) const SHEET: &str = "#f7f5ef";
/// Color of cloth.
pub(super) const CLOTH: &str = "#ffffff";
/// Color of outlines, corners and names.
pub(super) const DARK: &str = "#24313a";
/// Color of secondary text.
pub(super) const SOFT: &str = "#66717a";
/// Color of edge numbers.
pub(super) const EDGE: &str = "#0a7355";
/// Color of cut lines.
pub(super) const CUT: &str = "#b0471f";
/// Color of fold lines.
pub(super) const FOLD: &str = "#1f62b0";
/// Color of lines drawn on the cloth, with their numbers.
pub(super) const INNER: &str = "#8a5a9c";

/// The style of a line: its color, its width and dashes in figures.
pub(super) struct StrokeStyle {
    pub(super) color: &'static str,
    pub(super) width: f64,
    pub(super) dashes: &'static [f64],
}

pub(super) const OUTLINE: StrokeStyle = stroke(DARK, 0.15, &[]);
pub(super) const CUT_LINE: StrokeStyle = stroke(CUT, 0.1, &[0.6, 0.4]);
pub(super) const FOLD_LINE: StrokeStyle = stroke(FOLD, 0.1, &[1.4, 0.4, 0.2, 0.4]);
pub(super) const INNER_LINE: StrokeStyle = stroke(INNER, 0.09, &[]);
pub(super) const GRAIN_LINE: StrokeStyle = stroke(SOFT, 0.1, &[]);
pub(super) const MARK: StrokeStyle = stroke(DARK, 0.12, &[]);

const fn stroke(color: &'static str, width: f64, dashes: &'static [f64]) -> StrokeStyle {
    StrokeStyle {
        color,
        width,
        dashes,
    }
}

impl StrokeStyle {
    /// Returns the attributes of the line; `figure` is the size of figures \[mm\].
    pub(super) fn attributes(&self, figure: f64) -> String {
        let mut out = format!(
            " stroke=\"{}\" stroke-width=\"{}\"",
            self.color,
            number(self.width * figure)
        );
        if !self.dashes.is_empty() {
            let dashes: Vec<String> = self.dashes.iter().map(|d| number(d * figure)).collect();
            out += &format!(" stroke-dasharray=\"{}\"", dashes.join(" "));
        }
        out
    }

    /// Draws the line along these points, not filled.
    pub(super) fn line(&self, points: &[Point2], closed: bool, figure: f64) -> String {
        self.path(&path(points, closed), figure)
    }

    /// Draws the line along this path, not filled.
    pub(super) fn path(&self, data: &str, figure: f64) -> String {
        let attributes = self.attributes(figure);
        format!("<path d=\"{data}\" fill=\"none\"{attributes}/>\n")
    }
}

/// A text centered at a place, with a rim that parts it from the lines below it.
pub(super) struct SvgText<'a> {
    pub(super) text: &'a str,
    pub(super) at: Point2,
    /// Its size \[mm\].
    pub(super) size: f64,
    pub(super) color: &'static str,
    pub(super) bold: bool,
    pub(super) rim: &'static str,
}

impl SvgText<'_> {
    /// Draws the text.
    pub(super) fn draw(&self, anchor: &str) -> String {
        // The middle of figures lies about a third of their size above their line.
        let [x, y] = [self.at[0], self.at[1] + 0.35 * self.size];
        let weight = if self.bold {
            " font-weight=\"600\""
        } else {
            ""
        };
        format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"{}\"{weight} stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\">{}</text>\n",
            number(x),
            number(y),
            number(self.size),
            self.color,
            self.rim,
            number(0.3 * self.size),
            escape(self.text)
        )
    }
}

/// Estimates the width of a text, in its size.
pub(super) fn width(text: &str) -> f64 {
    // Han and kana fill a square, capitals three quarters of one, small letters a bit more than
    // half.
    let wide = |c: char| match c {
        c if u32::from(c) >= 0x2e80 => 1.0,
        c if c.is_uppercase() => 0.76,
        _ => 0.62,
    };
    text.chars().map(wide).sum()
}
