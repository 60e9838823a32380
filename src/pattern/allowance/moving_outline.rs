//! An outline that moves inwards: its edge events, in order, and the rest of each edge.

use super::faults::{nothing_left, refuse};
use crate::fault::Fault;
use crate::pattern::point::{Point2, cross, distance, dot, sub};
use crate::pattern::polyline::length;
use crate::pattern::{Edge, Panel};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Segments whose directions differ by less than this meet nowhere that counts \[radians\].
const PARALLEL: f64 = 1e-9;

/// A corner that juts into the cloth may move by so many widths at most: beyond, it is a slit.
const MITER: f64 = 5.0;

/// A segment of the outline, which moves along its inward normal.
struct MovingSegment {
    edge: usize,
    /// Its ends as drawn.
    ends: [Point2; 2],
    /// Unit vector along it, clockwise; inwards is to its right.
    along: Point2,
    previous: usize,
    next: usize,
    is_gone: bool,
}

impl MovingSegment {
    /// Returns one of its ends when it has moved by `t`.
    fn end_at(&self, end: usize, t: f64) -> Point2 {
        let inwards = [self.along[1], -self.along[0]];
        [0, 1].map(|c| self.ends[end][c] + t * inwards[c])
    }
}

/// An outline that moves inwards: segments in a ring.
pub(super) struct MovingOutline(Vec<MovingSegment>);

impl MovingOutline {
    /// Returns the outline of edges before it moves.
    pub(super) fn of(edges: &[Edge]) -> Self {
        let segments = edges.iter().flat_map(|edge| {
            let pairs = edge.points.windows(2);
            let pairs = pairs.filter(|pair| pair[0] != pair[1]);
            pairs.map(|pair| (edge.index, [pair[0], pair[1]]))
        });
        let segments: Vec<(usize, [Point2; 2])> = segments.collect();
        let count = segments.len();
        let segments = segments.into_iter().enumerate();
        let moving = segments.map(|(i, (edge, [a, b]))| MovingSegment {
            edge,
            ends: [a, b],
            along: sub(b, a).map(|c| c / distance(a, b)),
            previous: (i + count - 1) % count,
            next: (i + 1) % count,
            is_gone: false,
        });
        Self(moving.collect())
    }

    /// Checks that no corner juts into the cloth too sharply for a miter.
    pub(super) fn check_corners(&self, panel: &Panel) -> Result<(), Fault> {
        for segment in &self.0 {
            let before = &self.0[segment.previous];
            let (cross, dot) = (
                cross(before.along, segment.along),
                dot(before.along, segment.along),
            );
            let turn = cross.atan2(dot);
            if turn > 0.0 && (0.5 * turn).cos() * MITER < 1.0 {
                let [x, y] = segment.ends[0];
                let detail = format!(
                    "panel {} has a slit that ends at ({x:.4}, {y:.4}): there is no allowance to cut away there",
                    panel.id
                );
                let fix = "give the panel with its sew line, and no allowance";
                return Err(refuse(detail, fix));
            }
        }
        Ok(())
    }

    /// Returns the point where segments `i` and `k`, neighbors, meet when the outline has moved by
    /// `t`.
    fn meeting(&self, i: usize, k: usize, t: f64) -> Point2 {
        let (a, b) = (&self.0[i], &self.0[k]);
        let (p, q) = (a.end_at(1, t), b.end_at(0, t));
        let sine = cross(a.along, b.along);
        if sine.abs() < PARALLEL {
            return [0, 1].map(|c| f64::midpoint(p[c], q[c]));
        }
        let s = cross(sub(q, p), b.along) / sine;
        [0, 1].map(|c| p[c] + s * a.along[c])
    }

    /// Returns the length of segment `i` when the outline has moved by `t`; it is linear in `t`.
    fn length_at(&self, i: usize, t: f64) -> f64 {
        let segment = &self.0[i];
        let end = self.meeting(i, segment.next, t);
        dot(
            sub(end, self.meeting(segment.previous, i, t)),
            segment.along,
        )
    }

    /// Returns the distance by which the outline moves until segment `i` has shrunk to nothing;
    /// infinite for one that does not shrink.
    fn collapse_distance(&self, i: usize) -> f64 {
        /// A distance that, with 0, determines the length \[m\].
        const STEP: f64 = 0.01;
        let (now, then) = (self.length_at(i, 0.0), self.length_at(i, STEP));
        if then < now {
            STEP * now / (now - then)
        } else {
            f64::INFINITY
        }
    }

    /// Leaves out the segments that shrink to nothing within `width`, in that order.
    pub(super) fn advance(&mut self, width: f64) {
        let mut ends: Vec<f64> = (0..self.0.len())
            .map(|i| self.collapse_distance(i))
            .collect();
        let event = |t: f64, i: usize| Reverse((OrderedDistance(t), i));
        let soon = (0..self.0.len()).filter(|i| ends[*i] <= width);
        let mut events: BinaryHeap<_> = soon.map(|i| event(ends[i], i)).collect();
        let mut remaining = self.0.len();
        while let Some(Reverse((OrderedDistance(t), i))) = events.pop() {
            if self.0[i].is_gone || t != ends[i] || remaining < 3 {
                continue;
            }
            let (previous, next) = (self.0[i].previous, self.0[i].next);
            self.0[i].is_gone = true;
            self.0[previous].next = next;
            self.0[next].previous = previous;
            remaining -= 1;
            for k in [previous, next] {
                // A segment whose end has passed ends now: its neighbor was in between.
                ends[k] = self.collapse_distance(k).max(t);
                if ends[k] <= width {
                    events.push(event(ends[k], k));
                }
            }
        }
    }

    /// Returns the edges of the outline after `width`.
    pub(super) fn edges(&self, panel: &Panel, width: f64) -> Result<Vec<Edge>, Fault> {
        let mut points: Vec<Vec<Point2>> = vec![Vec::new(); panel.edges.len()];
        for (i, line) in self.0.iter().enumerate().filter(|(_, line)| !line.is_gone) {
            points[line.edge].push(self.meeting(line.previous, i, width));
        }
        if points.iter().all(Vec::is_empty) {
            return Err(nothing_left(panel, width));
        }
        let starts: Vec<Option<Point2>> = points.iter().map(|edge| edge.first().copied()).collect();
        let count = points.len();
        for (i, edge) in points.iter_mut().enumerate() {
            edge.extend(starts[(i + 1) % count]);
            edge.dedup();
        }
        let empty = |i: &usize| starts[*i].is_none();
        let short = |i: &usize| points[*i].len() < 2;
        if let Some(gone) = (0..count).find(empty).or_else(|| (0..count).find(short)) {
            let detail = format!(
                "with {width} m cut away, nothing of edge {gone} of panel {} is left",
                panel.id
            );
            return Err(refuse(detail, "give a smaller allowance"));
        }
        let edge = |(old, points): (&Edge, Vec<Point2>)| Edge {
            length_m: length(&points),
            points,
            ..old.clone()
        };
        Ok(panel.edges.iter().zip(points).map(edge).collect())
    }
}

/// A distance, ordered.
#[derive(PartialEq)]
struct OrderedDistance(f64);

impl Eq for OrderedDistance {}

impl PartialOrd for OrderedDistance {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for OrderedDistance {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
