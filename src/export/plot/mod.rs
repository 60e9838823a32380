//! Work against precision as a picture (SVG): both axes logarithmic, a line a method, each with its
//! name at its end.
//!
//! Methods are told apart by marker and dashes as well as by color. A hollow marker is a run that
//! was stopped before it reached what was asked.

mod axis;
mod style;

use super::xml::escape;
use crate::pattern::Point2;
use axis::LogAxis;
use std::fmt::Write;
use style::{curve_style, text};

/// Size of the picture without its foot \[px\].
const SIZE: [f64; 2] = [860.0, 480.0];
/// Margins on the left, right, top and bottom \[px\].
const MARGIN: [f64; 4] = [84.0, 280.0, 48.0, 64.0];
/// Height of a line of the foot, and of a name beside the curves \[px\].
const LINE: f64 = 18.0;
/// Lines of the foot at most.
const FOOT: usize = 60;

/// A picture of curves over two logarithmic axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// Heading above the picture.
    pub heading: String,
    /// Name of the axis across.
    pub across: String,
    /// Name of the axis upwards.
    pub up: String,
    /// The curves.
    pub series: Vec<PlotSeries>,
    /// Lines below the picture, such as what has no place in it.
    pub foot: Vec<String>,
}

/// A curve: the runs of one method.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotSeries {
    /// The method, with what else tells the curve from others; how it is drawn goes by how its name
    /// begins.
    pub name: String,
    /// Runs, in the order in which they are joined.
    pub points: Vec<PlotPoint>,
    /// Size of its markers against the usual.
    pub scale: f64,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotPoint {
    /// Value across; drawn if positive.
    pub across: f64,
    /// Value up; drawn if positive.
    pub up: f64,
    /// True if it reached what was asked.
    pub reached: bool,
    /// Text that a pointer on it is shown.
    pub tip: String,
}

impl PlotPoint {
    fn can_be_drawn(&self) -> bool {
        let positive = |v: f64| v.is_finite() && v > 0.0;
        positive(self.across) && positive(self.up)
    }
}

impl Plot {
    /// Draws the picture.
    pub fn svg(&self) -> String {
        let points = || {
            let all = self.series.iter().flat_map(|s| &s.points);
            all.filter(|p| p.can_be_drawn())
        };
        let [left, right, top, bottom] = MARGIN;
        let across = LogAxis::over(points().map(|p| p.across), [left, SIZE[0] - right]);
        let up = LogAxis::over(points().map(|p| p.up), [SIZE[1] - bottom, top]);
        let foot: Vec<&String> = self.foot.iter().take(FOOT).collect();
        let height = SIZE[1] + LINE * foot.len() as f64;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {height}\" font-family=\"sans-serif\">\n<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
            SIZE[0],
            escape(&self.heading),
            style::SHEET
        );
        out += &text(&self.heading, [left, 0.55 * top], 16.0, "start");
        out += &across.grid([SIZE[1] - bottom, top], false);
        out += &up.grid([left, SIZE[0] - right], true);
        out += &self.axis_names();
        for series in &self.series {
            out += &curve(series, [&across, &up]);
        }
        out += &names(&self.series, [&across, &up]);
        let hollow = "hollow: stopped before it got there";
        out += &text(
            hollow,
            [SIZE[0] - right + 20.0, SIZE[1] - 16.0],
            12.0,
            "start",
        );
        for (i, line) in foot.into_iter().enumerate() {
            out += &text(
                line,
                [20.0, SIZE[1] + LINE * (i as f64 + 0.3)],
                11.0,
                "start",
            );
        }
        out + "</svg>\n"
    }

    fn axis_names(&self) -> String {
        let [left, right, top, bottom] = MARGIN;
        let middle = [
            0.5 * (left + SIZE[0] - right),
            0.5 * (top + SIZE[1] - bottom),
        ];
        let mut out = text(&self.across, [middle[0], SIZE[1] - 16.0], 13.0, "middle");
        let turned = text(&self.up, [0.0, 0.0], 13.0, "middle");
        let _ = writeln!(
            out,
            "<g transform=\"translate(20 {}) rotate(-90)\">{turned}</g>",
            middle[1]
        );
        out
    }
}

