//! Positions of the particles and, after them, of the vertices of cloth that does not move.

use nalgebra::Vector3;

/// Room for the positions of all vertices of the surface, in which those of fixed cloth stand once
/// and for all; empty where there is no such cloth, and particles are all that there is.
#[derive(Clone, Debug, Default)]
pub(super) struct AllPositions {
    /// Particles \[m\], then fixed vertices; `#P + #F`.
    positions: Vec<Vector3<f64>>,
    particles: usize,
}

impl AllPositions {
    /// Returns room for so many particles beside these vertices \[m\].
    pub(super) fn new(particles: usize, fixed: &[Vector3<f64>]) -> Self {
        if fixed.is_empty() {
            return Self::default();
        }
        let mut positions = vec![Vector3::zeros(); particles];
        positions.extend_from_slice(fixed);
        Self {
            positions,
            particles,
        }
    }

    /// Returns the positions of the particles, which are `x`, and of fixed cloth \[m\].
    pub(super) fn with<'a>(&'a mut self, x: &'a [Vector3<f64>]) -> &'a [Vector3<f64>] {
        if self.positions.is_empty() {
            return x;
        }
        self.positions[..self.particles].copy_from_slice(x);
        &self.positions
    }

    /// Runs `edit` on the positions of the particles, which are `x`, and of fixed cloth \[m\], and
    /// keeps what it makes of the former. The latter it must leave as they are.
    pub(super) fn edit<T>(
        &mut self,
        x: &mut [Vector3<f64>],
        edit: impl FnOnce(&mut [Vector3<f64>]) -> T,
    ) -> T {
        if self.positions.is_empty() {
            return edit(x);
        }
        self.positions[..self.particles].copy_from_slice(x);
        let result = edit(&mut self.positions);
        x.copy_from_slice(&self.positions[..self.particles]);
        result
    }
}
