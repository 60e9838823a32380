//! The interior of an outline: its roomiest place, its reach to either side, its axis of symmetry.

use crate::pattern::point::{Point2, cross, distance, dot, sub};
use crate::pattern::polyline::{bounds, contains, nearest, segments};

/// The most points of an outline that are looked at; more would only take time.
const MOST_POINTS: usize = 400;

/// Rows and columns of places that are tried.
const GRID: u32 = 24;

/// Thins an outline to at most [`MOST_POINTS`] points.
pub(super) fn coarse(ring: &[Point2]) -> Vec<Point2> {
    let step = ring.len().div_ceil(MOST_POINTS).max(1);
    ring.iter().step_by(step).copied().collect()
}

/// Weight of the distance to the middle against that to the outline, for one place to be better
/// than another.
const TO_MIDDLE: f64 = 0.15;

/// Returns a place inside that is far from the outline and holes, with its distance; of places
/// alike, the one nearest to the middle. Returns none if no place tried is inside.
pub(super) fn roomiest(ring: &[Point2], holes: &[Vec<Point2>]) -> Option<(Point2, f64)> {
    let [low, high] = bounds(ring);
    let at =
        |k: usize, i: u32| low[k] + (high[k] - low[k]) * (f64::from(i) + 0.5) / f64::from(GRID);
    let places = (0..GRID).flat_map(|i| (0..GRID).map(move |k| (i, k)));
    let free = |p: Point2| {
        if !contains(ring, p) || holes.iter().any(|hole| contains(hole, p)) {
            return None;
        }
        let rings = std::iter::once(ring).chain(holes.iter().map(Vec::as_slice));
        let lines = rings.flat_map(segments);
        nearest(lines, p).map(|found| (p, found.distance))
    };
    let middle = [0, 1].map(|k| f64::midpoint(low[k], high[k]));
    let worth = |(p, room): &(Point2, f64)| room - TO_MIDDLE * distance(*p, middle);
    places
        .filter_map(|(i, k)| free([at(0, i), at(1, k)]))
        .max_by(|a, b| worth(a).total_cmp(&worth(b)))
}

/// Returns the distances from `from` (inside) along `way` and against it to the outline or a hole.
pub(super) fn reach(rings: &[&[Point2]], from: Point2, way: Point2) -> [f64; 2] {
    let mut reach = [f64::INFINITY; 2];
    for (a, b) in rings.iter().flat_map(|ring| segments(ring)) {
        let (d, e) = (sub(b, a), sub(a, from));
        let sine = cross(way, d);
        if sine == 0.0 {
            continue;
        }
        let (along, on) = (cross(e, d) / sine, cross(e, way) / sine);
        if (0.0..=1.0).contains(&on) {
            let side = usize::from(along < 0.0);
            reach[side] = reach[side].min(along.abs());
        }
    }
    reach
}

/// Returns the ends of the line about which an outline is its own mirror image; of two, the one
/// nearer to `wanted` (a direction).
pub(super) fn axis(ring: &[Point2], wanted: Point2, within: f64) -> Option<[Point2; 2]> {
    let (center, turn) = principal(ring)?;
    let unit = |angle: f64| [angle.cos(), angle.sin()];
    let quarter = std::f64::consts::FRAC_PI_4;
    // Where the two moments are alike every direction is principal: the usual ones are tried too.
    let angles = [
        turn,
        turn + 2.0 * quarter,
        0.0,
        2.0 * quarter,
        quarter,
        -quarter,
    ];
    let images = |way: Point2| {
        let points = coarse(ring);
        points.into_iter().all(|p| {
            let d = sub(p, center);
            let along = dot(d, way);
            let image = [0, 1].map(|k| center[k] + 2.0 * along * way[k] - d[k]);
            nearest(segments(ring), image).is_some_and(|found| found.distance <= within)
        })
    };
    let symmetric = angles.into_iter().map(unit).filter(|way| images(*way));
    let way = symmetric.max_by(|a, b| dot(*a, wanted).abs().total_cmp(&dot(*b, wanted).abs()))?;
    let at = segments(ring).filter_map(|(a, b)| {
        let (d, e) = (sub(b, a), sub(a, center));
        let sine = cross(way, d);
        let on = cross(e, way) / sine;
        (sine != 0.0 && (0.0..=1.0).contains(&on)).then(|| cross(e, d) / sine)
    });
    let [low, high] = at.fold([f64::INFINITY, f64::NEG_INFINITY], |b, s| {
        [b[0].min(s), b[1].max(s)]
    });
    let place = |s: f64| [0, 1].map(|k| center[k] + s * way[k]);
    (low < high).then(|| [place(low), place(high)])
}

