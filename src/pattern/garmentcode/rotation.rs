//! Rotations by Euler angles.
//!
//! The writer of specifications (pygarment/garmentcode/panel.py) composes R = Rx Ry Rz, its
//! simulator's reader (pygarment/pattern/rotation.py) R = Rz Ry Rx; files that turn about one axis
//! mean the same in both.

use crate::pattern::RotationOrder;

/// A rotation, by rows.
pub(crate) type RotationMatrix = [[f64; 3]; 3];

/// Returns the rotation of three angles \[degrees\].
pub(crate) fn matrix(angles: [f64; 3], order: RotationOrder) -> RotationMatrix {
    let [x, y, z] = [0, 1, 2].map(|axis| about(axis, angles[axis]));
    match order {
        RotationOrder::Xyz => times(&times(&x, &y), &z),
        RotationOrder::Zyx => times(&times(&z, &y), &x),
    }
}

/// Returns the rotation about an axis.
fn about(axis: usize, degrees: f64) -> RotationMatrix {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = [[0.0; 3]; 3];
    m[axis][axis] = 1.0;
    (m[i][i], m[j][j]) = (cos, cos);
    (m[i][j], m[j][i]) = (-sin, sin);
    m
}

/// Returns the product of two matrices.
fn times(a: &RotationMatrix, b: &RotationMatrix) -> RotationMatrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Returns the angles of R = Rx Ry Rz \[degrees\].
pub(super) fn angles_xyz(m: RotationMatrix) -> [f64; 3] {
    /// Cosine of y below which x and z turn about the same axis.
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
