//! Smooth normals of a surface of triangles.

use nalgebra::Vector3;

/// Normals of a part that has no area: any direction is right, and a reader wants a unit vector.
const NOWHERE: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

/// Unit normals, `#V`: the mean of the triangles round a vertex weighted by area, on their counter-clockwise side.
///
/// Assumes indices below `positions.len()`.
pub(super) fn smooth(positions: &[Vector3<f64>], triangles: &[[usize; 3]]) -> Vec<Vector3<f64>> {
    let mut normals = vec![Vector3::zeros(); positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| positions[i]);
        // Twice the area long.
        let normal = (b - a).cross(&(c - a));
        for &i in triangle {
            normals[i] += normal;
        }
    }
    for normal in &mut normals {
        *normal = normal.try_normalize(0.0).unwrap_or(NOWHERE);
    }
    normals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_of_a_corner_leans_to_the_larger_face() {
        // Two right triangles along the x axis: one of area 1/2 facing +z, one of area 1 facing -y.
        let x = Vector3::x();
        let positions = [Vector3::zeros(), x, Vector3::y(), 2.0 * Vector3::z()];
        let normals = smooth(&positions, &[[0, 1, 2], [0, 1, 3]]);
        let expected = Vector3::new(0.0, -2.0, 1.0).normalize();
        assert!((normals[0] - expected).norm() < 1e-15);
        assert!((normals[2] - Vector3::z()).norm() < 1e-15);
        assert!((normals[3] + Vector3::y()).norm() < 1e-15);
    }

    #[test]
    fn vertices_without_area_have_unit_normals() {
        let positions = [Vector3::zeros(); 4];
        for normal in smooth(&positions, &[[0, 1, 2]]) {
            assert!((normal.norm() - 1.0).abs() < 1e-15);
        }
    }
}
