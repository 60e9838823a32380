//! The membrane of a scene: what resists stretch and shear.

use serde::{Deserialize, Serialize};

/// Membrane of a scene: its resistance to stretch and shear.
#[derive(Clone, Debug)]
pub enum Membrane {
    /// The fabrics of the panels.
    Fabric,
    /// Springs between vertices, given as they are.
    Springs(Vec<NetSpring>),
    /// A finer net of springs, carried over to the triangles of a coarser mesh.
    Fibers(Vec<FiberSpring>),
}

impl Membrane {
    /// Returns the springs that are given as they are; none for another membrane.
    pub fn springs(&self) -> &[NetSpring] {
        match self {
            Self::Springs(springs) => springs,
            Self::Fabric | Self::Fibers(_) => &[],
        }
    }

    /// Returns the same springs to be changed.
    pub fn springs_mut(&mut self) -> &mut [NetSpring] {
        match self {
            Self::Springs(springs) => springs,
            Self::Fabric | Self::Fibers(_) => &mut [],
        }
    }

    /// Returns the springs within triangles; none for another membrane.
    pub fn fibers(&self) -> &[FiberSpring] {
        match self {
            Self::Fibers(fibers) => fibers,
            Self::Fabric | Self::Springs(_) => &[],
        }
    }
}

/// A spring between two vertices: energy `k/2 (|xa - xb| - rest)²`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NetSpring {
    /// One vertex.
    pub a: usize,
    /// The other.
    pub b: usize,
    /// \[m\]
    pub rest_length_m: f64,
    /// \[N/m\]
    pub stiffness_n_m: f64,
}

/// A spring between two points of one triangle: its length is `|sum weights x|`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiberSpring {
    /// Vertices of the triangle.
    pub corners: [usize; 3],
    /// Weights of the corners; they add up to 0.
    pub weights: [f64; 3],
    /// \[m\], if the weights are numbers; of unit length if they are gradients.
    pub rest_length_m: f64,
    /// \[N/m\]
    pub stiffness_n_m: f64,
}
