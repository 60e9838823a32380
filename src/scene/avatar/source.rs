//! Sources of bodies: measurements, or surfaces.

use super::{Avatar, DressForm, OwnBody};
use crate::fault::{Fault, Faults};
use std::sync::Arc;

/// Source of a body: measurements, or a surface of its own.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is one of a garment")]
pub enum BodySource {
    /// A dress form of these measurements.
    Form(DressForm),
    /// A body from a file.
    Own(Arc<OwnBody>),
}

impl BodySource {
    /// Makes the body.
    ///
    /// # Errors
    /// All that is wrong with the measurements, or with the surface and its landmarks.
    pub fn build(&self) -> Result<Avatar, Faults> {
        match self {
            Self::Form(form) => form.build(),
            Self::Own(body) => body.build(),
        }
    }

    /// Returns the faults of the measurements, or of the surface and its landmarks, with pointers
    /// into a reference to the body: `/form/height_m`.
    pub(crate) fn check(&self) -> Vec<Fault> {
        let (faults, under) = match self {
            Self::Form(form) => (form.check(), "/form"),
            Self::Own(body) => (body.check(), "/body"),
        };
        Faults(faults).under(under).0
    }
}
