//! Seam allowances told from sizes by the distances that a line keeps from the outline about it.

use super::measured::MeasuredChain;
use crate::pattern::Point2;
use crate::pattern::point::{distance, lerp};
use crate::pattern::polyline::{nearest, segments};

/// The width of a seam allowance is a multiple of one of these: millimeters and sixteenths of an
/// inch \[m\] ...
const UNITS_OF_WIDTH: [f64; 2] = [1e-3, 0.0254 / 16.0];
/// ... to within this \[m\].
const ROUND: f64 = 1e-4;

/// Distances that differ by less than this are the same width \[m\].
const SAME_WIDTH: f64 = 4e-4;

/// Of the distances of a seam allowance at least this share are one of few widths.
const ALONG: f64 = 0.85;

/// An allowance has at most this many widths.
const WIDTHS: usize = 3;

/// At most about this many sides of two outlines are compared.
const SAMPLES: usize = 400;

/// Sides that are nearer to each other lie on a fold, where nothing is sewn \[m\].
const FOLD: f64 = 0.001;

/// Returns true if `inner` runs at the distance of a seam allowance inside `outer`: one width all
/// round, or a few round ones. Along a fold there is none.
pub(super) fn is_allowance(outer: &MeasuredChain, inner: &MeasuredChain) -> bool {
    let outline = &outer.chain.points;
    let step = inner.chain.points.len().div_ceil(SAMPLES).max(1);
    let sides = segments(&inner.chain.points).step_by(step);
    let mut sides: Vec<(f64, f64)> = sides
        .map(|(a, b)| (distance_to(outline, lerp(a, b, 0.5)), distance(a, b)))
        .filter(|(width, _)| *width > FOLD)
        .collect();
    sides.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = sides.iter().map(|(_, length)| length).sum();
    // The widths, each with the length along which it is kept.
    let mut widths: Vec<(f64, f64)> = vec![];
    for (width, length) in sides {
        match widths.last_mut() {
            Some((same, along)) if width - *same <= SAME_WIDTH => *along += length,
            _ => widths.push((width, length)),
        }
    }
    widths.sort_by(|a, b| b.1.total_cmp(&a.1));
    widths.truncate(WIDTHS);
    let covers = |widths: &[(f64, f64)]| {
        let along: f64 = widths.iter().map(|(_, along)| along).sum();
        along >= ALONG * total
    };
    let is_one = covers(&widths[..widths.len().min(1)]);
    is_one || covers(&widths) && widths.iter().all(|(width, _)| is_round(*width))
}

/// Returns true if a width is one that allowances have.
fn is_round(width: f64) -> bool {
    let is_multiple = |unit: &f64| (width / unit - (width / unit).round()).abs() * unit <= ROUND;
    UNITS_OF_WIDTH.iter().any(is_multiple)
}

pub(super) fn distance_to(ring: &[Point2], p: Point2) -> f64 {
    nearest(segments(ring), p).map_or(f64::INFINITY, |foot| foot.distance)
}
