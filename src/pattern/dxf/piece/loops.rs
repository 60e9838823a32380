//! Small loops in which outlines cross themselves, as offsets and digitizers leave them.

use super::corners::CorneredRing;
use crate::pattern::Point2;
use crate::pattern::crossing::first_crossing;
use crate::pattern::point::distance;
use crate::pattern::polyline::perimeter;

/// Loops up to this long are cut off: there and back over the width of a seam allowance \[m\].
const LONGEST: f64 = 0.02;

/// At most this many loops of an outline are cut off: one with more is damaged.
const MOST: usize = 16;

/// A loop that was cut off.
pub(super) struct CutLoop {
    /// The point where the outline crossed itself.
    pub(super) point: Point2,
    /// Its length \[m\].
    pub(super) length: f64,
}

/// Cuts off small loops; returns the ring that is left, which may still cross itself.
pub(super) fn cut_off(mut ring: CorneredRing) -> (CorneredRing, Vec<CutLoop>) {
    let mut cut = vec![];
    while let (Some(crossing), true) = (first_crossing(&ring.points), cut.len() < MOST) {
        let [i, j] = crossing.segments;
        let n = ring.points.len();
        if let Some(tip) = spike(i, j, n) {
            let sides =
                [tip + n - 1, tip + 1].map(|k| distance(ring.points[k % n], ring.points[tip]));
            let length = 2.0 * sides[0].min(sides[1]);
            if length > LONGEST || n < 4 {
                break;
            }
            let point = ring.points.remove(tip);
            ring.is_corner.remove(tip);
            cut.push(CutLoop { point, length });
            continue;
        }
        let between: Vec<usize> = (i + 1..=j).collect();
        let around: Vec<usize> = (j + 1..=n + i).map(|k| k % n).collect();
        let length = |side: &[usize]| {
            let points = side.iter().map(|k| ring.points[*k]);
            perimeter(&points.chain([crossing.point]).collect::<Vec<_>>())
        };
        let (short, long) = if length(&between) <= length(&around) {
            (between, around)
        } else {
            (around, between)
        };
        let length = length(&short);
        if length > LONGEST || long.len() < 3 {
            break;
        }
        cut.push(CutLoop {
            point: crossing.point,
            length,
        });
        ring = without(&ring, crossing.point, &short, &long);
    }
    (ring, cut)
}

/// Returns the point between two segments that lie on each other.
fn spike(i: usize, j: usize, n: usize) -> Option<usize> {
    if j == i + 1 {
        return Some(j);
    }
    (i == 0 && j + 1 == n).then_some(0)
}

/// Returns a ring in which a point stands for a loop.
fn without(ring: &CorneredRing, point: Point2, short: &[usize], long: &[usize]) -> CorneredRing {
    let mut left = CorneredRing {
        points: long.iter().map(|k| ring.points[*k]).collect(),
        is_corner: long.iter().map(|k| ring.is_corner[*k]).collect(),
    };
    let is_corner = short.iter().any(|k| ring.is_corner[*k]);
    let is_there = |other: &Point2| distance(*other, point) == 0.0;
    let ends = [0, left.points.len() - 1];
    match ends.into_iter().find(|end| is_there(&left.points[*end])) {
        Some(end) => left.is_corner[end] |= is_corner,
        None => {
            left.points.push(point);
            left.is_corner.push(is_corner);
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::polyline::signed_area;

    fn ring(points: &[Point2]) -> CorneredRing {
        CorneredRing {
            points: points.to_vec(),
            is_corner: vec![true; points.len()],
        }
    }

    #[test]
    fn loop_at_a_corner_is_cut_off() {
        // Two sides that overshoot their corner by 3 mm.
        let drawn = ring(&[
            [0.0, 0.0],
            [0.4, 0.0],
            [0.4, 0.303],
            [0.403, 0.3],
            [0.0, 0.3],
        ]);
        for first in 0..drawn.points.len() {
            let mut drawn = drawn.clone();
            drawn.points.rotate_left(first);
            let (left, cut) = cut_off(drawn);
            assert_eq!(cut.len(), 1);
            assert!(cut[0].length < 0.02);
            assert_eq!(first_crossing(&left.points).map(|c| c.point), None);
            assert!((signed_area(&left.points) - 0.12).abs() < 1e-12);
        }
    }

    #[test]
    fn spike_is_cut_off_whichever_way_it_points() {
        let drawn = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.303], [0.4, 0.3], [0.0, 0.3]];
        for [mirror, turn] in [[1.0, 0.0], [-1.0, 0.0], [1.0, 1.0], [-1.0, 1.0]] {
            let placed = drawn.map(|[x, y]| {
                if turn > 0.0 {
                    [-y, mirror * x]
                } else {
                    [mirror * x, y]
                }
            });
            let (left, cut) = cut_off(ring(&placed));
            assert_eq!(cut.len(), 1);
            assert!((cut[0].length - 0.006).abs() < 1e-12);
            assert!((signed_area(&left.points).abs() - 0.12).abs() < 1e-12);
        }
    }

    #[test]
    fn bow_tie_stays() {
        let drawn = ring(&[[0.0, 0.0], [0.4, 0.4], [0.4, 0.0], [0.0, 0.4]]);
        let (left, cut) = cut_off(drawn);
        assert!(cut.is_empty());
        assert!(first_crossing(&left.points).is_some());
    }
}
