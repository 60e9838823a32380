//! State of friction that one solve hands to the next. Apart from contact, so that a scene without
//! a body enters no code of it.

use nalgebra::Vector3;

/// Points that friction holds the particles of a shape by; empty where there is none. A drape that
/// continues from the shape needs them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrictionAnchors(pub(crate) Vec<Option<FrictionAnchor>>);

/// The point that friction holds one particle by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FrictionAnchor {
    /// \[m\]
    pub(crate) point: Vector3<f64>,
    /// Outward normal of the body there.
    pub(crate) normal: Vector3<f64>,
    /// Largest tangential force: μ N \[N\].
    pub(crate) limit: f64,
    /// True if the last step slipped: then the next is taken to slip on, or it would creep by the
    /// spring's give at a time.
    pub(crate) slipping: bool,
}
