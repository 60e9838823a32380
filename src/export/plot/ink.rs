//! What lines, markers and texts of a picture look like: dark on a sheet of their own colour.

/// The sheet.
pub(super) const SHEET: &str = "#f7f5ef";
/// Grid lines.
pub(super) const GRID: &str = "#cfccc2";
/// Texts.
const DARK: &str = "#24313a";
/// Half the size of a marker \[px\].
const HALF: f64 = 5.0;

/// How a method is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    colour: &'static str,
    dashes: &'static str,
    shape: Shape,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    Circle,
    /// A polygon of these corners, in half sizes from the middle.
    Polygon(&'static [[f64; 2]]),
}

const SQUARE: Shape = Shape::Polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]);
const DIAMOND: Shape = Shape::Polygon(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]);
const UPWARDS: Shape = Shape::Polygon(&[[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]]);
const DOWNWARDS: Shape = Shape::Polygon(&[[0.0, 1.2], [1.1, -0.8], [-1.1, -0.8]]);
const HEXAGON: Shape = Shape::Polygon(&[
    [-0.6, -1.0],
    [0.6, -1.0],
    [1.2, 0.0],
    [0.6, 1.0],
    [-0.6, 1.0],
    [-1.2, 0.0],
]);
const HOURGLASS: Shape = Shape::Polygon(&[[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]);
const BOWTIE: Shape = Shape::Polygon(&[[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]);
const KITE: Shape = Shape::Polygon(&[[0.0, -1.4], [0.8, 0.0], [0.0, 1.4], [-0.8, 0.0]]);

/// Looks by the begin of a method's name; colours that differ in lightness too.
const LOOKS: [(&str, Look); 11] = [
    ("newton, springs, seams", look_of("#7a4fa3", "2 3", SQUARE)),
    ("newton, springs", look_of("#0a7355", "", Shape::Circle)),
    ("newton, continuum", look_of("#12405c", "6 2", HEXAGON)),
    ("newton", look_of("#12405c", "6 2", HEXAGON)),
    ("auto", look_of("#0a7355", "", Shape::Circle)),
    ("symplectic_euler", look_of("#b0471f", "8 3", SQUARE)),
    ("verlet", look_of("#d08a00", "2 3", UPWARDS)),
    ("implicit_euler", look_of("#1f62b0", "8 3 2 3", DIAMOND)),
    ("bdf2", look_of("#8a2f5c", "14 4", DOWNWARDS)),
    ("pypbd", look_of("#66717a", "1 4", HOURGLASS)),
    ("Newton (NVIDIA), VBD", look_of("#66717a", "1 4", KITE)),
];
/// What has no look of its own.
const OTHER: Look = look_of("#66717a", "1 4", BOWTIE);

const fn look_of(colour: &'static str, dashes: &'static str, shape: Shape) -> Look {
    Look {
        colour,
        dashes,
        shape,
    }
}

/// The look of the method of this name.
pub(super) fn look(name: &str) -> Look {
    let known = LOOKS.iter().find(|(start, _)| name.starts_with(start));
    known.map_or(OTHER, |(_, look)| *look)
}

impl Look {
    /// The attributes of its lines of this width \[px\].
    pub(super) fn stroke(&self, width: f64) -> String {
        format!(
            "stroke=\"{}\" stroke-width=\"{width}\" stroke-dasharray=\"{}\"",
            self.colour,
            if self.dashes.is_empty() {
                "none"
            } else {
                self.dashes
            }
        )
    }

    /// A marker, filled or hollow, `scale` times as large as others, with what a pointer on it is told.
    pub(super) fn marker(
        &self,
        [x, y]: [f64; 2],
        filled: bool,
        (scale, tip): (f64, &str),
    ) -> String {
        let half = scale * HALF;
        let tip = format!("<title>{}</title>", escaped(tip));
        let ink = format!(
            "fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"",
            if filled { self.colour } else { SHEET },
            self.colour
        );
        match self.shape {
            Shape::Circle => format!(
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{half:.1}\" {ink}>{tip}</circle>\n"
            ),
            Shape::Polygon(corners) => {
                let corner =
                    |c: &[f64; 2]| format!("{:.1},{:.1}", x + half * c[0], y + half * c[1]);
                let corners: Vec<String> = corners.iter().map(corner).collect();
                format!(
                    "<polygon points=\"{}\" {ink}>{tip}</polygon>\n",
                    corners.join(" ")
                )
            }
        }
    }
}

/// A text.
pub(super) fn text(text: &str, [x, y]: [f64; 2], size: f64, anchor: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{DARK}\">{}</text>\n",
        escaped(text)
    )
}

/// A text as it stands between tags.
pub(super) fn escaped(text: &str) -> String {
    let plain = text.replace(|c: char| c.is_control(), " ");
    plain
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
