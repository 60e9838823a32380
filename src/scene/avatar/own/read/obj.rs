//! Wavefront OBJ: its vertices and faces; groups, materials and all else are passed over.

use super::builder::SurfaceBuilder;
use super::unreadable::unreadable;
use crate::config::Limits;
use crate::fault::Fault;
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Reads the faces of a file as fans of triangles.
pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<TriangleMesh, Fault> {
    let mut builder = SurfaceBuilder::new(limits);
    let mut corners = Vec::new();
    for (number, line) in bytes.split(|byte| *byte == b'\n').enumerate() {
        let place = || format!("line {}", number + 1);
        let mut words = line
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        match words.next() {
            Some(b"v") => {
                let mut point = Vector3::zeros();
                for x in point.iter_mut() {
                    *x = words
                        .next()
                        .and_then(number_of::<f64>)
                        .ok_or_else(|| unreadable(place(), "a vertex has no three numbers"))?;
                }
                builder.vertex(point, place)?;
            }
            Some(b"f") => {
                corners.clear();
                for word in words {
                    let corner = corner(word, builder.vertex_count()).ok_or_else(|| {
                        unreadable(place(), "a face names a vertex that is not there")
                    })?;
                    corners.push(corner);
                }
                builder.polygon(&corners, place)?;
            }
            _ => {}
        }
    }
    Ok(builder.finish())
}

fn number_of<T: std::str::FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Returns the index of a corner `7`, `7/1`, `7//2` or `-1` (the last vertex so far).
fn corner(word: &[u8], count: usize) -> Option<usize> {
    let index = word.split(|byte| *byte == b'/').next()?;
    let index = number_of::<i64>(index)?;
    let steps = usize::try_from(index.unsigned_abs()).ok()?;
    let index = if index < 0 {
        count.checked_sub(steps)?
    } else {
        steps.checked_sub(1)?
    };
    (index < count).then_some(index)
}