fn place(point: &PlotPoint, [across, up]: [&LogAxis; 2]) -> Point2 {
    [across.place(point.across), up.place(point.up)]
}

fn curve(series: &PlotSeries, axes: [&LogAxis; 2]) -> String {
    let style = curve_style(&series.name);
    let drawn = || series.points.iter().filter(|p| p.can_be_drawn());
    let way: Vec<String> = drawn()
        .map(|p| place(p, axes))
        .map(|[x, y]| format!("{x:.1},{y:.1}"))
        .collect();
    let mut out = format!(
        "<polyline points=\"{}\" fill=\"none\" {}/>\n",
        way.join(" "),
        style.stroke(1.8 * series.scale)
    );
    out.extend(drawn().map(|p| style.marker(place(p, axes), p.reached, (series.scale, &p.tip))));
    out
}

/// Draws the name of each curve right of the picture, as near the height of its end as the others
/// leave room, with a thin line from there.
fn names(series: &[PlotSeries], axes: [&LogAxis; 2]) -> String {
    let end = |s: &PlotSeries| {
        let drawn = s.points.iter().filter(|p| p.can_be_drawn());
        let ends = drawn.map(|p| place(p, axes));
        ends.max_by(|p, q| p[0].total_cmp(&q[0]))
    };
    let mut ends: Vec<(&PlotSeries, Point2)> =
        series.iter().filter_map(|s| Some((s, end(s)?))).collect();
    ends.sort_by(|(_, p), (_, q)| p[1].total_cmp(&q[1]));
    let wanted: Vec<f64> = ends.iter().map(|(_, end)| end[1]).collect();
    let [least, most] = [MARGIN[2], SIZE[1] - MARGIN[3] + LINE];
    let heights = apart(&wanted, LINE, [least, most]);
    let x = SIZE[0] - MARGIN[1] + 20.0;
    let one = |((series, end), y): (&(&PlotSeries, Point2), &f64)| {
        let style = curve_style(&series.name);
        let leader = format!(
            "<path d=\"M{:.1} {:.1}L{:.1} {y:.1}H{x}\" fill=\"none\" stroke=\"#8a8f8c\" stroke-width=\"0.7\"/>\n",
            end[0] + 7.0,
            end[1],
            x - 8.0
        );
        let sample = format!(
            "<line x1=\"{x}\" y1=\"{y:.1}\" x2=\"{}\" y2=\"{y:.1}\" {}/>\n",
            x + 40.0,
            style.stroke(1.8 * series.scale)
        );
        let marker = style.marker([x + 20.0, *y], true, (series.scale, &series.name));
        leader + &sample + &marker + &text(&series.name, [x + 48.0, y + 4.0], 12.0, "start")
    };
    ends.iter().zip(&heights).map(one).collect()
}

/// Moves the ascending `wanted` apart by at least `gap`, within `bounds` as far as there is room.
fn apart(wanted: &[f64], gap: f64, [least, most]: [f64; 2]) -> Vec<f64> {
    let mut places: Vec<f64> = Vec::new();
    for &want in wanted {
        let next = places.last().map_or(least, |last| last + gap);
        places.push(want.max(next));
    }
    let mut highest = most;
    for place in places.iter_mut().rev() {
        *place = place.min(highest);
        highest = *place - gap;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_distance_and_their_bounds() {
        let places = apart(&[0.0, 50.0, 52.0, 100.0], 18.0, [10.0, 100.0]);
        assert_eq!(places, [10.0, 50.0, 68.0, 100.0]);
        let places = apart(&[90.0, 95.0, 99.0], 18.0, [10.0, 100.0]);
        assert_eq!(places, [64.0, 82.0, 100.0]);
    }

    #[test]
    fn what_has_no_logarithm_is_not_drawn() {
        let point = |up: f64| PlotPoint {
            across: 1.0,
            up,
            reached: true,
            tip: "a < b & c".to_owned(),
        };
        let series = PlotSeries {
            name: "newton".to_owned(),
            points: vec![point(0.0), point(f64::NAN), point(2.0)],
            scale: 1.0,
        };
        let plot = Plot {
            series: vec![series],
            ..Plot::default()
        };
        let svg = plot.svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        assert_eq!(svg.matches("a &lt; b &amp; c").count(), 1);
    }
}
