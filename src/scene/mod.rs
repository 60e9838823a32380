//! From a mesh, fabrics, an avatar and placements to a [`Scene`] of only the terms that it needs.

mod avatar;
mod body;
mod build;
mod carriers;
mod chords;
mod coarser;
mod crotch;
mod fabric;
mod fixed_cloth;
mod membrane;
mod placement;
mod raw;
pub(crate) mod triples;
mod wind;

pub use avatar::{
    Avatar, AvatarCache, BodyFormat, BodyImport, BodyImportOptions, BodySample, BodySource,
    BodyUnits, DressForm, FileAxis, LANDMARKS, Limb, LimbAxis, Limbs, OwnBody, Pose, Sex, Tips,
    TriangleMesh, import_body, is_head,
};
pub use body::{Analytic, Body};
pub use coarser::{CoarserScene, coarser};
pub use fabric::{Fabric, library};
pub use fixed_cloth::{FixedCloth, FixedPanel};
pub use membrane::{FiberSpring, Membrane, NetSpring};
pub use raw::RawScene;
pub use wind::Wind;

pub use build::{PanelParts, Parts, build};
pub use placement::{AnchoredPlacement, PanelPlacement, Placed, SeamPoint, place_panels};

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
    /// Cut of each panel from one of `fabrics`.
    pub cut: Vec<Cut>,
    /// Resistance to stretch and shear.
    pub membrane: Membrane,
    /// Bending rigidity that the cloth has at least, whatever its fabric \[N m\]: 0 but on coarser
    /// meshes, which cannot fold as finely.
    pub least_bending_n_m: f64,
    /// The body, if there is one.
    pub body: Option<Body>,
    /// Stiffness of the body's skin, as a multiple of the usual one.
    pub body_hardness: f64,
    /// Cloth that does not move, worn beneath: on every level of a hierarchy the same.
    pub fixed_cloth: Option<Arc<FixedCloth>>,
    /// Coulomb coefficient between cloth and body.
    pub friction: f64,
    /// Acceleration \[m/s²\].
    pub gravity: Vector3<f64>,
    /// Drag force over mass and velocity \[1/s\]; the method's own if absent.
    pub drag: Option<f64>,
    /// Vertices that do not move.
    pub pins: Vec<usize>,
    /// The coordinate in which nothing moves (0 x, 1 y, 2 z), for a problem in a plane.
    pub fixed_axis: Option<usize>,
    /// Moving air, if there is any.
    pub wind: Option<Wind>,
    /// Layer of each panel of the mesh, from the body outwards; empty where they have no order.
    pub layers: Vec<usize>,
    /// Panels of the mesh that carry the garment on the body, which are sewn to each other before
    /// what hangs from them, ascending; empty where all seams close at once, or the garment orders
    /// them.
    pub carriers: Vec<usize>,
    /// True if cloth must not pass through cloth.
    pub self_contact: bool,
}

/// Cut of a panel from its fabric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Index of the fabric.
    pub fabric: usize,
    /// Angle of the warp in pattern coordinates, counter-clockwise from +x \[rad\].
    pub warp_angle: f64,
    /// True if the drawn side of the panel is in (its triangles are turned for export).
    pub face_down: bool,
}
