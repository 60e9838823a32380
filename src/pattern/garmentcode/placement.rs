//! Where a specification puts its panels: (x, y, 0) is turned, then moved.
//!
//! Rotations are Euler angles in degrees. The writer (pygarment/garmentcode/panel.py) composes R = Rx Ry Rz, its
//! simulator's reader (pygarment/pattern/rotation.py) R = Rz Ry Rx; files that turn about one axis mean the same in both.

use super::Reading;
use super::panel::Loop;
use super::value::{At, Findings};
use crate::pattern::polyline::bounds;
use crate::pattern::{Placement, PlacementAnchor, RotationOrder, Wrap};

/// Coordinates and angles up to this are read \[m, degrees\].
const FAR: f64 = 1e4;

type Matrix = [[f64; 3]; 3];

/// The placement of a panel; `None` where nothing is stated.
pub(super) fn read(
    at: &At<'_>,
    drawn: Option<&Loop>,
    reading: &Reading<'_>,
    findings: &mut Findings,
) -> Option<Placement> {
    let translation = at.get("translation");
    let rotation = at.get("rotation");
    if translation.is_none() && rotation.is_none() {
        return None;
    }
    let zero = Some([0.0; 3]);
    let moved = translation.map_or(zero, |t| numbers(&t, reading.scale, findings));
    let angles = rotation.map_or(zero, |r| numbers(&r, 1.0, findings));
    let (moved, angles, drawn) = (moved?, angles?, drawn?);
    let order = reading.rotation_order;
    let rotation = matrix(angles, order);
    let points = drawn.panel.edges.iter().flat_map(|edge| &edge.points);
    let [low, high] = bounds(&points.copied().collect::<Vec<_>>());
    let mut centre = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
    let mut offset = moved;
    if reading.about_mean {
        for k in 0..2 {
            centre[k] -= drawn.mean[k];
            offset[k] += drawn.mean[k];
        }
    }
    // R v + t = R (v - c) + (R c + t).
    for (k, row) in rotation.iter().enumerate() {
        offset[k] += row[0] * centre[0] + row[1] * centre[1];
    }
    if offset.iter().any(|c| c.abs() > FAR) {
        let detail = "the panel is placed beyond 10 km";
        findings.fault(at.wrong("pattern/not_finite", detail, "correct its translation"));
        return None;
    }
    let rotate_deg = match order {
        RotationOrder::Xyz => angles,
        RotationOrder::Zyx => angles_xyz(rotation),
    };
    Some(Placement {
        up_deg: None,
        at: Some(PlacementAnchor::Origin),
        offset_m: offset.map(|c| c + 0.0),
        rotate_deg: rotate_deg.map(|angle| angle + 0.0),
        wrap: Some(Wrap::Flat),
    })
}

fn numbers(at: &At<'_>, scale: f64, findings: &mut Findings) -> Option<[f64; 3]> {
    let numbers = at.numbers::<3>(findings)?.map(|x| x * scale);
    if numbers.iter().all(|x| x.abs() <= FAR) {
        return Some(numbers);
    }
    let detail = "a number is beyond 10 km or 10000 degrees";
    findings.fault(at.wrong("pattern/not_finite", detail, "correct it"));
    None
}

/// The rotation of three angles \[degrees\].
fn matrix(angles: [f64; 3], order: RotationOrder) -> Matrix {
    let [x, y, z] = [0, 1, 2].map(|axis| about(axis, angles[axis]));
    match order {
        RotationOrder::Xyz => times(&times(&x, &y), &z),
        RotationOrder::Zyx => times(&times(&z, &y), &x),
    }
}

fn about(axis: usize, degrees: f64) -> Matrix {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = [[0.0; 3]; 3];
    m[axis][axis] = 1.0;
    (m[i][i], m[j][j]) = (cos, cos);
    (m[i][j], m[j][i]) = (-sin, sin);
    m
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The angles of R = Rx Ry Rz \[degrees\].
fn angles_xyz(m: Matrix) -> [f64; 3] {
    /// Where cos y is below this, x and z turn about the same axis.
    const LOCKED: f64 = 1e-9;
    let cos_y = m[0][0].hypot(m[0][1]);
    let y = m[0][2].atan2(cos_y);
    let (x, z) = if cos_y > LOCKED {
        ((-m[1][2]).atan2(m[2][2]), (-m[0][1]).atan2(m[0][0]))
    } else {
        (m[2][1].atan2(m[1][1]), 0.0)
    };
    [x, y, z].map(f64::to_degrees)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_of_either_order_give_the_same_rotation() {
        for angles in [
            [10.0, 20.0, 30.0],
            [-100.0, 70.0, 170.0],
            [40.0, 90.0, 25.0],
            [40.0, -90.0, 25.0],
            [0.0, 180.0, 0.0],
        ] {
            let wanted = matrix(angles, RotationOrder::Zyx);
            let found = matrix(angles_xyz(wanted), RotationOrder::Xyz);
            for (a, b) in wanted.iter().flatten().zip(found.iter().flatten()) {
                assert!((a - b).abs() < 1e-9, "{angles:?}");
            }
        }
    }

    #[test]
    fn quarter_turns_follow_the_right_hand() {
        // About z, x goes to y; about x, y goes to z; about y, z goes to x.
        assert!((about(2, 90.0)[1][0] - 1.0).abs() < 1e-15);
        assert!((about(0, 90.0)[2][1] - 1.0).abs() < 1e-15);
        assert!((about(1, 90.0)[0][2] - 1.0).abs() < 1e-15);
        // Rx Ry Rz turns about z first.
        let turned = matrix([90.0, 0.0, 90.0], RotationOrder::Xyz);
        assert!((turned[2][0] - 1.0).abs() < 1e-15, "x to y to z");
    }
}
