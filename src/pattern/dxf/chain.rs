//! Runs joined head to tail: outlines come as several open runs, in file order or in none.

use super::entity::Path;
use crate::pattern::Point2;
use crate::pattern::point::distance;
use std::cmp::Ordering::Less;

/// Ends closer than this are one point: CAD rounds coordinates to 1e-4 mm or 1e-4 inch (3 um) \[m\].
const JOINED: f64 = 3e-6;

/// Ends closer than this are joined with a warning: a slip of the drawing hand that no cutter would notice \[m\].
const REPAIRED: f64 = 5e-4;

/// Runs joined to one polyline.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Its points; a closed chain does not repeat the first.
    pub(super) points: Vec<Point2>,
    /// Whether the point is the end of a run that says something about corners, point by point.
    pub(super) run_end: Vec<bool>,
    /// Whether the point was made for a curve and is none of the file's, point by point.
    pub(super) made: Vec<bool>,
    /// Whether the last point runs on to the first.
    pub(super) closed: bool,
    /// The largest gap between runs that was closed \[m\], where it was above the rounding of CAD.
    pub(super) repaired: Option<f64>,
    /// The line its first run begins at.
    pub(super) line: usize,
    /// How many entities it was joined of.
    pub(super) runs: usize,
}

impl Chain {
    /// The distance from its last point to its first \[m\].
    pub(super) fn gap(&self) -> f64 {
        match (self.points.first(), self.points.last()) {
            (Some(a), Some(b)) => distance(*a, *b),
            _ => 0.0,
        }
    }
}

/// Joins paths to as few chains as their ends allow, in the order of the file where several would fit. `repair`: small
/// gaps are closed too, as outlines need it.
pub(super) fn chains(paths: &[(&Path, usize)], repair: bool) -> Vec<Chain> {
    let exploded = paths.iter().all(|(path, _)| path.straight);
    let whole: Vec<Chain> = paths
        .iter()
        .filter(|(path, _)| !path.points.is_empty())
        .map(|(path, line)| one(path, *line))
        .collect();
    let mut joined = join(whole, JOINED);
    if repair && joined.iter().any(|chain| !chain.closed) {
        joined = join(joined, REPAIRED);
    }
    for chain in &mut joined {
        if exploded {
            chain.run_end.fill(false);
        }
    }
    joined
}

/// A single path as a chain; one whose ends meet is closed and has no run end there.
fn one(path: &Path, line: usize) -> Chain {
    let mut points = path.points.clone();
    let meets = points.len() > 2
        && points
            .first()
            .zip(points.last())
            .is_some_and(|(a, b)| distance(*a, *b) <= JOINED);
    if meets {
        points.pop();
    }
    let closed = path.closed || meets;
    let mut made = path.made.clone();
    made.resize(points.len(), false);
    let mut run_end = vec![false; points.len()];
    if let (false, Some(last)) = (closed, points.len().checked_sub(1)) {
        run_end[0] = true;
        run_end[last] = true;
    }
    Chain {
        points,
        run_end,
        made,
        closed,
        repaired: None,
        line,
        runs: 1,
    }
}

fn join(parts: Vec<Chain>, tolerance: f64) -> Vec<Chain> {
    let mut ends = Ends::new(&parts, tolerance);
    let mut out = Vec::new();
    for i in 0..parts.len() {
        if parts[i].closed {
            out.push(parts[i].clone());
        } else if ends.take(i) {
            let mut chain = parts[i].clone();
            grow(&mut chain, &parts, &mut ends, tolerance);
            if !chain.closed {
                reverse(&mut chain);
                grow(&mut chain, &parts, &mut ends, tolerance);
                reverse(&mut chain);
            }
            out.push(chain);
        }
    }
    out
}

fn reverse(chain: &mut Chain) {
    chain.points.reverse();
    chain.run_end.reverse();
    chain.made.reverse();
}

/// Adds parts to the end of `chain` until it closes or nothing fits.
fn grow(chain: &mut Chain, parts: &[Chain], ends: &mut Ends, tolerance: f64) {
    loop {
        let (Some(&first), Some(&last)) = (chain.points.first(), chain.points.last()) else {
            return;
        };
        let next = ends.near(last, parts);
        let closing = distance(first, last);
        if chain.points.len() > 2
            && closing <= tolerance
            && next.is_none_or(|(_, _, gap)| closing <= gap)
        {
            chain.closed = true;
            note_gap(chain, closing);
            chain.points.pop();
            chain.made.pop();
            if let (Some(end), Some(start)) = (chain.run_end.pop(), chain.run_end.first_mut()) {
                *start |= end;
            }
            return;
        }
        let Some((index, at_head, gap)) = next else {
            return;
        };
        ends.take(index);
        let mut part = parts[index].clone();
        if !at_head {
            reverse(&mut part);
        }
        chain.runs += part.runs;
        note_gap(chain, gap);
        if let Some(inner) = part.repaired {
            note_gap(chain, inner);
        }
        chain.points.extend(&part.points[1..]);
        chain.run_end.extend(&part.run_end[1..]);
        chain.made.extend(&part.made[1..]);
    }
}

fn note_gap(chain: &mut Chain, gap: f64) {
    if gap > JOINED {
        chain.repaired = Some(chain.repaired.map_or(gap, |other| other.max(gap)));
    }
}

