//! A chain: paths joined head to tail to one polyline.

use super::gap::Gap;
use crate::pattern::Point2;
use crate::pattern::dxf::entity::geometry::EntityPath;
use crate::pattern::point::distance;

/// Ends closer than this are one point: CAD rounds coordinates to 1e-4 mm or 1e-4 inch (3 um)
/// \[m\].
pub(super) const JOINED: f64 = 3e-6;

/// The key that tells one chain of a sheet from all others: the line of its first path and its
/// first point (a block that is put in twice has the same lines again).
pub(super) type ChainKey = (usize, Option<[u64; 2]>);

/// Paths joined to one polyline.
#[derive(Clone, Debug)]
pub(crate) struct PathChain {
    /// Its points; a closed chain does not repeat the first.
    pub(crate) points: Vec<Point2>,
    /// Point by point, true if it is the end of a path that tells of a corner.
    pub(crate) path_end: Vec<bool>,
    /// Point by point, true if it is not of the file but a sample of a curve.
    pub(crate) sampled: Vec<bool>,
    /// True if the last point runs on to the first.
    pub(crate) closed: bool,
    /// Gaps between its paths that were closed, those above the rounding of CAD, in its order.
    pub(super) gaps: Vec<Gap>,
    /// The line its first path begins at.
    pub(crate) line: usize,
    /// Number of entities that it was joined of.
    pub(crate) path_count: usize,
}

impl PathChain {
    /// Returns the chain of a single path; one whose ends meet is closed and has no path end there.
    pub(super) fn of_path(path: &EntityPath, line: usize) -> Self {
        let mut points = path.points.clone();
        let ends = points.first().zip(points.last());
        let meets = points.len() > 2 && ends.is_some_and(|(a, b)| distance(*a, *b) <= JOINED);
        if meets {
            points.pop();
        }
        let closed = path.closed || meets;
        let mut sampled = path.sampled.clone();
        sampled.resize(points.len(), false);
        let mut path_end = vec![false; points.len()];
        if let (false, Some(last)) = (closed, points.len().checked_sub(1)) {
            path_end[0] = true;
            path_end[last] = true;
        }
        Self {
            points,
            path_end,
            sampled,
            closed,
            gaps: vec![],
            line,
            path_count: 1,
        }
    }

    /// Returns its key.
    pub(super) fn key(&self) -> ChainKey {
        let first = self.points.first();
        (self.line, first.map(|p| p.map(f64::to_bits)))
    }

    /// Turns it round.
    pub(super) fn reverse(&mut self) {
        self.points.reverse();
        self.path_end.reverse();
        self.sampled.reverse();
        self.gaps.reverse();
    }

    /// Adds another chain across a gap, from that one's second point on.
    pub(super) fn append(&mut self, other: &Self, gap: Gap) {
        self.path_count += other.path_count;
        self.note_gap(gap);
        self.gaps.extend(&other.gaps);
        self.points.extend(&other.points[1..]);
        self.path_end.extend(&other.path_end[1..]);
        self.sampled.extend(&other.sampled[1..]);
    }

    /// Closes it across a gap: its last point becomes its first.
    pub(super) fn close(&mut self, gap: Gap) {
        self.closed = true;
        self.note_gap(gap);
        self.points.pop();
        self.sampled.pop();
        if let (Some(end), Some(start)) = (self.path_end.pop(), self.path_end.first_mut()) {
            *start |= end;
        }
    }

    fn note_gap(&mut self, gap: Gap) {
        if gap.size() > JOINED {
            self.gaps.push(gap);
        }
    }
}

#[cfg(test)]
impl PathChain {
    /// A closed chain of one path, all of whose points are of the file.
    pub(super) fn ring(points: &[Point2]) -> Self {
        Self {
            points: points.to_vec(),
            path_end: vec![false; points.len()],
            sampled: vec![false; points.len()],
            closed: true,
            gaps: vec![],
            line: 1,
            path_count: 1,
        }
    }
}
