//! A closed outline on its way to a panel: points with the ones marked that are corners.

use super::chain::Chain;
use super::joint;
use crate::pattern::point::{Point2, distance, turn};
use crate::pattern::polyline::signed_area;
use std::collections::BTreeSet;

/// Points closer than this are one \[m\]: half the rounding of CAD.
const SAME: f64 = 1.5e-6;

/// An outline turns at a corner by at least this; smaller turns are those of curves drawn as polylines \[radians\].
const CORNER: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// A closed polyline with flags.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    /// The points; the last runs on to the first.
    pub(super) points: Vec<Point2>,
    /// Which of them are corners.
    pub(super) corner: Vec<bool>,
}

impl Ring {
    /// A chain without its duplicate points, with corners chosen.
    ///
    /// Several runs: where runs end, and at turn points that turn. One run with turn points: at each of them. Else
    /// where it turns by 20 degrees or more, or the polyline gives a shallower corner away.
    pub(super) fn new(chain: &Chain, turns: &[Point2]) -> Self {
        let mut ring = Self {
            points: Vec::with_capacity(chain.points.len()),
            corner: Vec::new(),
        };
        let mut made: Vec<bool> = Vec::new();
        for (i, (point, end)) in chain.points.iter().zip(&chain.run_end).enumerate() {
            match ring.points.last() {
                Some(last) if distance(*last, *point) <= SAME => {
                    if let Some(corner) = ring.corner.last_mut() {
                        *corner |= *end;
                    }
                }
                _ => {
                    ring.points.push(*point);
                    ring.corner.push(*end);
                    made.push(chain.made[i]);
                }
            }
        }
        while ring.points.len() > 1
            && distance(ring.points[0], ring.points[ring.points.len() - 1]) <= SAME
        {
            ring.points.pop();
            ring.corner[0] |= ring.corner.pop().unwrap_or_default();
        }
        made.truncate(ring.points.len());
        ring.choose_corners(turns, &made);
        ring
    }

    fn choose_corners(&mut self, turns: &[Point2], made: &[bool]) {
        let runs = self.corner.iter().any(|end| *end);
        let turn_point = marked(&self.points, turns);
        let any_turn_point = turn_point.iter().any(|t| *t);
        let joints = if runs {
            vec![false; self.points.len()]
        } else {
            joint::joints(&self.points, made, CORNER)
        };
        for (i, marked) in turn_point.into_iter().enumerate() {
            let sharp = self.turn_at(i).abs() >= CORNER || joints[i];
            self.corner[i] |= match (runs, any_turn_point) {
                (true, true) => marked && sharp,
                (false, true) => marked,
                (_, false) => sharp,
            };
        }
    }

    /// The turn at a point \[radians\].
    pub(super) fn turn_at(&self, i: usize) -> f64 {
        let n = self.points.len();
        turn(
            self.points[(i + n - 1) % n],
            self.points[i],
            self.points[(i + 1) % n],
        )
    }

    /// Whether it turns sharply at a point.
    pub(super) fn sharp_at(&self, i: usize) -> bool {
        self.turn_at(i).abs() >= CORNER
    }

    /// Makes it clockwise, beginning at a corner; outlines with fewer than two corners get some: a round one its
    /// four extremes, one with a single corner the point half way round.
    pub(super) fn into_clockwise(mut self) -> Self {
        if signed_area(&self.points) > 0.0 {
            self.points[1..].reverse();
            self.corner[1..].reverse();
        }
        match self.corner.iter().filter(|c| **c).count() {
            0 => self.mark_extremes(),
            1 => self.mark_half_way(),
            _ => {}
        }
        let first = self.corner.iter().position(|c| *c).unwrap_or(0);
        self.points.rotate_left(first);
        self.corner.rotate_left(first);
        self
    }

    fn mark_extremes(&mut self) {
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            let most = (0..self.points.len()).max_by(|a, b| {
                (sign * self.points[*a][axis]).total_cmp(&(sign * self.points[*b][axis]))
            });
            if let Some(i) = most {
                self.corner[i] = true;
            }
        }
    }

    fn mark_half_way(&mut self) {
        let start = self.corner.iter().position(|c| *c).unwrap_or(0);
        let n = self.points.len();
        let half = crate::pattern::polyline::perimeter(&self.points) / 2.0;
        let mut way = 0.0;
        for k in 1..n {
            way += distance(
                self.points[(start + k - 1) % n],
                self.points[(start + k) % n],
            );
            if way >= half {
                self.corner[(start + k) % n] = true;
                return;
            }
        }
        self.corner[(start + n - 1) % n] = true;
    }
}

/// Which points of an outline have a mark on them.
fn marked(points: &[Point2], marks: &[Point2]) -> Vec<bool> {
    let cells: BTreeSet<(i64, i64)> = marks.iter().map(|p| cell(*p)).collect();
    let near = |(x, y): (i64, i64)| {
        (-1..=1).any(|dx| (-1..=1).any(|dy| cells.contains(&(x + dx, y + dy))))
    };
    points.iter().map(|p| near(cell(*p))).collect()
}

/// The cell of 10 um that a point lies in: marks are rounded like outlines, to 3 um at worst.
#[expect(
    clippy::cast_possible_truncation,
    reason = "outlines are checked to be smaller than 20 m and near the origin"
)]
fn cell(p: Point2) -> (i64, i64) {
    let index = |c: f64| (c * 1e5).round().clamp(-1e15, 1e15) as i64;
    (index(p[0]), index(p[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(points: &[Point2]) -> Chain {
        Chain {
            points: points.to_vec(),
            run_end: vec![false; points.len()],
            made: vec![false; points.len()],
            closed: true,
            repaired: None,
            line: 1,
            runs: 1,
        }
    }

    #[test]
    fn duplicate_points_go_and_corners_are_found_by_angle() {
        let ring = Ring::new(
            &chain(&[
                [0.0, 0.0],
                [1.0, 0.0],
                [1.0, 0.0],
                [1.0, 1.0],
                [0.5, 1.01],
                [0.0, 1.0],
                [0.0, 0.0],
            ]),
            &[],
        );
        assert_eq!(ring.points.len(), 5);
        assert_eq!(ring.corner, [true, true, true, false, true]);
    }

    #[test]
    fn turn_points_alone_are_corners_of_a_single_run() {
        let ring = Ring::new(
            &chain(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.01], [0.0, 1.0]]),
            &[[0.5, 1.01], [0.0, 0.0]],
        );
        assert_eq!(ring.corner, [true, false, false, true, false]);
    }

    #[test]
    fn clockwise_ring_begins_at_a_corner() {
        let ring = Ring::new(
            &chain(&[[0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]]),
            &[],
        )
        .into_clockwise();
        assert!(signed_area(&ring.points) < 0.0);
        assert!(ring.corner[0]);
        assert_eq!(ring.points[0], [0.0, 0.0]);
    }

    #[test]
    fn round_outline_gets_four_corners() {
        let points: Vec<Point2> = (0..90)
            .map(|i| f64::from(i) * 4.0_f64.to_radians())
            .map(|a| [a.cos(), a.sin()])
            .collect();
        let ring = Ring::new(&chain(&points), &[]).into_clockwise();
        assert_eq!(ring.corner.iter().filter(|c| **c).count(), 4);
    }
}
