//! The surface of a fit that another garment file holds: sizes, places and corners are checked
//! before anything is made of it.

use crate::config::Limits;
use nalgebra::Vector3;

/// Largest coordinate of such a surface \[m\].
const LARGEST: f64 = 100.0;
/// Characters of a name that a fault quotes.
const QUOTED: usize = 60;

/// Checks that a surface is no larger than a mesh may be.
///
/// # Errors
/// How large it is and may be, in words.
pub(super) fn check_size(vertices: usize, triangles: usize, limits: &Limits) -> Result<(), String> {
    // A sheet has about twice as many triangles as vertices.
    let most = [limits.mesh_vertices, 2 * limits.mesh_vertices];
    if vertices <= most[0] && triangles <= most[1] {
        return Ok(());
    }
    Err(format!(
        "{vertices} vertices and {triangles} triangles; at most {} and {} are taken",
        most[0], most[1]
    ))
}

/// Checks the positions \[m; `#V`\] and triangles of a panel.
///
/// # Errors
/// The first thing that is wrong with it, in words that follow its name.
pub(super) fn check(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Result<(), &'static str> {
    if positions.iter().flatten().any(is_far) {
        return Err("has a position that is not near the body");
    }
    let corner = |v: &u32| positions.get(*v as usize).copied().map(Vector3::from);
    let has_area = |t: &[u32; 3]| {
        let [a, b, c] = [corner(&t[0])?, corner(&t[1])?, corner(&t[2])?];
        Some((b - a).cross(&(c - a)).norm() > 0.0)
    };
    for triangle in triangles {
        match has_area(triangle) {
            Some(true) => {}
            Some(false) => return Err("has a triangle without area"),
            None => return Err("has a triangle with a corner that is not there"),
        }
    }
    Ok(())
}

/// Returns true if a coordinate is not a number near the body \[m\].
pub(super) fn is_far(coordinate: &f64) -> bool {
    !(-LARGEST..=LARGEST).contains(coordinate)
}

/// Returns the beginning of a name for a sentence.
pub(super) fn excerpt(name: &str) -> String {
    name.chars().take(QUOTED).collect()
}
