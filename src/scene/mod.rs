//! From a mesh, fabrics, an avatar and placements to a [`Scene`] of only the terms that it needs.

mod avatar;
mod build;
mod fabric;
mod placement;

pub use avatar::{Avatar, BodySample, DressForm, LANDMARKS, TriangleMesh};
pub use fabric::{Fabric, library};

pub use build::{PanelParts, Parts, build};
pub use placement::{Placed, ToPlace, place};

use crate::mesh::ClothMesh;
use nalgebra::Vector3;
use std::sync::Arc;

/// Everything a solver needs to know, in SI units.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Triangles, rest positions and stitches.
    pub mesh: ClothMesh,
    /// Position of each vertex at the start \[m\]; `#V`.
    pub start: Vec<Vector3<f64>>,
    /// Mass of each vertex \[kg\]; `#V`.
    pub mass: Vec<f64>,
    /// Fabrics in use.
    pub fabrics: Vec<Fabric>,
    /// What each panel is cut from: index into `fabrics` and the angle of the warp, counter-clockwise from +x \[rad\].
    pub cut: Vec<Cut>,
    /// The body, if there is one.
    pub avatar: Option<Arc<Avatar>>,
    /// Coulomb coefficient between cloth and body.
    pub friction: f64,
    /// Acceleration \[m/s²\].
    pub gravity: Vector3<f64>,
    /// Vertices that do not move.
    pub pins: Vec<usize>,
}

/// How a panel is cut from its fabric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Index of the fabric.
    pub fabric: usize,
    /// Angle of the warp in pattern coordinates, counter-clockwise from +x \[rad\].
    pub warp_angle: f64,
    /// Whether the drawn side of the panel is in (its triangles are turned for export).
    pub face_down: bool,
}
