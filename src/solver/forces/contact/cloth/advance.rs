//! How far two features may move before they come too close: additive continuous collision
//! detection (M. Li, D. M. Kaufman, C. Jiang, "Codimensional Incremental Potential Contact", ACM
//! TOG 40(4), 2021, 4.2).

use super::proximity::{Features, Proximity};
use nalgebra::Vector3;

/// Share of its distance that a pair keeps at least.
const KEPT: f64 = 0.1;
/// Share of what is left that each advance takes.
const ADVANCE: f64 = 0.9;
/// Advances at most; a motion that takes more is cut short there.
const ADVANCES: usize = 200;

/// Returns the share of the displacements, 0 to 1, that the corners of two features may move by so
/// that a tenth of their distance is left all the way.
pub(super) fn free_share(
    features: Features,
    corners: &[Vector3<f64>; 4],
    displacement: &[Vector3<f64>; 4],
) -> f64 {
    let mean = displacement.iter().sum::<Vector3<f64>>() * 0.25;
    let relative = displacement.map(|d| d - mean);
    let longest = |of: &[Vector3<f64>]| of.iter().map(Vector3::norm).fold(0.0, f64::max);
    let apart = match features {
        Features::VertexTriangle => 1,
        Features::Edges => 2,
    };
    let speed = longest(&relative[..apart]) + longest(&relative[apart..]);
    let mut at = *corners;
    let first = Proximity::of(features, &at).distance();
    // Whatever the features do on the way.
    if speed <= (1.0 - KEPT) * first {
        return 1.0;
    }
    let kept = KEPT * first;
    let mut share = 0.0;
    let mut advance = (1.0 - KEPT) * first / speed;
    for _ in 0..ADVANCES {
        for (x, d) in at.iter_mut().zip(&relative) {
            *x += d * advance;
        }
        let distance = Proximity::of(features, &at).distance();
        if share > 0.0 && distance < kept {
            return share;
        }
        share += advance;
        if share >= 1.0 {
            return 1.0;
        }
        advance = ADVANCE * distance / speed;
    }
    share
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> [Vector3<f64>; 3] {
        [Vector3::zeros(), Vector3::x(), Vector3::y()]
    }

    /// A vertex 1 above a triangle: what leads away or past is free, what leads through is cut
    /// before the triangle.
    #[test]
    fn what_would_pass_through_is_cut_before_it() {
        let [a, b, c] = triangle();
        let x = [Vector3::new(0.2, 0.2, 1.0), a, b, c];
        let share = |d: Vector3<f64>| {
            let still = Vector3::zeros();
            free_share(Features::VertexTriangle, &x, &[d, still, still, still])
        };
        assert_eq!(share(Vector3::z() * 5.0), 1.0);
        assert_eq!(share(Vector3::new(7.0, 0.0, -2.0)), 1.0);
        let through = share(Vector3::z() * -4.0);
        // It ends where a tenth of the distance is left, or one advance before.
        assert!(through <= 0.225 && through > 0.2, "{through}");
    }

    /// Two crossed edges that move together are free, however far.
    #[test]
    fn a_common_motion_is_free() {
        let x = [
            Vector3::new(-1.0, 0.0, 0.01),
            Vector3::new(1.0, 0.0, 0.01),
            Vector3::new(0.0, -1.0, 0.0),
            Vector3::new(0.0, 1.0, 0.0),
        ];
        let along = Vector3::new(3.0, 2.0, -50.0);
        assert_eq!(free_share(Features::Edges, &x, &[along; 4]), 1.0);
        let crossing = [along, along, along, along + Vector3::z() * 0.5];
        let share = free_share(Features::Edges, &x, &crossing);
        assert!(share < 0.04, "{share}");
    }
}
