//! The side on which a panel starts about an arm.

use nalgebra::Vector3;

/// Distance from the middle within which a panel of the trunk begins \[m\]; a sleeve starts beyond
/// the tip of the shoulder.
const MIDDLE: f64 = 0.1;
/// Distance from the middle within which the center of a narrow panel at the side of the trunk is
/// \[m\].
const TRUNK: f64 = 0.2;

/// Returns the side on which a panel with these points starts about an arm: 1 at +x, -1 at -x;
/// none of a panel about the trunk or the legs.
pub(super) fn arm_side(points: &[Vector3<f64>]) -> Option<f64> {
    let nearest = points
        .iter()
        .map(|p| p.x.abs())
        .fold(f64::INFINITY, f64::min);
    let is_on_one_side = points.iter().all(|p| p.x * points[0].x > 0.0);
    let center = points.iter().map(|p| p.x).sum::<f64>() / points.len().max(1) as f64;
    let is_beside = is_on_one_side && nearest > MIDDLE && center.abs() > TRUNK;
    is_beside.then(|| center.signum())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn side(xs: [f64; 3]) -> Option<f64> {
        arm_side(&xs.map(|x| Vector3::new(x, 1.2, 0.1)))
    }

    #[test]
    fn sleeves_are_beside_the_trunk_and_panels_of_the_trunk_are_not() {
        assert_eq!(side([0.14, 0.3, 0.5]), Some(1.0));
        assert_eq!(side([-0.14, -0.3, -0.5]), Some(-1.0));
        // A front, half of a flared skirt, a side panel of a bodice.
        assert_eq!(side([-0.3, 0.0, 0.3]), None);
        assert_eq!(side([0.0, 0.4, 0.6]), None);
        assert_eq!(side([0.12, 0.17, 0.24]), None);
    }
}
