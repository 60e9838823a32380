//! Darts inside a panel, also called fish-eye or diamond darts: narrow rings with two tips.

use super::point::{Point2, cross, distance, dot, sub, turn};
use super::polyline::length;
use std::f64::consts::PI;

/// A dart is so long \[m\], so wide \[m\], and at most this share of its length wide.
const LENGTH: [f64; 2] = [0.05, 0.5];
const WIDTH: [f64; 2] = [0.004, 0.07];
const WIDEST: f64 = 0.35;

/// Its widest places lie opposite each other, to this share of its length; those of a slanting welt
/// do not.
const MOST_ASKEW: f64 = 0.2;

/// A ring turns at a tip by at least this; a welt turns by a right angle \[rad\].
const TIP_TURN: f64 = 0.58 * PI;

/// Sides and legs of a dart are as long as each other up to this share.
const MOST_DIFFERENCE: f64 = 0.04;

/// Returns the indices of the tips of a ring that is a dart, in order.
pub(crate) fn tips(ring: &[Point2]) -> Option<[usize; 2]> {
    let sharp: Vec<usize> = (0..ring.len()).filter(|i| is_tip(ring, *i)).collect();
    let &[a, b] = sharp.as_slice() else {
        return None;
    };
    let long = distance(ring[a], ring[b]);
    let there = &ring[a..=b];
    let back = [&ring[b..], &ring[..=a]].concat();
    let axis = sub(ring[b], ring[a]).map(|c| c / long);
    let widest = |side: &[Point2]| {
        let of_axis = |p: &Point2| {
            let from_tip = sub(*p, ring[a]);
            (cross(axis, from_tip), dot(axis, from_tip))
        };
        let further = |p: (f64, f64), q: (f64, f64)| if q.0.abs() > p.0.abs() { q } else { p };
        side.iter().map(of_axis).fold((0.0, 0.0), further)
    };
    let [(left, left_at), (right, right_at)] = [widest(there), widest(&back)];
    let width = (left - right).abs();
    let is_dart = within(long, LENGTH)
        && within(width, WIDTH)
        && width <= WIDEST * long
        && left * right < 0.0
        && (left_at - right_at).abs() <= MOST_ASKEW * long
        && agree(length(there), length(&back));
    is_dart.then_some([a, b])
}

/// Returns true if two lengths are those of the legs of one dart.
pub(crate) fn agree(a: f64, b: f64) -> bool {
    (a - b).abs() <= MOST_DIFFERENCE * a.max(b)
}

/// Returns true if a value lies between two.
pub(crate) fn within(value: f64, [least, most]: [f64; 2]) -> bool {
    (least..=most).contains(&value)
}

fn is_tip(ring: &[Point2], i: usize) -> bool {
    let n = ring.len();
    turn(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]).abs() >= TIP_TURN
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A diamond, a lens of two parabolas; welts, a wide diamond and a crescent are none.
    #[test]
    fn narrow_rings_with_two_tips_are_darts() {
        let diamond = [[0.0, 0.0], [0.01, 0.1], [0.0, 0.2], [-0.01, 0.1]];
        assert_eq!(tips(&diamond), Some([0, 2]));
        let side = |sign: f64| {
            move |i: i32| {
                let t = f64::from(i) / 20.0;
                [sign * 0.06 * t * (1.0 - t), 0.2 * t]
            }
        };
        let up = (0..20).map(side(1.0));
        let lens: Vec<Point2> = up.chain((1..=20).rev().map(side(-1.0))).collect();
        assert_eq!(tips(&lens), Some([0, 20]));
        let welt = [[0.0, 0.0], [0.012, 0.0], [0.012, 0.14], [0.0, 0.14]];
        assert_eq!(tips(&welt), None);
        let slanting = [[0.0, 0.0], [0.1, 0.0], [0.1073, 0.02], [0.0073, 0.02]];
        assert_eq!(tips(&slanting), None);
        let wide = [[0.0, 0.0], [0.06, 0.1], [0.0, 0.2], [-0.06, 0.1]];
        assert_eq!(tips(&wide), None);
        let crescent = [[0.0, 0.0], [0.03, 0.1], [0.0, 0.2], [0.02, 0.1]];
        assert_eq!(tips(&crescent), None);
    }
}
