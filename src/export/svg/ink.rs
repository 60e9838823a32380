//! What lines and figures look like. Dark on a sheet of their own colour, so that they can be read on any page.

use super::write::{escaped, number, path};
use crate::pattern::point::Point2;

/// The sheet.
pub(super) const SHEET: &str = "#f7f5ef";
/// Cloth.
pub(super) const CLOTH: &str = "#ffffff";
/// Outlines, corners, names.
pub(super) const DARK: &str = "#24313a";
/// What is said beside.
pub(super) const SOFT: &str = "#66717a";
/// Edge numbers.
pub(super) const EDGE: &str = "#0a7355";
/// Cut lines.
pub(super) const CUT: &str = "#b0471f";
/// Fold lines.
pub(super) const FOLD: &str = "#1f62b0";
/// Lines drawn on the cloth, with their numbers.
pub(super) const INNER: &str = "#8a5a9c";

/// A line: its colour, its width and dashes in figures.
pub(super) struct Stroke {
    pub(super) colour: &'static str,
    pub(super) width: f64,
    pub(super) dashes: &'static [f64],
}

pub(super) const OUTLINE: Stroke = stroke(DARK, 0.15, &[]);
pub(super) const CUT_LINE: Stroke = stroke(CUT, 0.1, &[0.6, 0.4]);
pub(super) const FOLD_LINE: Stroke = stroke(FOLD, 0.1, &[1.4, 0.4, 0.2, 0.4]);
pub(super) const INNER_LINE: Stroke = stroke(INNER, 0.09, &[]);
pub(super) const GRAIN_LINE: Stroke = stroke(SOFT, 0.1, &[]);
pub(super) const MARK: Stroke = stroke(DARK, 0.12, &[]);

const fn stroke(colour: &'static str, width: f64, dashes: &'static [f64]) -> Stroke {
    Stroke {
        colour,
        width,
        dashes,
    }
}

impl Stroke {
    /// The attributes of the line; `figure` is the size of figures \[mm\].
    pub(super) fn attributes(&self, figure: f64) -> String {
        let mut out = format!(
            " stroke=\"{}\" stroke-width=\"{}\"",
            self.colour,
            number(self.width * figure)
        );
        if !self.dashes.is_empty() {
            let dashes: Vec<String> = self.dashes.iter().map(|d| number(d * figure)).collect();
            out += &format!(" stroke-dasharray=\"{}\"", dashes.join(" "));
        }
        out
    }

    /// The line along these points, not filled.
    pub(super) fn line(&self, points: &[Point2], closed: bool, figure: f64) -> String {
        self.path(&path(points, closed), figure)
    }

    /// The line along this path, not filled.
    pub(super) fn path(&self, data: &str, figure: f64) -> String {
        let attributes = self.attributes(figure);
        format!("<path d=\"{data}\" fill=\"none\"{attributes}/>\n")
    }
}

/// A text centred at a place, with a rim that parts it from the lines below it.
pub(super) struct Text<'a> {
    pub(super) text: &'a str,
    pub(super) at: Point2,
    /// Its size \[mm\].
    pub(super) size: f64,
    pub(super) colour: &'static str,
    pub(super) bold: bool,
    pub(super) rim: &'static str,
}

impl Text<'_> {
    /// The element.
    pub(super) fn drawn(&self, anchor: &str) -> String {
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
            self.colour,
            self.rim,
            number(0.3 * self.size),
            escaped(self.text)
        )
    }
}

/// About how wide a text is, in its size.
pub(super) fn width(text: &str) -> f64 {
    // Han and kana fill a square, capitals three quarters of one, small letters a bit more than half.
    let wide = |c: char| match c {
        c if u32::from(c) >= 0x2e80 => 1.0,
        c if c.is_uppercase() => 0.76,
        _ => 0.62,
    };
    text.chars().map(wide).sum()
}
