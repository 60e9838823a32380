//! The corners of a closed outline.

use super::chain::PathChain;
use super::shallow_corners::shallow_corners;
use crate::pattern::point::{Point2, distance, turn};
use crate::pattern::polyline::{perimeter, signed_area};
use std::collections::BTreeSet;

/// Points closer than this are one \[m\]: half the rounding of CAD.
const SAME: f64 = 1.5e-6;

/// An outline turns at a corner by at least this; smaller turns are those of curves drawn as
/// polylines \[rad\].
const CORNER: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// A closed polyline with its corners marked.
#[derive(Clone, Debug)]
pub(super) struct CorneredRing {
    /// The points; the last runs on to the first.
    pub(super) points: Vec<Point2>,
    /// Point by point, true if it is a corner.
    pub(super) is_corner: Vec<bool>,
}

impl CorneredRing {
    /// Returns a chain without its duplicate points, with corners chosen.
    ///
    /// Several paths: where paths end, and at turn points that turn. One path with turn points: at
    /// each of them. Else where it turns by 20 degrees or more, or the polyline gives a shallower
    /// corner away.
    pub(super) fn new(chain: &PathChain, turn_points: &[Point2]) -> Self {
        let mut ring = Self {
            points: Vec::with_capacity(chain.points.len()),
            is_corner: Vec::new(),
        };
        let mut sampled: Vec<bool> = Vec::new();
        for (i, (point, end)) in chain.points.iter().zip(&chain.path_end).enumerate() {
            let last = ring.points.last();
            if last.is_some_and(|last| distance(*last, *point) <= SAME) {
                if let Some(is_corner) = ring.is_corner.last_mut() {
                    *is_corner |= *end;
                }
            } else {
                ring.points.push(*point);
                ring.is_corner.push(*end);
                sampled.push(chain.sampled[i]);
            }
        }
        while ring.points.len() > 1
            && distance(ring.points[0], ring.points[ring.points.len() - 1]) <= SAME
        {
            ring.points.pop();
            ring.is_corner[0] |= ring.is_corner.pop().unwrap_or_default();
        }
        sampled.truncate(ring.points.len());
        ring.choose_corners(turn_points, &sampled);
        ring
    }

    /// Chooses corners; those flagged so far are ends of paths.
    fn choose_corners(&mut self, turn_points: &[Point2], sampled: &[bool]) {
        let has_path_ends = self.is_corner.iter().any(|end| *end);
        let is_turn_point = marked(&self.points, turn_points);
        let has_turn_points = is_turn_point.iter().any(|t| *t);
        let shallow = if has_path_ends {
            vec![false; self.points.len()]
        } else {
            shallow_corners(&self.points, sampled, CORNER)
        };
        for (i, is_turn_point) in is_turn_point.into_iter().enumerate() {
            let turns = self.is_sharp(i) || shallow[i];
            self.is_corner[i] |= match (has_path_ends, has_turn_points) {
                (true, true) => is_turn_point && turns,
                (false, true) => is_turn_point,
                (_, false) => turns,
            };
        }
    }

    /// Returns true if it turns sharply at a point.
    pub(super) fn is_sharp(&self, i: usize) -> bool {
        let n = self.points.len();
        let [before, after] = [(i + n - 1) % n, (i + 1) % n];
        let [a, b, c] = [before, i, after].map(|k| self.points[k]);
        turn(a, b, c).abs() >= CORNER
    }

    /// Makes it clockwise, beginning at a corner; outlines with fewer than two corners get some: a
    /// round one its four extremes, one with a single corner the point half way round.
    pub(super) fn into_clockwise(mut self) -> Self {
        if signed_area(&self.points) > 0.0 {
            self.points[1..].reverse();
            self.is_corner[1..].reverse();
        }
        match self.is_corner.iter().filter(|c| **c).count() {
            0 => self.mark_extremes(),
            1 => self.mark_half_way(),
            _ => {}
        }
        let first = self.first_corner();
        self.points.rotate_left(first);
        self.is_corner.rotate_left(first);
        self
    }

    fn first_corner(&self) -> usize {
        self.is_corner.iter().position(|c| *c).unwrap_or(0)
    }

    fn mark_extremes(&mut self) {
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            let along = |i: &usize| sign * self.points[*i][axis];
            let most = (0..self.points.len()).max_by(|a, b| along(a).total_cmp(&along(b)));
            if let Some(i) = most {
                self.is_corner[i] = true;
            }
        }
    }

    fn mark_half_way(&mut self) {
        let start = self.first_corner();
        let n = self.points.len();
        let half = perimeter(&self.points) / 2.0;
        let mut way = 0.0;
        for k in 1..n {
            let [from, to] = [(start + k - 1) % n, (start + k) % n];
            way += distance(self.points[from], self.points[to]);
            if way >= half {
                self.is_corner[to] = true;
                return;
            }
        }
        self.is_corner[(start + n - 1) % n] = true;
    }
}

/// Returns point by point true if a mark lies on it.
fn marked(points: &[Point2], marks: &[Point2]) -> Vec<bool> {
    let cells: BTreeSet<(i64, i64)> = marks.iter().map(|p| cell(*p)).collect();
    let has_mark_near = |(x, y): (i64, i64)| {
        (-1..=1).any(|dx| (-1..=1).any(|dy| cells.contains(&(x + dx, y + dy))))
    };
    points.iter().map(|p| has_mark_near(cell(*p))).collect()
}

/// Returns the cell of 10 um that a point lies in: marks are rounded like outlines, to 3 um at
/// worst.
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

    #[test]
    fn duplicate_points_go_and_corners_are_found_by_angle() {
        let ring = CorneredRing::new(
            &PathChain::ring(&[
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
        assert_eq!(ring.is_corner, [true, true, true, false, true]);
    }

    #[test]
    fn turn_points_alone_are_corners_of_a_single_path() {
        let ring = CorneredRing::new(
            &PathChain::ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.01], [0.0, 1.0]]),
            &[[0.5, 1.01], [0.0, 0.0]],
        );
        assert_eq!(ring.is_corner, [true, false, false, true, false]);
    }

    #[test]
    fn clockwise_ring_begins_at_a_corner() {
        let ring = CorneredRing::new(
            &PathChain::ring(&[[0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]]),
            &[],
        )
        .into_clockwise();
        assert!(signed_area(&ring.points) < 0.0);
        assert!(ring.is_corner[0]);
        assert_eq!(ring.points[0], [0.0, 0.0]);
    }

    #[test]
    fn round_outline_gets_four_corners() {
        let points: Vec<Point2> = (0..90)
            .map(|i| f64::from(i) * 4.0_f64.to_radians())
            .map(|a| [a.cos(), a.sin()])
            .collect();
        let ring = CorneredRing::new(&PathChain::ring(&points), &[]).into_clockwise();
        assert_eq!(ring.is_corner.iter().filter(|c| **c).count(), 4);
    }
}
