//! The style of the lines, markers and texts of a picture: dark on a sheet of their own color.

use crate::export::xml::escape;
use crate::pattern::Point2;

/// The sheet.
pub(super) const SHEET: &str = "#f7f5ef";
/// Grid lines.
pub(super) const GRID: &str = "#cfccc2";
/// Texts.
const DARK: &str = "#24313a";
/// Half the size of a marker \[px\].
const HALF: f64 = 5.0;

/// The style in which the runs of a method are drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurveStyle {
    color: &'static str,
    dashes: &'static str,
    shape: MarkerShape,
}

#[derive(Clone, Copy, Debug)]
enum MarkerShape {
    Circle,
    /// A polygon of these corners, in half sizes from the middle.
    Polygon(&'static [Point2]),
}

const SQUARE: MarkerShape =
    MarkerShape::Polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]);
const DIAMOND: MarkerShape =
    MarkerShape::Polygon(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]);
const UPWARDS: MarkerShape = MarkerShape::Polygon(&[[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]]);
const DOWNWARDS: MarkerShape = MarkerShape::Polygon(&[[0.0, 1.2], [1.1, -0.8], [-1.1, -0.8]]);
const HEXAGON: MarkerShape = MarkerShape::Polygon(&[
    [-0.6, -1.0],
    [0.6, -1.0],
    [1.2, 0.0],
    [0.6, 1.0],
    [-0.6, 1.0],
    [-1.2, 0.0],
]);
const HOURGLASS: MarkerShape =
    MarkerShape::Polygon(&[[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]);
const BOWTIE: MarkerShape =
    MarkerShape::Polygon(&[[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]);
const KITE: MarkerShape = MarkerShape::Polygon(&[[0.0, -1.4], [0.8, 0.0], [0.0, 1.4], [-0.8, 0.0]]);

/// Styles by the begin of a method's name; colors differ in lightness too.
const STYLES: [(&str, CurveStyle); 11] = [
    ("newton, springs, seams", style("#7a4fa3", "2 3", SQUARE)),
    ("newton, springs", style("#0a7355", "", MarkerShape::Circle)),
    ("newton, continuum", style("#12405c", "6 2", HEXAGON)),
    ("newton", style("#12405c", "6 2", HEXAGON)),
    ("auto", style("#0a7355", "", MarkerShape::Circle)),
    ("symplectic_euler", style("#b0471f", "8 3", SQUARE)),
    ("verlet", style("#d08a00", "2 3", UPWARDS)),
    ("implicit_euler", style("#1f62b0", "8 3 2 3", DIAMOND)),
    ("bdf2", style("#8a2f5c", "14 4", DOWNWARDS)),
    ("pypbd", style("#66717a", "1 4", HOURGLASS)),
    ("Newton (NVIDIA), VBD", style("#66717a", "1 4", KITE)),
];
/// The style of a method that has none of its own.
const OTHER: CurveStyle = style("#66717a", "1 4", BOWTIE);

const fn style(color: &'static str, dashes: &'static str, shape: MarkerShape) -> CurveStyle {
    CurveStyle {
        color,
        dashes,
        shape,
    }
}

/// Returns the style of the method of this name.
pub(super) fn curve_style(name: &str) -> CurveStyle {
    let known = STYLES.iter().find(|(start, _)| name.starts_with(start));
    known.map_or(OTHER, |(_, style)| *style)
}

impl CurveStyle {
    /// Returns the attributes of its lines of this width \[px\].
    pub(super) fn stroke(&self, width: f64) -> String {
        format!(
            "stroke=\"{}\" stroke-width=\"{width}\" stroke-dasharray=\"{}\"",
            self.color,
            if self.dashes.is_empty() {
                "none"
            } else {
                self.dashes
            }
        )
    }

    /// Draws a marker, filled or hollow, `scale` times as large as others, with the text that a
    /// pointer on it is shown.
    pub(super) fn marker(&self, [x, y]: Point2, filled: bool, (scale, tip): (f64, &str)) -> String {
        let half = scale * HALF;
        let tip = format!("<title>{}</title>", escape(tip));
        let ink = format!(
            "fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"",
            if filled { self.color } else { SHEET },
            self.color
        );
        match self.shape {
            MarkerShape::Circle => format!(
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{half:.1}\" {ink}>{tip}</circle>\n"
            ),
            MarkerShape::Polygon(corners) => {
                let corner = |c: &Point2| format!("{:.1},{:.1}", x + half * c[0], y + half * c[1]);
                let corners: Vec<String> = corners.iter().map(corner).collect();
                format!(
                    "<polygon points=\"{}\" {ink}>{tip}</polygon>\n",
                    corners.join(" ")
                )
            }
        }
    }
}

/// Draws a text.
pub(super) fn text(text: &str, [x, y]: Point2, size: f64, anchor: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{DARK}\">{}</text>\n",
        escape(text)
    )
}
