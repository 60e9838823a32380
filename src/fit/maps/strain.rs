//! Strain along warp and weft, and as a share of what the fabric gives.

use crate::scene::{Fabric, Scene};
use crate::solver::{cut_triangles, metric};
use nalgebra::{Matrix2, Vector2, Vector3};
use std::f64::consts::PI;
use std::ptr;

/// Directions in which the share of a fabric's extension is looked at, over half a turn: beside the
/// threads of a woven one the extension grows within some degrees.
const DIRECTIONS: u32 = 180;

/// Strains at the vertices: means over the triangles of each, weighted by their areas; `#V`.
pub(super) struct Strains {
    /// Length along the warp over that on the pattern, less 1.
    pub(super) warp: Vec<f64>,
    /// The same along the weft.
    pub(super) weft: Vec<f64>,
    /// Share of the extension that the fabric gives in wear, in the direction in which it is
    /// largest; 0 where nothing is stretched.
    pub(super) share: Vec<f64>,
}

impl Strains {
    /// Returns the strains of a shape \[m; `#V`\].
    pub(super) fn of(scene: &Scene, positions: &[Vector3<f64>]) -> Self {
        let mut sums = vec![[0.0; 3]; positions.len()];
        let mut areas = vec![0.0; positions.len()];
        let tables: Vec<_> = scene.fabrics.iter().map(directions).collect();
        for (triangle, fabric, rest) in cut_triangles(scene) {
            let Some((metric, area)) = metric(rest, triangle.map(|v| positions[v])) else {
                continue;
            };
            let number = scene.fabrics.iter().position(|f| ptr::eq(f, fabric));
            let values = strains(&metric, number.map_or(&[], |number| &tables[number]));
            for v in triangle {
                areas[v] += area;
                for (sum, value) in sums[v].iter_mut().zip(values) {
                    *sum += area * value;
                }
            }
        }
        let mean = |k: usize| {
            let means = sums.iter().zip(&areas);
            means
                .map(|(sum, area)| if *area > 0.0 { sum[k] / area } else { 0.0 })
                .collect()
        };
        Self {
            warp: mean(0),
            weft: mean(1),
            share: mean(2),
        }
    }
}

/// A direction on the pattern.
struct Direction {
    along: Vector2<f64>,
    /// Share of its length by which the fabric gives along it.
    extension: f64,
}

/// Returns directions all round, with the extension of `fabric` along each; from that of
/// the warp on.
fn directions(fabric: &Fabric) -> Vec<Direction> {
    let angles = (0..DIRECTIONS).map(|k| PI * f64::from(k) / f64::from(DIRECTIONS));
    let direction = |angle: f64| Direction {
        along: Vector2::new(angle.cos(), angle.sin()),
        extension: fabric.extension(angle),
    };
    angles.map(direction).collect()
}

/// Returns the strains along warp and weft of a triangle whose squared lengths are `metric`, and
/// the largest share of the extension that its fabric gives, over all `directions`.
fn strains(metric: &Matrix2<f64>, directions: &[Direction]) -> [f64; 3] {
    let strain = |along: &Vector2<f64>| along.dot(&(metric * along)).max(0.0).sqrt() - 1.0;
    let shares = directions.iter().map(|d| strain(&d.along) / d.extension);
    [
        strain(&Vector2::x()),
        strain(&Vector2::y()),
        shares.fold(0.0, f64::max),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::library;
    use std::f64::consts::FRAC_PI_2;

    /// The metric of a cloth that is longer by these shares along two directions at this angle from
    /// warp and weft.
    fn stretched([along, across]: [f64; 2], angle: f64) -> Matrix2<f64> {
        let (sin, cos) = angle.sin_cos();
        let turn = Matrix2::new(cos, -sin, sin, cos);
        let squared = [along, across].map(|strain| (1.0 + strain) * (1.0 + strain));
        turn * Matrix2::from_diagonal(&squared.into()) * turn.transpose()
    }

    #[test]
    fn strains_are_those_along_the_threads() {
        let fabric = library().remove("cotton-poplin").expect("a shipped fabric");
        let [warp, weft, share] = strains(&stretched([0.015, 0.02], 0.0), &directions(&fabric));
        assert!((warp - 0.015).abs() < 1e-12 && (weft - 0.02).abs() < 1e-12);
        // Of the 3 and 8 % that it gives.
        let expected = (0.015 / fabric.extension(0.0)).max(0.02 / fabric.extension(FRAC_PI_2));
        assert!((share - expected).abs() < 1e-9, "{share}");
    }

    #[test]
    fn on_the_bias_the_share_is_of_what_the_bias_gives() {
        let fabric = library().remove("cotton-poplin").expect("a shipped fabric");
        let bias = 0.5 * FRAC_PI_2;
        let [warp, weft, share] = strains(&stretched([0.1, -0.1], bias), &directions(&fabric));
        // Squares of lengths along the threads: the mean of 1.1² and 0.9².
        let expected = (0.5 * (1.21_f64 + 0.81)).sqrt() - 1.0;
        assert!((warp - expected).abs() < 1e-12 && (weft - expected).abs() < 1e-12);
        // A strip at any angle, by the law of cosines of its two parts.
        let of_strip = |angle: f64| {
            let (sin, cos) = (angle - bias).sin_cos();
            ((1.1 * cos).hypot(0.9 * sin) - 1.0) / fabric.extension(angle)
        };
        let angles = (0..3600).map(|k| PI * f64::from(k) / 3600.0);
        let largest = angles.map(of_strip).fold(0.0, f64::max);
        assert!((share / largest - 1.0).abs() < 0.01, "{share} {largest}");
    }

    #[test]
    fn slack_cloth_has_no_share() {
        let fabric = library().remove("denim-11oz").expect("a shipped fabric");
        assert!(strains(&stretched([-0.1, -0.2], 0.3), &directions(&fabric))[2].abs() < 1e-12);
    }
}
