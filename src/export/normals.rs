//! Smooth normals of a surface of triangles, across seams too.

use super::garment_mesh::GarmentMesh;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Normal of a part that has no area: any direction is right, and a reader wants a unit vector.
const NOWHERE: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

/// Cosine of the angle between two faces (60 degrees) above which the seam between them is a crease
/// to be seen, as at a hem or a dart's end: sewn cloth that hangs smooth turns less at one seam, a
/// fold turns more.
const CREASE_COS: f64 = 0.5;

/// More vertices than seams ever bring together in one point: a shape that collapsed, whose normals
/// mean nothing.
const MOST_MET: usize = 64;

/// Returns unit normals, `#V`: the mean of the triangles round a vertex weighted by area, on their
/// counter-clockwise side.
///
/// Assumes indices below `positions.len()`.
pub(super) fn smooth(positions: &[Vector3<f64>], triangles: &[[usize; 3]]) -> Vec<Vector3<f64>> {
    weighted(positions, triangles).iter().map(unit).collect()
}

/// Returns unit normals of every panel, `#V` each: as [`smooth`], and over vertices at the very
/// same place (a closed seam) where the faces do not meet in a crease, so that light does not tell
/// panels apart.
pub(super) fn of_garment(mesh: &GarmentMesh) -> Vec<Vec<Vector3<f64>>> {
    let own: Vec<Vec<_>> = mesh
        .panels
        .iter()
        .map(|panel| {
            let positions: Vec<_> = panel.positions.iter().map(|p| Vector3::from(*p)).collect();
            let triangles = panel.triangles.iter().map(|t| t.map(|i| i as usize));
            weighted(&positions, &triangles.collect::<Vec<_>>())
        })
        .collect();
    let mut normals: Vec<Vec<_>> = own.iter().map(|n| n.iter().map(unit).collect()).collect();
    for met in meetings(mesh) {
        let faces: Vec<_> = met.iter().map(|&(panel, i)| own[panel][i]).collect();
        for (&(panel, i), face) in met.iter().zip(&faces) {
            let face = unit(face);
            let joined = faces.iter().filter(|f| unit(f).dot(&face) >= CREASE_COS);
            normals[panel][i] = unit(&joined.sum());
        }
    }
    normals
}

/// Returns groups of vertices (panel, index) at exactly the same place, in the order of panels and
/// vertices.
fn meetings(mesh: &GarmentMesh) -> Vec<Vec<(usize, usize)>> {
    let mut at: BTreeMap<[u64; 3], Vec<(usize, usize)>> = BTreeMap::new();
    for (panel, part) in mesh.panels.iter().enumerate() {
        for (i, position) in part.positions.iter().enumerate() {
            // Adding zero makes -0.0 the same place as 0.0.
            let place = position.map(|x| (x + 0.0).to_bits());
            at.entry(place).or_default().push((panel, i));
        }
    }
    at.into_values()
        .filter(|met| (2..=MOST_MET).contains(&met.len()))
        .collect()
}

/// Returns the sum of the normals of the triangles round each vertex, each twice its area long,
/// `#V`.
fn weighted(positions: &[Vector3<f64>], triangles: &[[usize; 3]]) -> Vec<Vector3<f64>> {
    let mut normals = vec![Vector3::zeros(); positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| positions[i]);
        let normal = (b - a).cross(&(c - a));
        for &i in triangle {
            normals[i] += normal;
        }
    }
    normals
}

fn unit(normal: &Vector3<f64>) -> Vector3<f64> {
    normal.try_normalize(0.0).unwrap_or(NOWHERE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::garment_mesh::DrapedPanel;
    use crate::pattern::Point2;
    use std::f64::consts::FRAC_PI_2;

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

    /// Two squares of side 1 sewn along the y axis: one in the plane z = 0, the other turned up out
    /// of it by `turn`.
    fn sewn(turn: f64) -> GarmentMesh {
        let (sin, cos) = turn.sin_cos();
        let panel = |far: Point2, triangles: [[u32; 3]; 2]| DrapedPanel {
            positions: vec![
                [0.0, 0.0, 0.0],
                [far[0], 0.0, far[1]],
                [far[0], 1.0, far[1]],
                [-0.0, 1.0, 0.0],
            ],
            uv: vec![[0.0; 2]; 4],
            triangles: triangles.to_vec(),
            ..DrapedPanel::default()
        };
        GarmentMesh {
            panels: vec![
                panel([-1.0, 0.0], [[0, 2, 1], [0, 3, 2]]),
                panel([cos, sin], [[0, 1, 2], [0, 2, 3]]),
            ],
        }
    }

    #[test]
    fn panels_that_meet_smoothly_have_one_normal_along_the_seam() {
        for turn in [0.0, 0.5, -0.5] {
            let [left, right] = &of_garment(&sewn(turn))[..] else {
                panic!("two panels");
            };
            for i in [0, 3] {
                assert_eq!(left[i], right[i], "turned by {turn}");
                let between = Vector3::new(-(turn / 2.0).sin(), 0.0, (turn / 2.0).cos());
                // One vertex has two triangles in the one panel and one in the other: the mean
                // leans to the former.
                assert!(left[i].angle(&between) <= turn.abs() / 2.0);
            }
            assert!((left[1] - Vector3::z()).norm() < 1e-15, "off the seam");
        }
    }

    #[test]
    fn panels_that_meet_in_a_crease_keep_their_own_normals() {
        for turn in [FRAC_PI_2, -FRAC_PI_2, 3.1] {
            let [left, right] = &of_garment(&sewn(turn))[..] else {
                panic!("two panels");
            };
            let turned = Vector3::new(-turn.sin(), 0.0, turn.cos());
            for i in [0, 3] {
                assert!((left[i] - Vector3::z()).norm() < 1e-15, "turned by {turn}");
                assert!((right[i] - turned).norm() < 1e-15, "turned by {turn}");
            }
        }
    }

    #[test]
    fn panels_that_only_touch_nearly_are_not_joined() {
        let mut mesh = sewn(0.5);
        for position in &mut mesh.panels[1].positions {
            position[1] += 1e-9;
        }
        let normals = of_garment(&mesh);
        assert!((normals[0][0] - Vector3::z()).norm() < 1e-15);
    }

    #[test]
    fn a_collapsed_shape_is_left_as_it_is() {
        let point = DrapedPanel {
            positions: vec![[0.0; 3]; 1000],
            triangles: vec![[0, 1, 2]],
            ..DrapedPanel::default()
        };
        let mesh = GarmentMesh {
            panels: vec![point],
        };
        assert_eq!(of_garment(&mesh), [vec![NOWHERE; 1000]]);
    }
}
