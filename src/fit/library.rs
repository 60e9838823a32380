//! The stored and shipped things that a garment may refer to by id.

use crate::pattern::Pattern;
use crate::scene::{self, DressForm, Fabric};
use std::sync::Arc;
use uuid::Uuid;

/// Patterns, avatars and fabrics by id.
pub trait AssetLibrary: Sync {
    /// Returns a stored pattern.
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>>;
    /// Returns the measurements of a stored avatar.
    fn form(&self, id: Uuid) -> Option<DressForm>;
    /// Returns a fabric, shipped or stored.
    fn fabric(&self, id: &str) -> Option<Fabric>;
}

/// The shipped fabrics, and nothing stored.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShippedAssets;

impl AssetLibrary for ShippedAssets {
    fn pattern(&self, _id: Uuid) -> Option<Arc<Pattern>> {
        None
    }

    fn form(&self, _id: Uuid) -> Option<DressForm> {
        None
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        scene::library().remove(id)
    }
}
