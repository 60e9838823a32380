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
    /// Returns the unit vector inwards.
    fn inwards(&self) -> Point2 {
        [self.along[1], -self.along[0]]
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
        let line = |(i, (edge, [a, b])): (usize, (usize, [Point2; 2]))| {
            let long = distance(a, b);
            MovingSegment {
                edge,
                ends: [a, b],
                along: [(b[0] - a[0]) / long, (b[1] - a[1]) / long],
                previous: (i + count - 1) % count,
                next: (i + 1) % count,
                is_gone: false,
            }
        };
        Self(segments.into_iter().enumerate().map(line).collect())
    }

    /// Checks that no corner juts into the cloth too sharply for a miter.
    pub(super) fn check_corners(&self, panel: &Panel) -> Result<(), Fault> {
        for line in &self.0 {
            let before = &self.0[line.previous];
            let turn = cross(before.along, line.along).atan2(dot(before.along, line.along));
            if turn > 0.0 && (0.5 * turn).cos() * MITER < 1.0 {
                let [x, y] = line.ends[0];
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

    /// Returns the point where segments `i` and `k`, neighbors, meet when the outline has moved by `t`.
    fn meeting(&self, i: usize, k: usize, t: f64) -> Point2 {
        let (a, b) = (&self.0[i], &self.0[k]);
        let moved = |line: &MovingSegment, end: usize| {
            let inwards = line.inwards();
            [0, 1].map(|c| line.ends[end][c] + t * inwards[c])
        };
        let (p, q) = (moved(a, 1), moved(b, 0));
        let sine = cross(a.along, b.along);
        if sine.abs() < PARALLEL {
            return [0, 1].map(|c| f64::midpoint(p[c], q[c]));
        }
        let s = cross(sub(q, p), b.along) / sine;
        [0, 1].map(|c| p[c] + s * a.along[c])
    }

    /// Returns the way that the outline moves until segment `i` has shrunk to nothing; infinite for one
    /// that does not shrink.
    fn vanishing_way(&self, i: usize) -> f64 {
        /// The length is linear in the way gone: two ways determine it \[m\].
        const STEP: f64 = 0.01;
        let line = &self.0[i];
        let long = |t| {
            let ends = sub(
                self.meeting(i, line.next, t),
                self.meeting(line.previous, i, t),
            );
            dot(ends, line.along)
        };
        let (now, then) = (long(0.0), long(STEP));
        if then < now {
            STEP * now / (now - then)
        } else {
            f64::INFINITY
        }
    }

    /// Leaves out the segments that shrink to nothing within `width`, in that order.
    pub(super) fn advance(&mut self, width: f64) {
        let mut ends: Vec<f64> = (0..self.0.len()).map(|i| self.vanishing_way(i)).collect();
        let event = |t: f64, i: usize| Reverse((OrderedWay(t), i));
        let soon = (0..self.0.len()).filter(|i| ends[*i] <= width);
        let mut events: BinaryHeap<_> = soon.map(|i| event(ends[i], i)).collect();
        let mut remaining = self.0.len();
        while let Some(Reverse((OrderedWay(t), i))) = events.pop() {
            if self.0[i].is_gone || t != ends[i] || remaining < 3 {
                continue;
            }
            let (previous, next) = (self.0[i].previous, self.0[i].next);
            self.0[i].is_gone = true;
            self.0[previous].next = next;
            self.0[next].previous = previous;
            remaining -= 1;
            for k in [previous, next] {
                // What would have ended before now ends now: its neighbor was in the way.
                ends[k] = self.vanishing_way(k).max(t);
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

/// A way gone, ordered.
#[derive(PartialEq)]
struct OrderedWay(f64);

impl Eq for OrderedWay {}

impl PartialOrd for OrderedWay {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for OrderedWay {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
