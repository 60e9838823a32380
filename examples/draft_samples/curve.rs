//! Lines of a draft: fair curves between two points with given directions, flattened as plotters want them.

/// A point or direction of a drawing \[mm\], y up.
pub(crate) type Point = [f64; 2];

/// Longest chord of a flattened curve \[mm\].
const CHORD: f64 = 10.0;

/// The curve from `start` to `end` that leaves along `along` and arrives along `into`.
///
/// A cubic whose handles are those of a circular arc of the same turn, `1 / (3 cos²(turn / 4))` of the chord, so that
/// a neckline comes out round and a hem nearly so. Both ends are among its points.
pub(crate) fn fair(start: Point, along: Point, end: Point, into: Point) -> Vec<Point> {
    let chord = distance(start, end);
    let (along, into) = (unit(along), unit(into));
    let turn = (along[0] * into[0] + along[1] * into[1])
        .clamp(-1.0, 1.0)
        .acos();
    let handle = chord / (3.0 * (turn / 4.0).cos().powi(2));
    let a = [start[0] + handle * along[0], start[1] + handle * along[1]];
    let b = [end[0] - handle * into[0], end[1] - handle * into[1]];
    let count = (chord / CHORD).ceil().max(1.0);
    let mut points = vec![start];
    let mut i = 1.0;
    while i < count {
        points.push(cubic([start, a, b, end], i / count));
        i += 1.0;
    }
    points.push(end);
    points
}

fn cubic([p0, p1, p2, p3]: [Point; 4], t: f64) -> Point {
    let s = 1.0 - t;
    let at = |k: usize| {
        s * s * s * p0[k] + 3.0 * s * s * t * p1[k] + 3.0 * s * t * t * p2[k] + t * t * t * p3[k]
    };
    [at(0), at(1)]
}

fn unit(v: Point) -> Point {
    let length = v[0].hypot(v[1]);
    [v[0] / length, v[1] / length]
}

/// Distance of two points.
pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Length of a polyline.
pub(crate) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// The same line on the other side of the centre line x = 0, walked the other way.
pub(crate) fn mirrored(points: &[Point]) -> Vec<Point> {
    points.iter().rev().map(|p| [-p[0], p[1]]).collect()
}

/// Two lines in one, the second beginning where the first ends.
pub(crate) fn joined(mut first: Vec<Point>, second: &[Point]) -> Vec<Point> {
    first.extend_from_slice(&second[1..]);
    first
}
