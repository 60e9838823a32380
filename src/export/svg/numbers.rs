//! The numbers of corners and edges, by which seams name them.

use super::markup::number;
use super::style::{CLOTH, DARK, EDGE, SHEET, SvgText};
use crate::pattern::Edge;
use crate::pattern::point::{Point2, distance, sub};
use crate::pattern::polyline::length;

/// The style in which numbers are put on a panel.
pub(super) struct NumberStyle {
    /// Size of figures where there is room \[mm\].
    pub(super) figure: f64,
    /// True if they stand outside: the panel is too narrow for them.
    pub(super) outside: bool,
    /// +1 or -1: inwards is this times the left of the way round.
    pub(super) sense: f64,
}

impl NumberStyle {
    /// Returns a unit vector inwards from a way.
    pub(super) fn inwards(&self, way: Point2) -> Point2 {
        let long = way[0].hypot(way[1]).max(f64::MIN_POSITIVE);
        [-self.sense * way[1] / long, self.sense * way[0] / long]
    }

    /// Returns the size of a number beside an edge of a length: it stands there with two others.
    fn size(&self, index: usize, room: f64) -> f64 {
        (room / (3.2 + 1.8 * extra_digits(index))).clamp(0.45 * self.figure, self.figure)
    }

    fn text(&self, index: usize, at: Point2, size: f64, color: &'static str) -> String {
        SvgText {
            text: &index.to_string(),
            at,
            size,
            color,
            bold: color == EDGE,
            rim: if self.outside { SHEET } else { CLOTH },
        }
        .draw("middle")
    }

    /// Returns a place off `at` where a number of a size does not touch the line.
    fn beside(&self, at: Point2, inwards: Point2, (index, size): (usize, f64), way: f64) -> Point2 {
        let way = size * (way + 0.3 * extra_digits(index) * inwards[0].abs());
        let way = if self.outside { -way } else { way };
        [0, 1].map(|k| at[k] + way * inwards[k])
    }

    /// Draws the numbers of the edges `lines`, whose indices are those of `edges`.
    pub(super) fn of_edges(&self, edges: &[Edge], lines: &[Vec<Point2>]) -> String {
        let edge = |(edge, line): (&Edge, &Vec<Point2>)| {
            let (at, way) = along(line, 0.5);
            let size = self.size(edge.index, length(line));
            let at = self.beside(at, self.inwards(way), (edge.index, size), 0.8);
            self.text(edge.index, at, size, EDGE)
        };
        edges.iter().zip(lines).map(edge).collect()
    }

    /// Draws dots at the corners, where each edge begins, with their numbers.
    pub(super) fn of_corners(&self, lines: &[Vec<Point2>]) -> String {
        let count = lines.len();
        let corner = |i: usize| {
            let (before, after) = (&lines[(i + count - 1) % count], &lines[i]);
            let at = after[0];
            let size = self.size(i, length(before).min(length(after)));
            let inwards = [along(before, 1.0).1, along(after, 0.0).1].map(|way| self.inwards(way));
            let mut between = [0, 1].map(|k| inwards[0][k] + inwards[1][k]);
            if between[0].hypot(between[1]) < 1e-3 {
                between = inwards[0];
            }
            let long = between[0].hypot(between[1]);
            let at_number = self.beside(at, between.map(|c| c / long), (i, size), 1.05);
            let dot = format!(
                "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{DARK}\"/>\n",
                number(at[0]),
                number(at[1]),
                number(0.22 * size)
            );
            dot + &self.text(i, at_number, size, DARK)
        };
        (0..count).map(corner).collect()
    }
}

/// Returns the number of digits beyond the first.
fn extra_digits(index: usize) -> f64 {
    match index {
        0..10 => 0.0,
        10..100 => 1.0,
        _ => 2.0,
    }
}

/// Returns the point at a fraction of a polyline's length, and the way it goes there.
pub(super) fn along(line: &[Point2], at: f64) -> (Point2, Point2) {
    let mut left = at * length(line);
    let count = line.len() - 1;
    for (i, pair) in line.windows(2).enumerate() {
        let long = distance(pair[0], pair[1]);
        let way = sub(pair[1], pair[0]);
        if (left <= long && long > 0.0) || i + 1 == count {
            let share = if long > 0.0 {
                (left / long).min(1.0)
            } else {
                0.0
            };
            return ([0, 1].map(|k| pair[0][k] + share * way[k]), way);
        }
        left -= long;
    }
    (line[0], [1.0, 0.0])
}
