//! Triangles as they lie on the samples of a picture.
//!
//! Corners are rounded to a grid much finer than the samples; from there on coverage is exact:
//! every sample inside a surface belongs to one triangle, also where two of them meet.

use super::camera::Seen;
use std::ops::Range;

/// Grid lines of one sample.
const GRID: i64 = 256;

/// A triangle, with values that change linearly over it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScreenTriangle {
    /// Corners on the grid, in the order that makes the area positive.
    corners: [[i64; 2]; 3],
    /// Height towards the viewer \[m\].
    depth: Plane,
    /// Share of its color that is seen.
    tone: Plane,
    /// Red, green and blue of the side that is seen.
    color: [u8; 3],
}

/// A sample that a triangle covers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Covered {
    /// Column.
    pub(super) x: usize,
    /// Row.
    pub(super) y: usize,
    /// Height towards the viewer \[m\].
    pub(super) depth: f64,
    /// Share of its color that is seen.
    pub(super) tone: f64,
}

/// Corner of a triangle to be drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShadedCorner {
    /// Its place in the picture.
    pub(super) seen: Seen,
    /// Share of its color that is seen.
    pub(super) tone: f64,
}

impl ScreenTriangle {
    /// Creates a triangle, if it covers any area.
    pub(super) fn new(corners: [ShadedCorner; 3], color: [u8; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let places = [a, b, c].map(|corner| corner.seen.at.map(grid));
        match cross(places[0], places[1], places[2]) {
            0 => None,
            area if area < 0 => Self::new([a, c, b], color),
            _ => Some(Self {
                corners: places,
                depth: Plane::new(places, corners.map(|corner| corner.seen.depth)),
                tone: Plane::new(places, corners.map(|corner| corner.tone)),
                color,
            }),
        }
    }

    /// Red, green and blue before light.
    pub(super) fn color(&self) -> [u8; 3] {
        self.color
    }

    /// Calls `put` for each of its samples within the rows and columns given.
    pub(super) fn cover(
        &self,
        rows: Range<usize>,
        columns: Range<usize>,
        mut put: impl FnMut(Covered),
    ) {
        let [a, b, c] = self.corners;
        let edges = [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)];
        let columns = self.samples(0, columns);
        for row in self.samples(1, rows) {
            let y = center(row);
            let span = edges
                .iter()
                .fold(columns.clone(), |span, edge| edge.clip(y, span));
            for column in span {
                let at = [center(column), y];
                put(Covered {
                    x: column,
                    y: row,
                    depth: self.depth.at(at),
                    tone: self.tone.at(at),
                });
            }
        }
    }

    /// Returns the columns (axis 0) or rows (axis 1) of samples that it may cover, of those given.
    fn samples(&self, axis: usize, of: Range<usize>) -> Range<usize> {
        let places = self.corners.map(|corner| corner[axis].div_euclid(GRID));
        let low = places.into_iter().min().unwrap_or(0).max(0);
        let high = places
            .into_iter()
            .max()
            .unwrap_or(-1)
            .saturating_add(1)
            .max(0);
        let index = |place: i64| usize::try_from(place).unwrap_or(0);
        of.start.max(index(low))..of.end.min(index(high))
    }
}

/// Line that bounds a triangle.
#[derive(Clone, Copy, Debug)]
struct Edge {
    from: [i64; 2],
    along: [i64; 2],
    /// 0 if points on the line are in, else 1: of two triangles that share an edge one has them.
    least: i64,
}

impl Edge {
    fn new(from: [i64; 2], to: [i64; 2]) -> Self {
        let along = [to[0] - from[0], to[1] - from[1]];
        let is_in = along[1] > 0 || (along[1] == 0 && along[0] > 0);
        Self {
            from,
            along,
            least: i64::from(!is_in),
        }
    }

    /// Returns those of the columns whose samples at the height `y` are on its inner side.
    fn clip(&self, y: i64, columns: Range<usize>) -> Range<usize> {
        // A sample x is in if inner - slope x >= 0.
        let [along_x, along_y] = self.along;
        let first = along_x * (y - self.from[1]) - along_y * (center(0) - self.from[0]);
        let (inner, slope) = (first - self.least, along_y * GRID);
        let sample = |x: i64| usize::try_from(x.max(0)).unwrap_or(usize::MAX);
        match slope {
            0 if inner >= 0 => columns,
            0 => 0..0,
            1.. => columns.start..columns.end.min(sample(inner.div_euclid(slope) + 1)),
            _ => columns.start.max(sample(-inner.div_euclid(-slope)))..columns.end,
        }
    }
}

