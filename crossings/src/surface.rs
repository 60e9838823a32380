//! A triangle mesh that can be judged: finite positions, indices that exist.

use crate::predicates::{self, Point, Triangle};
use crate::tree::Bounds;
use crate::weld::weld;
use thiserror::Error;

/// A triangle mesh as it is written out: single-precision positions, and the vertices that
/// stitches make one.
///
/// Which triangles are neighbors follows from the stitches alone. Their shapes follow from their
/// own corners: the copies of a stitched vertex may lie apart where a seam is held by springs.
#[derive(Clone, Debug)]
pub struct Surface<'a> {
    positions: &'a [[f32; 3]],
    triangles: &'a [[u32; 3]],
    welded: Vec<u32>,
}

/// A mesh that cannot be judged.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SurfaceError {
    /// A position is not a number or infinite.
    #[error("vertex {vertex} has a position that is not finite")]
    NotFinite {
        /// Index of the first such vertex.
        vertex: usize,
    },
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} has a corner that is not among the vertices")]
    NoSuchCorner {
        /// Index of the first such triangle.
        triangle: usize,
    },
    /// A stitch names a vertex that is not there.
    #[error("stitch {stitch} has an end that is not among the vertices")]
    NoSuchEnd {
        /// Index of the first such stitch.
        stitch: usize,
    },
    /// Indices have 32 bits.
    #[error("the mesh has more than 4 294 967 295 vertices or triangles")]
    TooLarge,
}

impl<'a> Surface<'a> {
    /// Checks a mesh of `#V` positions \[m\] (any unit will do), `#T` triangles, and the pairs of
    /// vertices stitched together. Stitches, never distances, make vertices one.
    ///
    /// # Errors
    /// [`SurfaceError`] names the first thing that is wrong.
    pub fn new(
        positions: &'a [[f32; 3]],
        triangles: &'a [[u32; 3]],
        stitches: &[[u32; 2]],
    ) -> Result<Self, SurfaceError> {
        if u32::try_from(positions.len().max(triangles.len())).is_err() {
            return Err(SurfaceError::TooLarge);
        }
        let is_finite = |p: &[f32; 3]| p.iter().all(|x| x.is_finite());
        if let Some(vertex) = positions.iter().position(|p| !is_finite(p)) {
            return Err(SurfaceError::NotFinite { vertex });
        }
        let is_missing = |v: &u32| *v as usize >= positions.len();
        if let Some(triangle) = triangles.iter().position(|t| t.iter().any(is_missing)) {
            return Err(SurfaceError::NoSuchCorner { triangle });
        }
        if let Some(stitch) = stitches.iter().position(|s| s.iter().any(is_missing)) {
            return Err(SurfaceError::NoSuchEnd { stitch });
        }
        Ok(Self {
            positions,
            triangles,
            welded: weld(positions.len(), stitches),
        })
    }

    pub(crate) fn positions(&self) -> &'a [[f32; 3]] {
        self.positions
    }

    pub(crate) fn triangles(&self) -> &'a [[u32; 3]] {
        self.triangles
    }

    pub(crate) fn triangle_count(&self) -> u32 {
        u32::try_from(self.triangles.len()).expect("checked when made")
    }

    /// Welded index of each vertex.
    pub(crate) fn welded(&self) -> &[u32] {
        &self.welded
    }

    /// Welded indices of a triangle's corners.
    pub(crate) fn welded_corners(&self, triangle: u32) -> [u32; 3] {
        self.triangles[triangle as usize].map(|v| self.welded[v as usize])
    }

    pub(crate) fn point(&self, vertex: u32) -> Point {
        self.positions[vertex as usize].map(f64::from)
    }

    /// A triangle's own corners.
    pub(crate) fn corners(&self, triangle: u32) -> Triangle {
        self.triangles[triangle as usize].map(|v| self.point(v))
    }

    /// Smallest boxes about the triangles.
    pub(crate) fn bounds(&self) -> Vec<Bounds> {
        let corners = |t: &[u32; 3]| t.map(|v| self.positions[v as usize]);
        let bounds = self.triangles.iter().map(|t| Bounds::of(&corners(t)));
        bounds.collect()
    }

    /// Returns true if a triangle has no area, or two corners that stitches make one.
    pub(crate) fn is_degenerate(&self, triangle: u32) -> bool {
        let [a, b, c] = self.welded_corners(triangle);
        a == b || b == c || c == a || predicates::has_no_area(&self.corners(triangle))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_judged_is_named() {
        let mut positions = [[0.0; 3]; 4];
        let error = |positions: &[[f32; 3]], triangles: &[[u32; 3]], stitches: &[[u32; 2]]| {
            Surface::new(positions, triangles, stitches).err()
        };
        assert_eq!(error(&positions, &[[0, 1, 3]], &[[0, 3]]), None);
        assert_eq!(
            error(&positions, &[[0, 1, 2], [1, 2, 4]], &[]),
            Some(SurfaceError::NoSuchCorner { triangle: 1 })
        );
        assert_eq!(
            error(&positions, &[], &[[0, 1], [4, 1]]),
            Some(SurfaceError::NoSuchEnd { stitch: 1 })
        );
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            positions[2][1] = bad;
            assert_eq!(
                error(&positions, &[[0, 1, 3]], &[]),
                Some(SurfaceError::NotFinite { vertex: 2 })
            );
        }
    }
}
