//! The turn of cloth about a vertical axis.

use nalgebra::Vector3;

/// Returns the mean angle by which points turned about the vertical through the middle of
/// each set, positive from front (+z) to left (+x) \[degrees\].
///
/// It is the direction of the mean of all turns as points of the unit circle.
pub(super) fn turn_deg(before: &[Vector3<f64>], after: &[Vector3<f64>]) -> f64 {
    let angles = |curve: &[Vector3<f64>]| {
        let middle = curve.iter().sum::<Vector3<f64>>() / curve.len().max(1) as f64;
        let angle = |p: &Vector3<f64>| (p.x - middle.x).atan2(p.z - middle.z);
        curve.iter().map(angle).collect::<Vec<_>>()
    };
    let turns = angles(before).into_iter().zip(angles(after));
    let (sin, cos) = turns.fold((0.0, 0.0), |(sin, cos), (before, after)| {
        let turn: f64 = after - before;
        (sin + turn.sin(), cos + turn.cos())
    });
    f64::atan2(sin, cos).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_turned_ellipse_has_turned_by_its_angle() {
        let curve = |turn: f64| -> Vec<_> {
            let point = |i: i32| {
                let angle = TAU * f64::from(i) / 60.0 + turn;
                Vector3::new(0.3 + angle.sin(), 1.2, angle.cos() - 0.1)
            };
            (0..60).map(point).collect()
        };
        for deg in [-50.0_f64, 0.0, 30.0, 170.0] {
            let turned = turn_deg(&curve(0.0), &curve(deg.to_radians()));
            assert!((turned - deg).abs() < 1e-9, "{turned} {deg}");
        }
    }
}
