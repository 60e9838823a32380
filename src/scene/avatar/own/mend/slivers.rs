//! Triangles without area, which have no normal.

use crate::scene::avatar::TriangleMesh;

/// Area, doubled, from which on a triangle has a normal \[m²\].
const FLAT: f64 = 1e-11;
/// Length by which a corner is moved \[m\]: a hundredth of the thickness of a hair.
const STEP: f64 = 1e-6;
/// Rounds, in each of which a corner of every flat triangle is moved.
const ROUNDS: usize = 8;

/// Moves corners of triangles without area by a micrometer at a time, away from the edge on which
/// they lie, so that the surface stays closed.
pub(in super::super) fn lift_slivers(surface: &mut TriangleMesh) {
    for round in 0..ROUNDS {
        let mut is_done = true;
        for t in 0..surface.triangles.len() {
            let [a, b, c] = surface.corners(t);
            if (b - a).cross(&(c - a)).norm() > FLAT {
                continue;
            }
            is_done = false;
            // the corner opposite to the longest edge
            let lengths = [(c - b).norm(), (a - c).norm(), (b - a).norm()];
            let corner = (0..3)
                .max_by(|i, j| lengths[*i].total_cmp(&lengths[*j]))
                .unwrap_or(0);
            let [from, to] = [(corner + 1) % 3, (corner + 2) % 3];
            let triangle = surface.triangles[t];
            let along = surface.vertices[triangle[to]] - surface.vertices[triangle[from]];
            let axis = along.iamin();
            let mut off = nalgebra::Vector3::zeros();
            off[axis] = if round % 2 == 0 { 1.0 } else { -1.0 };
            let across = along.cross(&off).try_normalize(0.0).unwrap_or(off);
            surface.vertices[triangle[corner]] += across * (STEP * (round + 1) as f64);
        }
        if is_done {
            return;
        }
    }
}
