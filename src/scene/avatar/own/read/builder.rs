//! A surface in the making, within its limits.

use super::unreadable::unreadable;
use crate::config::Limits;
use crate::fault::{AvatarCode, Fault};
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Vertices and triangles as a file gives them, each checked before it is kept.
pub(super) struct SurfaceBuilder<'a> {
    surface: TriangleMesh,
    limits: &'a Limits,
}

impl<'a> SurfaceBuilder<'a> {
    pub(super) fn new(limits: &'a Limits) -> Self {
        Self {
            surface: TriangleMesh::default(),
            limits,
        }
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.surface.vertices.len()
    }

    /// Adds a vertex.
    pub(super) fn vertex(
        &mut self,
        point: Vector3<f64>,
        place: impl Fn() -> String,
    ) -> Result<(), Fault> {
        if !point.iter().all(|x| x.is_finite()) {
            return Err(unreadable(place(), "a coordinate is not a finite number"));
        }
        if self.surface.vertices.len() == self.limits.body_vertices {
            return Err(too_large(place(), "vertices", self.limits.body_vertices));
        }
        self.surface.vertices.push(point);
        Ok(())
    }

    /// Adds the fan of triangles of a polygon.
    pub(super) fn polygon(
        &mut self,
        corners: &[usize],
        place: impl Fn() -> String,
    ) -> Result<(), Fault> {
        let count = self.surface.vertices.len();
        if let Some(corner) = corners.iter().find(|corner| **corner >= count) {
            let detail = format!("a face names vertex {corner}, counted from 0, of {count}");
            return Err(unreadable(place(), detail));
        }
        let more = corners.len().saturating_sub(2);
        if self.surface.triangles.len() + more > self.limits.body_triangles {
            return Err(too_large(place(), "triangles", self.limits.body_triangles));
        }
        let fan = corners.windows(2).skip(1);
        let fan = fan.map(|pair| [corners[0], pair[0], pair[1]]);
        self.surface.triangles.extend(fan);
        Ok(())
    }

    /// Returns the surface.
    pub(super) fn finish(self) -> TriangleMesh {
        self.surface
    }
}

fn too_large(place: String, of: &str, most: usize) -> Fault {
    let detail = format!("the body has more than {most} {of}");
    Fault::new(AvatarCode::TooLarge, place, detail)
        .fix("simplify the surface: 100 000 triangles show a body to the millimeter")
}
