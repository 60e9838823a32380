//! Notches, drill holes, grain and fold.

use super::interior::{axis, reach};
use super::markup::{number, path};
use super::style::{FOLD_LINE, GRAIN_LINE, MARK};
use crate::pattern::point::Point2;
use crate::pattern::{Notch, NotchKind};

/// An outline may be off its mirror image by this \[mm\]: a half is unfolded about a line to which
/// its ends were 0.2 near.
const SYMMETRIC: f64 = 0.5;

/// Draws a notch at a place of an outline, cut inwards.
pub(super) fn notch(notch: &Notch, at: Point2, inwards: Point2, figure: f64) -> String {
    let deep = notch
        .depth_m
        .map_or(0.0, |depth| 1e3 * depth)
        .max(0.8 * figure);
    let along = [inwards[1], -inwards[0]];
    let place = |a: f64, d: f64| [0, 1].map(|k| at[k] + deep * (a * along[k] + d * inwards[k]));
    let line = |places: &[(f64, f64)]| {
        let points: Vec<Point2> = places.iter().map(|(a, d)| place(*a, *d)).collect();
        path(&points, false)
    };
    let data = match notch.kind {
        NotchKind::V => line(&[(-0.4, 0.0), (0.0, 1.0), (0.4, 0.0)]),
        NotchKind::T => line(&[(0.0, 0.0), (0.0, 1.0)]) + &line(&[(-0.4, 1.0), (0.4, 1.0)]),
        NotchKind::Castle => line(&[(-0.3, 0.0), (-0.3, 1.0), (0.3, 1.0), (0.3, 0.0)]),
        NotchKind::Check => line(&[(0.0, 0.0), (0.0, 1.0), (0.6, 0.0)]),
        NotchKind::U => line(&[
            (-0.4, 0.0),
            (-0.4, 0.6),
            (-0.2, 0.95),
            (0.2, 0.95),
            (0.4, 0.6),
            (0.4, 0.0),
        ]),
        NotchKind::Slit => line(&[(0.0, 0.0), (0.0, 1.0)]),
    };
    MARK.path(&data, figure)
}

/// Draws a hole drilled through the cloth: a ring with a cross.
pub(super) fn drill(at: Point2, figure: f64) -> String {
    let r = 0.3 * figure;
    let [x, y] = at.map(number);
    let circle = format!(
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"none\"{}/>\n",
        number(r),
        MARK.attributes(figure)
    );
    let cross = [[r, 0.0], [0.0, r]].map(|[dx, dy]| {
        path(
            &[
                [at[0] - 2.0 * dx, at[1] - 2.0 * dy],
                [at[0] + 2.0 * dx, at[1] + 2.0 * dy],
            ],
            false,
        )
    });
    circle + &MARK.path(&cross.concat(), figure)
}

/// Returns the line about which a panel was unfolded; of two possible ones that along the grain.
pub(super) fn fold(ring: &[Point2], grain: Point2) -> Option<[Point2; 2]> {
    axis(ring, grain, SYMMETRIC)
}

/// Draws the fold.
pub(super) fn fold_line(fold: [Point2; 2], figure: f64) -> String {
    FOLD_LINE.line(&fold, false, figure)
}

/// Draws the direction of the warp as an arrow with two heads about a place inside.
pub(super) fn grain(rings: &[&[Point2]], about: Point2, way: Point2, figure: f64) -> String {
    let [forth, back] = reach(rings, about, way);
    let half = (0.8 * forth.min(back)).min(12.0 * figure);
    if half <= figure {
        return String::new();
    }
    let aside = [-way[1], way[0]];
    let place = |a: f64, s: f64| [0, 1].map(|k| about[k] + a * way[k] + s * aside[k]);
    let head = |sign: f64| {
        let base = sign * (half - 0.9 * figure);
        path(
            &[
                place(base, 0.4 * figure),
                place(sign * half, 0.0),
                place(base, -0.4 * figure),
            ],
            false,
        )
    };
    let shaft = path(&[place(-half, 0.0), place(half, 0.0)], false);
    GRAIN_LINE.path(&(shaft + &head(1.0) + &head(-1.0)), figure)
}