/// At most this many free ends of three cells are compared, and this many passed over that are taken: a drawing with
/// more ends in a millimetre has no right choice among them.
const COMPARED: usize = 30;
const PASSED: usize = 200;

/// The free ends of open parts, sorted by the cell of a grid that they lie in.
struct Ends {
    cell: f64,
    free: Vec<bool>,
    /// Cell, part, and whether it is its head.
    ends: Vec<((i64, i64), usize, bool)>,
    /// Where in `ends` the first may be that is not taken, from each of them on.
    first_free: Vec<usize>,
}

impl Ends {
    fn new(parts: &[Chain], tolerance: f64) -> Self {
        let mut ends = Vec::new();
        for (i, part) in parts.iter().enumerate().filter(|(_, part)| !part.closed) {
            let both = [(part.points.first(), true), (part.points.last(), false)];
            let both = both.into_iter().filter_map(|(p, head)| Some((*p?, head)));
            ends.extend(both.map(|(p, head)| (key(p, tolerance), i, head)));
        }
        // Stable, so that the ends of a cell stay in the order of the file.
        ends.sort_by_key(|end| end.0);
        Self {
            cell: tolerance,
            free: parts.iter().map(|p| !p.closed).collect(),
            first_free: (0..ends.len()).collect(),
            ends,
        }
    }

    /// Takes a part out; false where it was taken before.
    fn take(&mut self, index: usize) -> bool {
        std::mem::replace(&mut self.free[index], false)
    }

    /// The free part with an end nearest to `p` within the tolerance: its index, whether that end is its head, and
    /// the distance. Of several equally near ones, the first in file order.
    fn near(&mut self, p: Point2, parts: &[Chain]) -> Option<(usize, bool, f64)> {
        let (x, y) = key(p, self.cell);
        let mut best: Option<(usize, bool, f64)> = None;
        for dx in -1..=1 {
            for (index, head) in self.in_column(x.saturating_add(dx), y) {
                let points = &parts[index].points;
                let at = if head { points.first() } else { points.last() };
                let found = at.map(|at| (index, head, distance(p, *at)));
                let found = found.filter(|(.., gap)| *gap <= self.cell);
                let nearer = |f: &(usize, bool, f64)| {
                    best.is_none_or(|b| near_order(f).partial_cmp(&near_order(&b)) == Some(Less))
                };
                if let Some(found) = found.filter(nearer) {
                    best = Some(found);
                }
            }
        }
        best
    }

    /// The first free ends of a cell and of those below and above it, which lie together.
    fn in_column(&mut self, x: i64, y: i64) -> Vec<(usize, bool)> {
        let (low, high) = ((x, y.saturating_sub(1)), (x, y.saturating_add(1)));
        let start = self.ends.partition_point(|end| end.0 < low);
        let is_here = |i: usize| self.ends.get(i).is_some_and(|end| end.0 <= high);
        if !is_here(start) {
            return Vec::new();
        }
        let mut from = self.first_free[start];
        while is_here(from) && !self.free[self.ends[from].1] {
            from += 1;
        }
        let found = (from..from + PASSED)
            .take_while(|i| is_here(*i))
            .map(|i| (self.ends[i].1, self.ends[i].2))
            .filter(|(part, _)| self.free[*part])
            .take(COMPARED)
            .collect();
        self.first_free[start] = from;
        found
    }
}

/// The cell of a grid that a point lies in.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a saturated cell only makes the search slower"
)]
fn key(p: Point2, cell: f64) -> (i64, i64) {
    ((p[0] / cell).floor() as i64, (p[1] / cell).floor() as i64)
}

/// PolylineFoot first (ends that CAD rounded apart count as equally near), then file order, then head before tail.
fn near_order(end: &(usize, bool, f64)) -> (f64, usize, bool) {
    (if end.2 <= JOINED { 0.0 } else { end.2 }, end.0, !end.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(points: &[Point2]) -> Path {
        Path {
            points: points.to_vec(),
            closed: false,
            straight: false,
            made: Vec::new(),
        }
    }

    fn joined(paths: &[Path]) -> Vec<Chain> {
        chains(&paths.iter().map(|p| (p, 1)).collect::<Vec<_>>(), true)
    }

    #[test]
    fn runs_in_any_order_and_direction_close() {
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0]]),
            path(&[[0.0, 1.0], [0.0, 0.0]]),
            path(&[[0.0, 1.0], [0.5, 1.5], [1.0, 1.0]]),
            path(&[[1.0, 0.0], [1.0, 1.0]]),
        ]);
        assert_eq!(found.len(), 1);
        assert!(found[0].closed && found[0].repaired.is_none());
        assert_eq!(
            found[0].points,
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.5], [0.0, 1.0]]
        );
        assert_eq!(found[0].run_end, [true, true, true, false, true]);
    }

    #[test]
    fn small_gap_is_closed_and_said() {
        let found = joined(&[
            path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]),
            path(&[[1.0, 1.0002], [0.0, 0.0]]),
        ]);
        assert!(found[0].closed);
        assert!((found[0].repaired.expect("a gap") - 2e-4).abs() < 1e-12);
    }

    #[test]
    fn large_gap_stays_open() {
        let found = joined(&[path(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.05, 0.0]])]);
        assert!(!found[0].closed);
        assert!((found[0].gap() - 0.05).abs() < 1e-12);
    }
}
