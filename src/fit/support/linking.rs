//! The number of times that a closed curve goes round a path.
//!
//! It is counted where the path passes through a fan of triangles that the curve bounds. For a path
//! without ends, or of which the ends are the same for several curves, differences of these numbers
//! depend neither on the fan nor on the way that the curve takes otherwise (linking numbers).

use nalgebra::Vector3;

/// Place of the fan's tip beside the middle of the curve \[m\]: in no direction in which a body is
/// symmetric, so that no path along its middle meets an edge of the fan.
const BESIDE: Vector3<f64> = Vector3::new(0.003_71, 0.001_93, 0.002_57);

/// Returns how often `path` passes through what the closed polygon `curve` bounds: positive where
/// it does so along the thumb of a right hand whose fingers follow the curve.
pub(super) fn passes(path: &[Vector3<f64>], curve: &[Vector3<f64>]) -> i32 {
    let tip = curve.iter().sum::<Vector3<f64>>() / curve.len().max(1) as f64 + BESIDE;
    let next = curve.iter().cycle().skip(1);
    let edges: Vec<_> = curve.iter().zip(next).collect();
    let legs = path.windows(2);
    legs.map(|leg| {
        let through =
            |(a, b): &(&Vector3<f64>, &Vector3<f64>)| pass([leg[0], leg[1]], [tip, **a, **b]);
        edges.iter().map(through).sum::<i32>()
    })
    .sum()
}

/// Returns 1 if the segment passes through the triangle out of the side on which it is
/// counter-clockwise, -1 if against it, 0 if not at all.
fn pass([p, q]: [Vector3<f64>; 2], [a, b, c]: [Vector3<f64>; 3]) -> i32 {
    let is_above = |x: &Vector3<f64>| volume(&a, &b, &c, x) >= 0.0;
    let (from, to) = (is_above(&p), is_above(&q));
    if from == to {
        return 0;
    }
    // Each edge of the fan is taken in the same direction by both its triangles: neither both nor
    // none of them is hit.
    let ab = volume(&p, &q, &a, &b) >= 0.0;
    let bc = volume(&p, &q, &b, &c) >= 0.0;
    let ac = volume(&p, &q, &a, &c) >= 0.0;
    if ab == bc && bc != ac {
        if to { 1 } else { -1 }
    } else {
        0
    }
}

/// Returns six times the volume of a tetrahedron, positive if `d` is on the side of a, b, c on
/// which they are counter-clockwise.
fn volume(a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>, d: &Vector3<f64>) -> f64 {
    (b - a).cross(&(c - a)).dot(&(d - a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A circle in the plane z = 0, run round `turns` times, counter-clockwise seen from +z.
    fn circle(turns: usize) -> Vec<Vector3<f64>> {
        let points = 40 * turns;
        let point = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / 40.0).sin_cos();
            // A little apart from turn to turn.
            let radius = 1.0 + 0.01 * i as f64;
            Vector3::new(radius * cos, radius * sin, 0.0)
        };
        (0..points).map(point).collect()
    }

    #[test]
    fn a_path_through_a_circle_is_counted_with_its_direction() {
        let (below, above) = (Vector3::new(0.0, 0.0, -5.0), Vector3::new(0.0, 0.0, 5.0));
        assert_eq!(passes(&[below, above], &circle(1)), 1);
        assert_eq!(passes(&[above, below], &circle(1)), -1);
        assert_eq!(passes(&[below, above, below], &circle(1)), 0);
        assert_eq!(passes(&[below, above], &circle(2)), 2);
    }

    #[test]
    fn a_path_beside_a_circle_is_not_counted() {
        let beside = Vector3::new(3.0, 0.0, 0.0);
        let (below, above) = (Vector3::new(0.0, 0.0, -5.0), Vector3::new(0.0, 0.0, 5.0));
        let path = [below + beside, above + beside];
        assert_eq!(passes(&path, &circle(1)), 0);
    }

    #[test]
    fn a_corner_of_the_path_in_the_plane_of_the_circle_is_counted_once() {
        let point = |z: f64| Vector3::new(0.1, 0.2, z);
        assert_eq!(
            passes(&[point(-5.0), point(0.0), point(5.0)], &circle(1)),
            1
        );
    }
}