/// Returns the center of area of an outline and the angle of one of its principal axes \[radians\].
fn principal(ring: &[Point2]) -> Option<(Point2, f64)> {
    let origin = *ring.first()?;
    let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
    for (a, b) in segments(ring) {
        let (a, b) = (sub(a, origin), sub(b, origin));
        let twice = cross(a, b);
        area += twice / 2.0;
        for k in 0..2 {
            first[k] += twice * (a[k] + b[k]) / 6.0;
            second[k] += twice * (a[k] * a[k] + a[k] * b[k] + b[k] * b[k]) / 12.0;
        }
        let mixed = a[0] * b[1] + 2.0 * a[0] * a[1] + 2.0 * b[0] * b[1] + b[0] * a[1];
        second[2] += twice * mixed / 24.0;
    }
    if area == 0.0 {
        return None;
    }
    let c = first.map(|m| m / area);
    let [xx, yy] = [0, 1].map(|k| second[k] / area - c[k] * c[k]);
    let xy = second[2] / area - c[0] * c[1];
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    Some(([c[0] + origin[0], c[1] + origin[1]], angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KITE: [Point2; 4] = [[0.0, -3.0], [-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]];

    fn turned(points: &[Point2], angle: f64) -> Vec<Point2> {
        let (sin, cos) = angle.sin_cos();
        let turn = |[x, y]: &Point2| [5.0 + cos * x - sin * y, 7.0 + sin * x + cos * y];
        points.iter().map(turn).collect()
    }

    #[test]
    fn axis_of_symmetry_is_found_however_the_panel_lies() {
        for angle in [0.0_f64, 0.3, 1.2, 2.0] {
            let found = axis(&turned(&KITE, angle), [0.0, 1.0], 1e-6).expect("a kite has one");
            let ends = turned(&[KITE[0], KITE[2]], angle);
            for end in ends {
                let near = found
                    .iter()
                    .any(|p| (p[0] - end[0]).hypot(p[1] - end[1]) < 1e-9);
                assert!(near, "{angle} {found:?} {end:?}");
            }
        }
        let skew = [[0.0, 0.0], [0.0, 1.0], [2.0, 1.0], [3.0, 0.0]];
        assert_eq!(axis(&skew, [0.0, 1.0], 1e-6), None);
        let [a, b] = axis(
            &[[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]],
            [1.0, 0.1],
            1e-6,
        )
        .expect("a square has four");
        assert!((a[1] - b[1]).abs() < 1e-9, "the one along x");
    }

    #[test]
    fn the_roomiest_place_is_off_the_holes() {
        let square = [[0.0, 0.0], [0.0, 10.0], [10.0, 10.0], [10.0, 0.0]];
        let (at, room) = roomiest(&square, &[]).expect("inside");
        assert!((room - 5.0).abs() < 0.5, "{at:?} {room}");
        let hole = vec![[3.0, 3.0], [9.0, 3.0], [9.0, 9.0], [3.0, 9.0]];
        let (at, room) = roomiest(&square, &[hole]).expect("inside");
        assert!(at[0].min(at[1]) < 3.0 && room > 1.0, "{at:?} {room}");
    }

    #[test]
    fn reach_ends_at_the_nearest_line_on_either_side() {
        let square: [Point2; 4] = [[0.0, 0.0], [0.0, 10.0], [10.0, 10.0], [10.0, 0.0]];
        let found = reach(&[&square], [3.0, 4.0], [1.0, 0.0]);
        assert_eq!(found, [7.0, 3.0]);
    }
}
