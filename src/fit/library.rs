//! The stored and shipped things that a garment may refer to by id.

use super::garment::Garment;
use crate::export::GarmentMesh;
use crate::pattern::Pattern;
use crate::scene::{self, BodySource, Fabric};
use std::sync::Arc;
use uuid::Uuid;

/// Patterns, avatars and fabrics by id.
pub trait AssetLibrary: Sync {
    /// Returns a stored pattern.
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>>;
    /// Returns what a stored avatar is made from.
    fn body(&self, id: Uuid) -> Option<BodySource>;
    /// Returns a fabric, shipped or stored.
    fn fabric(&self, id: &str) -> Option<Fabric>;
    /// Returns a fit that has succeeded.
    ///
    /// # Errors
    /// The reason why there is none; always where no fits are stored.
    fn finished_fit(&self, _id: Uuid) -> Result<FinishedFit, NoFinishedFit> {
        Err(NoFinishedFit::Unknown)
    }
}

/// A fit that has succeeded.
#[derive(Clone, Debug)]
pub struct FinishedFit {
    /// Its garment, complete in itself.
    pub garment: Garment,
    /// The shape that it ended in.
    pub mesh: GarmentMesh,
}

/// The reason why there is no such finished fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFinishedFit {
    /// No fit has the id.
    Unknown,
    /// It has not succeeded; its status in words.
    NotSucceeded(&'static str),
}

/// The shipped fabrics, and nothing stored.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShippedAssets;

impl AssetLibrary for ShippedAssets {
    fn pattern(&self, _id: Uuid) -> Option<Arc<Pattern>> {
        None
    }

    fn body(&self, _id: Uuid) -> Option<BodySource> {
        None
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        scene::library().remove(id)
    }
}
