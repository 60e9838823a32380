//! The drawing of one panel.

use super::interior::{coarse, reach, roomiest};
use super::layout::PanelSketch;
use super::marks;
use super::markup::{path, shortened};
use super::numbers::{NumberStyle, along};
use super::style::{
    CLOTH, CUT_LINE, DARK, INNER, INNER_LINE, OUTLINE, SHEET, SOFT, SvgText, width,
};
use crate::export::xml::escape;
use crate::pattern::point::Point2;
use crate::pattern::polyline::{contains, signed_area};
use crate::pattern::{Edge, Panel};

/// The most characters of a name that are drawn; the title has all.
const NAME: usize = 40;

/// A panel drawn, its box's upper left corner at the origin.
pub(super) struct PanelDrawing {
    /// Its elements.
    pub(super) content: String,
    /// Width and height of its box \[mm\].
    pub(super) size: Point2,
}

/// Draws a panel with figures of a size \[mm\].
pub(super) fn draw(panel: &Panel, sketch: &PanelSketch, figure: f64) -> PanelDrawing {
    let lines = on_sketch(&panel.edges, sketch);
    if lines.is_empty() {
        let (content, size) = (String::new(), sketch.size());
        return PanelDrawing { content, size };
    }
    let ring = ring(&lines);
    let hole_lines: Vec<Vec<Vec<Point2>>> = panel
        .holes
        .iter()
        .map(|hole| on_sketch(&hole.edges, sketch))
        .collect();
    let holes: Vec<Vec<Point2>> = hole_lines.iter().map(|lines| self::ring(lines)).collect();
    let coarse_holes: Vec<Vec<Point2>> = holes.iter().map(|hole| coarse(hole)).collect();
    let middle = roomiest(&coarse(&ring), &coarse_holes);
    let (middle, room) = middle.unwrap_or((ring[0], 0.0));
    let numbers = NumberStyle {
        figure,
        outside: room < 1.9 * figure,
        sense: signed_area(&ring).signum(),
    };
    let label = PanelLabel::of(panel, &ring, (middle, room), figure);
    let mut content = format!("<title>{}</title>\n", escape(&panel.name));
    if !panel.cut_line.is_empty() {
        content += &CUT_LINE.line(&sketch.points(&panel.cut_line), true, figure);
    }
    content += &cloth(&ring, &holes, figure);
    content += &inner_lines(panel, sketch, figure);
    let rings: Vec<&[Point2]> = std::iter::once(&ring)
        .chain(&holes)
        .map(Vec::as_slice)
        .collect();
    content += &directions(panel, &rings, &label, figure);
    for at in &panel.drill_holes {
        content += &marks::drill(sketch.point(*at), figure);
    }
    for notch in panel
        .notches
        .iter()
        .filter(|notch| notch.edge < lines.len())
    {
        let (at, way) = along(&lines[notch.edge], notch.at);
        content += &marks::notch(notch, at, numbers.inwards(way), figure);
    }
    content += &numbers.of_edges(&panel.edges, &lines);
    content += &numbers.of_corners(&lines);
    for (hole, lines) in panel.holes.iter().zip(&hole_lines) {
        let numbers = NumberStyle {
            figure: 0.7 * figure,
            outside: false,
            sense: -signed_area(&self::ring(lines)).signum(),
        };
        content += &numbers.of_edges(&hole.edges, lines);
        content += &numbers.of_corners(lines);
    }
    let (text, size) = label.draw(sketch.size(), numbers.outside);
    content += &text;
    PanelDrawing { content, size }
}

fn on_sketch(edges: &[Edge], sketch: &PanelSketch) -> Vec<Vec<Point2>> {
    let drawn = edges.iter().filter(|edge| edge.points.len() > 1);
    drawn.map(|edge| sketch.points(&edge.points)).collect()
}

fn ring(lines: &[Vec<Point2>]) -> Vec<Point2> {
    let parts = lines.iter().map(|line| &line[..line.len() - 1]);
    parts.flatten().copied().collect()
}

/// Draws outline and holes as one area.
fn cloth(ring: &[Point2], holes: &[Vec<Point2>], figure: f64) -> String {
    let holes: String = holes.iter().map(|hole| path(hole, true)).collect();
    format!(
        "<path d=\"{}{holes}\" fill=\"{CLOTH}\" fill-rule=\"evenodd\" stroke-linejoin=\"round\"{}/>\n",
        path(ring, true),
        OUTLINE.attributes(figure)
    )
}