/// Linear function of a place on the grid.
#[derive(Clone, Copy, Debug)]
struct Plane {
    from: [i64; 2],
    value: f64,
    slope: [f64; 2],
}

impl Plane {
    /// Creates the function that has `values` at the corners of a triangle of positive area.
    fn new(corners: [[i64; 2]; 3], values: [f64; 3]) -> Self {
        let [a, b, c] = corners;
        let area = cross(a, b, c) as f64;
        let [p, q] = [b, c].map(|end| [0, 1].map(|axis| (end[axis] - a[axis]) as f64));
        let [along_p, along_q] = [values[1] - values[0], values[2] - values[0]];
        Self {
            from: a,
            value: values[0],
            slope: [
                (along_p * q[1] - along_q * p[1]) / area,
                (along_q * p[0] - along_p * q[0]) / area,
            ],
        }
    }

    fn at(&self, [x, y]: [i64; 2]) -> f64 {
        let [dx, dy] = [x - self.from[0], y - self.from[1]].map(|d| d as f64);
        self.value + self.slope[0] * dx + self.slope[1] * dy
    }
}

/// Returns twice the area of a triangle on the grid. Subjects are bounded, and so is the scale:
/// coordinates stay below 2^30, the products of their differences below 2^62.
fn cross(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Returns the middle of a sample on the grid.
fn center(sample: usize) -> i64 {
    i64::try_from(sample).unwrap_or(i64::MAX / GRID - 1) * GRID + GRID / 2
}

fn grid(samples: f64) -> i64 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a cast of floats to integers saturates"
    )]
    let place = (samples * GRID as f64).round() as i64;
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn triangle(corners: [[f64; 2]; 3], depths: [f64; 3]) -> ScreenTriangle {
        let corner = |i: usize| ShadedCorner {
            seen: Seen {
                at: corners[i],
                depth: depths[i],
            },
            tone: 1.0,
        };
        ScreenTriangle::new([0, 1, 2].map(corner), [9; 3]).expect("it has area")
    }

    fn covered(triangle: &ScreenTriangle) -> Vec<[usize; 2]> {
        let mut found = vec![];
        triangle.cover(0..100, 0..100, |sample| found.push([sample.x, sample.y]));
        found
    }

    #[test]
    fn triangle_covers_the_samples_whose_middle_it_holds() {
        // Middles lie at halves: x + y < 3.2 has those with x + y <= 2 counted from sample 0.
        let turns = [[0, 1, 2], [2, 1, 0]];
        for turn in turns {
            let corners = [[0.0, 0.0], [3.2, 0.0], [0.0, 3.2]];
            let found = covered(&triangle(turn.map(|i| corners[i]), [0.0; 3]));
            assert_eq!(found, [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [0, 2]]);
        }
    }

    #[test]
    fn triangles_that_share_an_edge_share_no_sample_and_leave_none_out() {
        // The diagonal and the sides go through middles of samples.
        let [a, b, c, d] = [[0.5, 0.5], [8.5, 0.5], [8.5, 8.5], [0.5, 8.5]];
        let mut found = covered(&triangle([a, b, c], [0.0; 3]));
        found.extend(covered(&triangle([a, c, d], [0.0; 3])));
        let apart: BTreeSet<_> = found.iter().copied().collect();
        assert_eq!(found.len(), 64);
        assert_eq!(apart.len(), 64);
    }

    #[test]
    fn depth_is_linear_between_corners() {
        let tilted = triangle([[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]], [1.0, 2.0, 5.0]);
        tilted.cover(0..10, 0..10, |sample| {
            let [x, y] = [sample.x, sample.y].map(|i| i as f64 + 0.5);
            let expected = 1.0 + 0.1 * x + 0.4 * y;
            assert!((sample.depth - expected).abs() < 1e-12);
        });
    }

    #[test]
    fn only_samples_in_the_frame_are_covered() {
        let wide = triangle([[-1e4, -1e4], [2e4, -1e4], [-1e4, 2e4]], [0.0; 3]);
        let mut count = 0;
        wide.cover(2..5, 1..3, |sample| {
            assert!((2..5).contains(&sample.y) && (1..3).contains(&sample.x));
            count += 1;
        });
        assert_eq!(count, 6);
        let outside = triangle([[-9.0, -9.0], [-1.0, -9.0], [-9.0, -1.0]], [0.0; 3]);
        assert!(covered(&outside).is_empty());
    }
}
