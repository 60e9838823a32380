//! The free ends of open chains, found by place.

use super::chain::{JOINED, PathChain};
use crate::pattern::Point2;
use crate::pattern::point::distance;
use std::cmp::Ordering;

/// At most this many free ends of three cells are compared: a drawing with more ends in a
/// millimeter has no right choice among them.
const COMPARED: usize = 30;

/// At most this many ends of three cells that are taken are passed over.
const PASSED: usize = 200;

/// An end that a chain may be joined to.
#[derive(Clone, Copy)]
pub(super) struct NearEnd {
    /// Index of the part.
    pub(super) part: usize,
    /// True if it is the head of the part.
    pub(super) is_head: bool,
    /// Its distance \[m\].
    pub(super) gap: f64,
}

impl NearEnd {
    /// Orders nearest first (ends that CAD rounded apart count as equally near), then in file
    /// order, then head before tail.
    fn order(&self, other: &Self) -> Option<Ordering> {
        self.key().partial_cmp(&other.key())
    }

    fn key(&self) -> (f64, usize, bool) {
        let gap = if self.gap <= JOINED { 0.0 } else { self.gap };
        (gap, self.part, !self.is_head)
    }
}

/// An end in its cell of a grid.
struct CellEnd {
    cell: (i64, i64),
    part: usize,
    is_head: bool,
}

/// The free ends of open parts, sorted by the cell of a grid that they lie in.
pub(super) struct FreeEnds {
    /// Size of a cell: the tolerance \[m\].
    cell_size: f64,
    /// Part by part, true if it is free.
    free: Vec<bool>,
    ends: Vec<CellEnd>,
    /// The first place in `ends` that may be free, from each of them on.
    first_free: Vec<usize>,
}

impl FreeEnds {
    /// Returns the ends of all open parts, none of which is taken.
    pub(super) fn new(parts: &[PathChain], tolerance: f64) -> Self {
        let mut ends = Vec::new();
        for (part, chain) in parts.iter().enumerate().filter(|(_, chain)| !chain.closed) {
            for (point, is_head) in [(chain.points.first(), true), (chain.points.last(), false)] {
                ends.extend(point.map(|p| CellEnd {
                    cell: cell_of(*p, tolerance),
                    part,
                    is_head,
                }));
            }
        }
        // Stable, so that the ends of a cell stay in the order of the file.
        ends.sort_by_key(|end| end.cell);
        Self {
            cell_size: tolerance,
            free: parts.iter().map(|chain| !chain.closed).collect(),
            first_free: (0..ends.len()).collect(),
            ends,
        }
    }

    /// Takes a part out; false where it was taken before.
    pub(super) fn take(&mut self, part: usize) -> bool {
        std::mem::replace(&mut self.free[part], false)
    }

    /// Returns the free end nearest to `p` within the tolerance; of several equally near ones, the
    /// first in file order.
    pub(super) fn nearest(&mut self, p: Point2, parts: &[PathChain]) -> Option<NearEnd> {
        let near = self.near(p, parts).into_iter();
        near.reduce(|best, found| match found.order(&best) {
            Some(Ordering::Less) => found,
            _ => best,
        })
    }

    /// Returns the free ends within the tolerance of `p`, as many as are compared.
    pub(super) fn near(&mut self, p: Point2, parts: &[PathChain]) -> Vec<NearEnd> {
        let (x, y) = cell_of(p, self.cell_size);
        let mut near = Vec::new();
        for dx in -1..=1 {
            for (part, is_head) in self.in_column(x.saturating_add(dx), y) {
                let points = &parts[part].points;
                let end = if is_head {
                    points.first()
                } else {
                    points.last()
                };
                let gap = end.map_or(f64::INFINITY, |end| distance(p, *end));
                if gap <= self.cell_size {
                    near.push(NearEnd { part, is_head, gap });
                }
            }
        }
        near
    }

    /// Returns the first free ends of a cell and of those below and above it, which lie together.
    fn in_column(&mut self, x: i64, y: i64) -> Vec<(usize, bool)> {
        let (low, high) = ((x, y.saturating_sub(1)), (x, y.saturating_add(1)));
        let start = self.ends.partition_point(|end| end.cell < low);
        let is_here = |i: usize| self.ends.get(i).is_some_and(|end| end.cell <= high);
        if !is_here(start) {
            return Vec::new();
        }
        let mut from = self.first_free[start];
        while is_here(from) && !self.free[self.ends[from].part] {
            from += 1;
        }
        let found = (from..from + PASSED)
            .take_while(|i| is_here(*i))
            .map(|i| (self.ends[i].part, self.ends[i].is_head))
            .filter(|(part, _)| self.free[*part])
            .take(COMPARED)
            .collect();
        self.first_free[start] = from;
        found
    }
}

/// Returns the cell of a grid that a point lies in.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a saturated cell only makes the search slower"
)]
fn cell_of(p: Point2, size: f64) -> (i64, i64) {
    ((p[0] / size).floor() as i64, (p[1] / size).floor() as i64)
}