/// Draws the lines on the cloth, each with its number.
fn inner_lines(panel: &Panel, sketch: &PanelSketch, figure: f64) -> String {
    let lines = panel.internal_lines.iter().enumerate();
    let line = |(i, line): (usize, &Vec<Point2>)| {
        let points = sketch.points(line);
        if points.len() < 2 {
            return String::new();
        }
        let text = SvgText {
            text: &i.to_string(),
            at: along(&points, 0.5).0,
            size: 0.6 * figure,
            color: INNER,
            bold: false,
            rim: CLOTH,
        };
        INNER_LINE.line(&points, false, figure) + &text.draw("middle")
    };
    lines.map(line).collect()
}

/// Draws fold and grain.
fn directions(panel: &Panel, rings: &[&[Point2]], label: &PanelLabel, figure: f64) -> String {
    let (sin, cos) = panel
        .grain
        .map_or(90.0, |grain| grain.angle_deg)
        .to_radians()
        .sin_cos();
    let way = [cos, -sin];
    let mut content = String::new();
    let fold = panel.unfolded.then(|| marks::fold(rings[0], way)).flatten();
    if let Some(fold) = fold {
        content += &marks::fold_line(fold, figure);
    }
    if panel.grain.is_some() {
        // Aside of the name where the arrow would run along it, and of the fold, if there is room.
        let lies = sin.abs() < 0.5;
        let aside = match (label.fits.is_some(), fold.is_some()) {
            (true, _) if lies => 2.6 * figure,
            (_, true) => 1.5 * figure,
            _ => 0.0,
        };
        let beside = [
            label.at[0] + aside * sin.abs(),
            label.at[1] + aside * cos.abs(),
        ];
        let is_inside = contains(rings[0], beside);
        let about = if is_inside { beside } else { label.at };
        content += &marks::grain(rings, about, way, figure);
    }
    content
}

/// The name of a panel, and the number of pieces that are cut.
struct PanelLabel {
    name: String,
    note: String,
    at: Point2,
    /// Size of the name where it fits inside \[mm\].
    fits: Option<f64>,
    figure: f64,
}

impl PanelLabel {
    fn of(panel: &Panel, ring: &[Point2], (at, room): (Point2, f64), figure: f64) -> Self {
        let name = shortened(&panel.name, NAME);
        let note = note(panel);
        let ring = coarse(ring);
        // Both lines of the label must keep off the outline.
        let widths = [-0.8, 0.0, 1.6].map(|y| {
            let row = [at[0], at[1] + y * figure];
            let [right, left] = reach(&[&ring], row, [1.0, 0.0]);
            right.min(left)
        });
        // Numbers of edges stand between.
        let half = widths.into_iter().fold(f64::INFINITY, f64::min) - 1.6 * figure;
        let wanted = 1.4 * figure;
        let size = wanted.min(2.0 * half / width(&name));
        let note_fits = width(&note) * 0.8 * figure <= 2.0 * half;
        let fits = room > 3.0 * figure && size >= 0.8 * figure && note_fits;
        Self {
            name,
            note,
            at,
            fits: fits.then_some(size),
            figure,
        }
    }

    /// Draws the texts, and returns the size of the panel's box with them.
    fn draw(&self, size: Point2, numbers_outside: bool) -> (String, Point2) {
        let figure = self.figure;
        let line = |text: &str, at: Point2, size: f64, is_name: bool, rim: &'static str| {
            let color = if is_name { DARK } else { SOFT };
            let bold = is_name;
            let text = SvgText {
                text,
                at,
                size,
                color,
                bold,
                rim,
            };
            text.draw("middle")
        };
        if let Some(height) = self.fits {
            let below = [self.at[0], self.at[1] + 1.5 * figure];
            let text = line(&self.name, self.at, height, true, CLOTH)
                + &line(&self.note, below, 0.8 * figure, false, CLOTH);
            return (text, size);
        }
        let wide = (width(&self.name) * figure).max(width(&self.note) * 0.8 * figure);
        let top = size[1] + if numbers_outside { 2.6 } else { 1.5 } * figure;
        // A label wider than its panel goes on to the right: its box grows that way.
        let middle = 0.5 * wide.max(size[0]);
        let text = line(&self.name, [middle, top], figure, true, SHEET)
            + &line(
                &self.note,
                [middle, top + 1.3 * figure],
                0.8 * figure,
                false,
                SHEET,
            );
        (text, [size[0].max(wide), top + 1.8 * figure])
    }
}

/// Returns the id by which seams name the panel, where it is not its name, and the number of pieces
/// that are cut.
fn note(panel: &Panel) -> String {
    let mut parts = Vec::new();
    if panel.id != panel.name {
        parts.push(shortened(&panel.id, NAME));
    }
    if panel.copy_of.is_some() {
        parts.push("mirrored".to_owned());
    }
    if let Some(quantity) = panel.quantity {
        match (quantity.left, quantity.right) {
            (0, 0) => {}
            (left, 0) => parts.push(format!("cut {left}")),
            (left, right) => parts.push(format!("cut {left} + {right} mirrored")),
        }
    }
    parts.join(" · ")
}
