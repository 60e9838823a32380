//! A lattice of nodes in a box.

use nalgebra::Vector3;

/// Nodes at equal distances along x, y and z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    /// The first node \[m\].
    pub(super) origin: Vector3<f64>,
    /// \[m\]
    pub(super) spacing: f64,
    /// Nodes along x, y, z.
    pub(super) size: [usize; 3],
}

impl Lattice {
    pub(super) fn len(&self) -> usize {
        self.size.iter().product()
    }

    /// Index of a node: along z fastest, along x slowest.
    pub(super) fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.size[1] + j) * self.size[2] + k
    }

    pub(super) fn node(&self, index: usize) -> [usize; 3] {
        let row = index / self.size[2];
        [row / self.size[1], row % self.size[1], index % self.size[2]]
    }

    /// Place of a node \[m\].
    pub(super) fn place(&self, [i, j, k]: [usize; 3]) -> Vector3<f64> {
        self.origin + Vector3::new(i as f64, j as f64, k as f64) * self.spacing
    }
}
