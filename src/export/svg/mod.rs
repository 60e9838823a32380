//! A pattern as a drawing: its panels in true proportion on a sheet, with the names and numbers by
//! which seams say what is sewn to what. The same pattern gives the same bytes.

mod interior;
mod layout;
mod marks;
mod markup;
mod numbers;
mod panel;
mod style;

use super::xml::escape;
use crate::pattern::point::Point2;
use crate::pattern::{Panel, Pattern};
use layout::PanelSketch;
use markup::{number, shortened};
use panel::PanelDrawing;
use style::{
    CUT_LINE, DARK, EDGE, FOLD_LINE, GRAIN_LINE, INNER_LINE, SHEET, SOFT, StrokeStyle, SvgText,
};

/// Draws a pattern as SVG 1.1 with a view box in millimeters.
///
/// Drawn are outlines with corner and edge numbers, holes, names, grain, notches, drill holes,
/// internal lines with their numbers, the fold of unfolded panels (dash and dot) and cut lines
/// (dashed). The sheet has a color of its own, so that it can be read on a light page and on a dark
/// one. Names are escaped; nothing in it runs or loads anything.
pub fn drawing_svg(pattern: &Pattern) -> String {
    let sketches: Vec<PanelSketch> = pattern.panels.iter().map(PanelSketch::of).collect();
    let sizes: Vec<Point2> = sketches.iter().map(PanelSketch::size).collect();
    let figure = layout::figure(&sizes);
    let drawn: Vec<PanelDrawing> = pattern
        .panels
        .iter()
        .zip(&sketches)
        .map(|(panel, sketch)| panel::draw(panel, sketch, figure))
        .collect();
    let boxes: Vec<Point2> = drawn.iter().map(|drawn| drawn.size).collect();
    let sheet = layout::sheet(&boxes, 3.0 * figure);
    let top = 4.0 * figure;
    let legend = legend(pattern, figure);
    let least = 6.0 * figure + 0.58 * 2.2 * figure * 40.0;
    let size = [sheet.size[0].max(least), sheet.size[1] + top + 3.0 * figure];
    let aside = 0.5 * (size[0] - sheet.size[0]);
    let [w, h] = size.map(number);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" role=\"img\" font-family=\"system-ui, 'Segoe UI', 'Noto Sans', sans-serif\">\n\
         <title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"{SHEET}\"/>\n",
        escape(&pattern.name)
    );
    svg += &heading(pattern, figure);
    for (drawn, [x, y]) in drawn.iter().zip(&sheet.places) {
        let [x, y] = [x + aside, y + top].map(number);
        svg += &format!(
            "<g transform=\"translate({x} {y})\">\n{}</g>\n",
            drawn.content
        );
    }
    let y = number(size[1] - 2.6 * figure);
    svg += &format!(
        "<g transform=\"translate({} {y})\">\n{legend}</g>\n</svg>\n",
        number(3.0 * figure)
    );
    svg
}

/// Draws the name and the number of panels, at the top.
fn heading(pattern: &Pattern, figure: f64) -> String {
    let count = pattern.panels.len();
    let panels = if count == 1 { "panel" } else { "panels" };
    let size = pattern.source.sample_size.as_deref();
    let size = size.map_or_else(String::new, |size| {
        format!(", size {}", shortened(size, 20))
    });
    let text = |text: &str, y: f64, size: f64, is_name: bool| {
        let text = SvgText {
            text,
            at: [3.0 * figure, y],
            size,
            color: if is_name { DARK } else { SOFT },
            bold: is_name,
            rim: SHEET,
        };
        text.draw("start")
    };
    let name = shortened(&pattern.name, 40);
    text(&name, 2.6 * figure, 1.8 * figure, true)
        + &text(
            &format!("{count} {panels}{size}"),
            4.6 * figure,
            figure,
            false,
        )
}

/// Draws the legend: the meaning of the numbers and lines that are on the sheet.
fn legend(pattern: &Pattern, figure: f64) -> String {
    let any = |has: fn(&Panel) -> bool| pattern.panels.iter().any(has);
    let mut out = String::new();
    let mut x = 0.0;
    let mut text =
        |sample: Option<(&str, &'static str)>, line: Option<&StrokeStyle>, meaning: &str| {
            let mut put = |text: &str, color: &'static str, bold: bool| {
                let drawn = SvgText {
                    text,
                    at: [x, 0.0],
                    size: 0.9 * figure,
                    color,
                    bold,
                    rim: SHEET,
                };
                out += &drawn.draw("start");
            };
            if let Some((sample, color)) = sample {
                put(sample, color, color == EDGE);
                x += 0.9 * figure * style::width(sample) + 0.4 * figure;
            }
            if let Some(line) = line {
                let end = x + 3.0 * figure;
                out += &line.line(&[[x, 0.0], [end, 0.0]], false, figure);
                x = end + 0.5 * figure;
            }
            let mut put = |text: &str| {
                let drawn = SvgText {
                    text,
                    at: [x, 0.0],
                    size: 0.9 * figure,
                    color: SOFT,
                    bold: false,
                    rim: SHEET,
                };
                out += &drawn.draw("start");
            };
            put(meaning);
            x += 0.9 * figure * style::width(meaning) + 1.6 * figure;
        };
    text(Some(("0", DARK)), None, "corner");
    text(Some(("0", EDGE)), None, "edge");
    if any(|panel| panel.grain.is_some()) {
        text(None, Some(&GRAIN_LINE), "grain");
    }
    if any(|panel| panel.unfolded) {
        text(None, Some(&FOLD_LINE), "fold");
    }
    if any(|panel| !panel.cut_line.is_empty()) {
        text(None, Some(&CUT_LINE), "cut");
    }
    if any(|panel| !panel.internal_lines.is_empty()) {
        text(None, Some(&INNER_LINE), "line on the cloth");
    }
    out
}
